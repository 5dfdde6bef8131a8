#include "progress.hpp"

#include <cstdio>
#include <fmt/format.h>
#include <utility>
#if __has_include(<unistd.h>)
#include <unistd.h>
#endif

namespace surefoot::tools {
namespace {

bool is_terminal([[maybe_unused]] std::FILE* file) {
#if __has_include(<unistd.h>)
    return isatty(fileno(file)) != 0;
#else
    return false;
#endif
}

}  // namespace

ProgressBar::ProgressBar(std::string what)
    : what_(std::move(what)), start_(std::chrono::steady_clock::now()), terminal_(is_terminal(stderr)) {}

ProgressBar::~ProgressBar() {
    if (drawn_ >= 0) fmt::print(stderr, "\r\033[K");
}

void ProgressBar::show(double done) {
    // What is done at once needs no bar.
    constexpr auto patience = std::chrono::milliseconds(200);
    const int percent = static_cast<int>(100 * done);
    if (!terminal_ || percent == drawn_ || std::chrono::steady_clock::now() - start_ < patience) return;
    drawn_ = percent;
    constexpr int width = 30;
    const int filled = width * percent / 100;
    fmt::print(stderr, "\r{} [{:#<{}}{:.<{}}] {:3} %", what_, "", filled, "", width - filled, percent);
    std::fflush(stderr);
}

}  // namespace surefoot::tools
