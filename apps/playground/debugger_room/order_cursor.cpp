#include "playground/debugger_room/order_cursor.hpp"

#include <algorithm>
#include <cmath>

namespace surefoot::playground {

void OrderCursor::restart(std::size_t count) {
    count_ = shown_ = count;
    owed_ = 0;
    playing_ = false;
}

void OrderCursor::show(std::size_t shown) {
    shown_ = std::min(shown, count_);
    playing_ = false;
}

void OrderCursor::play() {
    if (count_ == 0) return;
    if (shown_ == count_) shown_ = 0;
    owed_ = 0;
    playing_ = true;
}

bool OrderCursor::advance(double dt) {
    constexpr double slowest = 6;
    constexpr double longest = 10;
    if (!playing_) return false;
    owed_ += dt * std::max(slowest, static_cast<double>(count_) / longest);
    const double whole = std::floor(owed_);
    owed_ -= whole;
    shown_ = std::min(count_, shown_ + static_cast<std::size_t>(whole));
    if (shown_ == count_) playing_ = false;
    return true;
}

}  // namespace surefoot::playground
