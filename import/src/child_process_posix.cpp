#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

#include "child_process.hpp"

extern char** environ;

namespace surefoot::internal {
namespace {

using Clock = std::chrono::steady_clock;

class FileDescriptor {
public:
    explicit FileDescriptor(int fd) : fd_(fd) {}
    FileDescriptor(const FileDescriptor&) = delete;
    FileDescriptor& operator=(const FileDescriptor&) = delete;
    ~FileDescriptor() { close(); }

    [[nodiscard]] int get() const { return fd_; }
    void close() {
        if (fd_ >= 0) ::close(fd_);
        fd_ = -1;
    }

private:
    int fd_;
};

class SpawnActions {
public:
    explicit SpawnActions(int output) {
        posix_spawn_file_actions_init(&files_);
        posix_spawn_file_actions_addopen(&files_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
        posix_spawn_file_actions_adddup2(&files_, output, STDOUT_FILENO);
        posix_spawn_file_actions_addopen(&files_, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
        posix_spawnattr_init(&attributes_);
        sigset_t none;
        sigset_t all;
        sigemptyset(&none);
        sigfillset(&all);
        posix_spawnattr_setsigmask(&attributes_, &none);
        posix_spawnattr_setsigdefault(&attributes_, &all);
        posix_spawnattr_setpgroup(&attributes_, 0);
        posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETPGROUP);
    }
    SpawnActions(const SpawnActions&) = delete;
    SpawnActions& operator=(const SpawnActions&) = delete;
    ~SpawnActions() {
        posix_spawnattr_destroy(&attributes_);
        posix_spawn_file_actions_destroy(&files_);
    }

    [[nodiscard]] int spawn(pid_t& child, const std::string& program, const std::vector<std::string>& arguments) const {
        std::vector<char*> argv;
        argv.push_back(const_cast<char*>(program.c_str()));
        for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
        argv.push_back(nullptr);
        return posix_spawn(&child, program.c_str(), &files_, &attributes_, argv.data(), environ);
    }

private:
    posix_spawn_file_actions_t files_;
    posix_spawnattr_t attributes_;
};

/// Collects until the end of the output. False when something was exceeded, which is then in `outcome.end`.
bool collect(int fd, Deadline deadline, std::uint64_t most_output, ChildOutcome& outcome) {
    std::array<std::byte, 65536> chunk{};
    for (;;) {
        const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now()).count();
        if (left <= 0) {
            outcome.end = ChildOutcome::End::timed_out;
            return false;
        }
        pollfd waiting{.fd = fd, .events = POLLIN, .revents = 0};
        const int ready = poll(&waiting, 1, static_cast<int>(std::min<long long>(left, 60'000)));
        if (ready == 0 || (ready < 0 && errno == EINTR)) continue;
        const ssize_t got = read(fd, chunk.data(), chunk.size());
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) return true;
        if (outcome.output.size() + static_cast<std::size_t>(got) > most_output) {
            outcome.end = ChildOutcome::End::too_talkative;
            return false;
        }
        outcome.output.insert(outcome.output.end(), chunk.begin(), chunk.begin() + got);
    }
}

/// Waits for the end of a child that has closed its output, and may hang all the same.
void await_end(pid_t child, Deadline deadline, ChildOutcome& outcome) {
    int status = 0;
    auto pause = std::chrono::microseconds(100);
    for (;;) {
        const pid_t ended = waitpid(child, &status, WNOHANG);
        if (ended == child) break;
        if (ended < 0 && errno != EINTR) return;
        if (Clock::now() > deadline) {
            outcome.end = ChildOutcome::End::timed_out;
            return;
        }
        std::this_thread::sleep_for(pause);
        pause = std::min(pause * 2, std::chrono::microseconds(20'000));
    }
    if (WIFSIGNALED(status)) {
        outcome.end = ChildOutcome::End::killed;
        outcome.signal = WTERMSIG(status);
    } else {
        outcome.exit_code = WEXITSTATUS(status);
    }
}

void end_group(pid_t child) {
    kill(-child, SIGKILL);
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
}

}  // namespace

Expected<ChildOutcome> run_child(const std::string& program, const std::vector<std::string>& arguments,
                                 Deadline deadline, std::uint64_t most_output) {
    const auto failed = [&](const char* what, int error) {
        return tl::unexpected(Error{
            .code = ErrorCode::unsupported,
            .text = "the program " + program + " could not be started (" + what + ": " + std::strerror(error) + ")",
            .file = {}});
    };
    std::array<int, 2> ends{};
    if (pipe2(ends.data(), O_CLOEXEC) != 0) return failed("pipe", errno);
    FileDescriptor from_child(ends[0]);
    FileDescriptor to_parent(ends[1]);

    pid_t child = 0;
    const int error = SpawnActions(to_parent.get()).spawn(child, program, arguments);
    to_parent.close();
    if (error != 0) return failed("spawn", error);

    ChildOutcome outcome;
    try {
        if (collect(from_child.get(), deadline, most_output, outcome)) await_end(child, deadline, outcome);
    } catch (...) {
        end_group(child);
        throw;
    }
    if (outcome.end == ChildOutcome::End::timed_out || outcome.end == ChildOutcome::End::too_talkative)
        end_group(child);
    return outcome;
}

std::string signal_name(int signal) {
    const char* const name = strsignal(signal);
    return name != nullptr ? name : "signal " + std::to_string(signal);
}

}  // namespace surefoot::internal
