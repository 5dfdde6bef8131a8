#include "limits.hpp"

#include <algorithm>
#include <sys/resource.h>
#include <unistd.h>

#if defined(__linux__)
#include <signal.h>
#include <sys/prctl.h>
#endif

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define SUREFOOT_SANITIZED 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer) || __has_feature(memory_sanitizer)
#define SUREFOOT_SANITIZED 1
#endif
#endif

namespace surefoot::importer {
namespace {

void lower_limit(int resource, std::uint64_t value) {
    rlimit limit{};
    if (getrlimit(static_cast<__rlimit_resource_t>(resource), &limit) != 0) return;
    limit.rlim_cur = std::min<rlim_t>(value, limit.rlim_max);
    limit.rlim_max = limit.rlim_cur;
    setrlimit(static_cast<__rlimit_resource_t>(resource), &limit);
}

}  // namespace

void harden_process() {
    lower_limit(RLIMIT_CORE, 0);
#if defined(__linux__)
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
#endif
    const long most = std::clamp(sysconf(_SC_OPEN_MAX), 3L, 4096L);
    for (int fd = 3; fd < most; ++fd) ::close(fd);
}

void limit_memory([[maybe_unused]] std::uint64_t bytes) {
#if !defined(SUREFOOT_SANITIZED)
    lower_limit(RLIMIT_AS, bytes);
#endif
}

void limit_time(std::uint64_t seconds) {
    lower_limit(RLIMIT_CPU, seconds);
}

}  // namespace surefoot::importer
