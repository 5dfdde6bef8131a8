#include "course/mover.hpp"
#include "course/protocol.hpp"

#if __has_include(<sys/socket.h>)
#include <cerrno>
#include <csignal>
#include <cstring>
#include <poll.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>
#endif

namespace surefoot::course {

#if __has_include(<sys/socket.h>)

namespace {

constexpr int patience_ms = 60'000;

// A program at the other end of a socket, which is both its standard input and its standard output.
class Program {
public:
    explicit Program(const std::string& command) {
        int ends[2];
        if (socketpair(AF_UNIX, SOCK_STREAM, 0, ends) != 0) throw MoverFailure{std::strerror(errno)};
        pid_ = fork();
        if (pid_ < 0) throw MoverFailure{std::strerror(errno)};
        if (pid_ == 0) {
            setpgid(0, 0);  // so that whatever the shell starts can be ended with it
            dup2(ends[1], STDIN_FILENO);
            dup2(ends[1], STDOUT_FILENO);
            close(ends[0]);
            close(ends[1]);
            execl("/bin/sh", "sh", "-c", command.c_str(), static_cast<char*>(nullptr));
            _exit(127);
        }
        setpgid(pid_, pid_);
        close(ends[1]);
        socket_ = ends[0];
    }

    Program(const Program&) = delete;
    Program& operator=(const Program&) = delete;

    ~Program() {
        close(socket_);
        // The end of its input tells it to end. One that does not listen is ended.
        for (int i = 0; i < 50; ++i) {
            if (waitpid(pid_, nullptr, WNOHANG) == pid_) return;
            poll(nullptr, 0, 20);
        }
        kill(-pid_, SIGKILL);
        waitpid(pid_, nullptr, 0);
    }

    void write(std::string_view text) {
        while (!text.empty()) {
            const ssize_t sent = send(socket_, text.data(), text.size(), MSG_NOSIGNAL);
            if (sent < 0 && errno == EINTR) continue;
            if (sent <= 0) throw MoverFailure{"the program has ended"};
            text.remove_prefix(static_cast<std::size_t>(sent));
        }
    }

    /// The next line, without its end.
    std::string read_line() {
        for (;;) {
            if (const std::size_t end = unread_.find('\n'); end != std::string::npos) {
                std::string line = unread_.substr(0, end);
                unread_.erase(0, end + 1);
                if (line.ends_with('\r')) line.pop_back();
                return line;
            }
            pollfd waiting{socket_, POLLIN, 0};
            if (poll(&waiting, 1, patience_ms) == 0) throw MoverFailure{"the program has not answered for a minute"};
            char room[4096];
            const ssize_t got = recv(socket_, room, sizeof room, 0);
            if (got < 0 && errno == EINTR) continue;
            if (got <= 0) throw MoverFailure{"the program has ended"};
            unread_.append(room, static_cast<std::size_t>(got));
        }
    }

private:
    pid_t pid_ = -1;
    int socket_ = -1;
    std::string unread_;
};

class External final : public Mover {
public:
    explicit External(const std::string& command) : program_(command) {
        program_.write(std::string(protocol::greeting) + "\n");
        expect(protocol::greeting);
    }

    void load(const Run& run) override {
        run_ = &run;
        program_.write(protocol::text_of(run));
        expect(protocol::ready);
    }

    Answer tick(const Input& input, double dt, std::span<const Pose> poses) override {
        program_.write(protocol::text_of(*run_->level, input, dt, poses));
        const std::string line = program_.read_line();
        const auto answer = protocol::answer_of(line);
        if (!answer) throw MoverFailure{"the program said '" + line + "' where 'at X Y Z GROUNDED' was expected"};
        return *answer;
    }

private:
    void expect(std::string_view wanted) {
        const std::string line = program_.read_line();
        if (line != wanted)
            throw MoverFailure{"the program said '" + line + "' where '" + std::string(wanted) + "' was expected"};
    }

    Program program_;
    const Run* run_ = nullptr;
};

}  // namespace

std::unique_ptr<Mover> make_external_mover(const std::string& command) {
    return std::make_unique<External>(command);
}

#else

std::unique_ptr<Mover> make_external_mover(const std::string& /*command*/) {
    throw MoverFailure{"programs can be started on POSIX systems only"};
}

#endif

}  // namespace surefoot::course
