#include <string>

#include "course/mover.hpp"
#include "course/protocol.hpp"

#if __has_include(<sys/socket.h>)
#include <cerrno>
#include <cmath>
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

// A program at the other end of a socket, which is both its standard input and its standard output.
class Program {
public:
    Program(const std::string& command, double patience) : patience_(patience) {
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
        if (pid_ < 0) return;
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
            if (sent <= 0) throw MoverFailure{how_it_ended()};
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
            const int answers = poll(&waiting, 1, static_cast<int>(patience_ * 1000));
            if (answers < 0 && errno == EINTR) continue;
            if (answers == 0)
                throw MoverFailure{"the program has not answered for " + std::to_string(std::lround(patience_)) +
                                   " seconds"};
            char room[4096];
            const ssize_t got = recv(socket_, room, sizeof room, 0);
            if (got < 0 && errno == EINTR) continue;
            if (got <= 0) throw MoverFailure{how_it_ended()};
            unread_.append(room, static_cast<std::size_t>(got));
        }
    }

private:
    /// For whoever finds the other end gone. A moment later the shell tells what has become of it.
    std::string how_it_ended() {
        std::string text = "the program has ended";
        int status = 0;
        pid_t ended = 0;
        for (int i = 0; i < 25 && ended == 0; ++i) {
            ended = waitpid(pid_, &status, WNOHANG);
            if (ended == 0) poll(nullptr, 0, 20);
        }
        if (ended != pid_) return text;
        pid_ = -1;
        if (WIFSIGNALED(status)) return text + ": by signal " + std::to_string(WTERMSIG(status));
        const int code = WEXITSTATUS(status);
        if (code == 126 || code == 127) return text + ": the shell could not start it";
        return code == 0 ? text : text + ", with exit code " + std::to_string(code);
    }

    double patience_;
    pid_t pid_ = -1;
    int socket_ = -1;
    std::string unread_;
};

class External final : public Mover {
public:
    External(const std::string& command, double patience) : program_(command, patience) {
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

std::unique_ptr<Mover> make_external_mover(const std::string& command, double patience) {
    return std::make_unique<External>(command, patience);
}

#else

std::unique_ptr<Mover> make_external_mover(const std::string& /*command*/, double /*patience*/) {
    throw MoverFailure{"programs can be started on POSIX systems only"};
}

#endif

}  // namespace surefoot::course
