/// A bar on the terminal while something takes long.
#pragma once

#include <chrono>
#include <string>

namespace surefoot::tools {

/// Draws on standard error if that is a terminal, and only once it has taken a while; wiped when it is destroyed.
class ProgressBar {
public:
    explicit ProgressBar(std::string what);
    ~ProgressBar();
    ProgressBar(const ProgressBar&) = delete;
    ProgressBar& operator=(const ProgressBar&) = delete;

    void show(double done);  ///< [0 to 1]

private:
    std::string what_;
    std::chrono::steady_clock::time_point start_;
    bool terminal_;
    int drawn_ = -1;  ///< per cent
};

}  // namespace surefoot::tools
