#include "character/touches.hpp"

#include <algorithm>

#include "character/surroundings.hpp"

namespace surefoot::internal {

static_assert(Touches::most_pending >= Surroundings::most);

namespace {

bool is_before(const Touch& a, const Touch& b) noexcept {
    return a.t != b.t ? a.t < b.t : a.index < b.index;
}

}  // namespace

void Touches::begin(const Surroundings& surroundings, const Volume& volume, const Motion& motion) noexcept {
    surroundings_ = &surroundings;
    volume_ = volume;
    motion_ = motion;
    count_ = 0;
    given_ = 0;
    pending_count_ = 0;
    is_heap_ = true;
}

void Touches::put_off(std::size_t index, double earliest) noexcept {
    pending_[pending_count_++] = {earliest, static_cast<std::uint32_t>(index)};
    is_heap_ = false;
}

void Touches::add(const Touch& touch) noexcept {
    std::size_t place = count_;
    while (place > given_ && is_before(touch, touches_[place - 1])) --place;
    if (place == most) return;
    if (count_ < most) ++count_;
    for (std::size_t i = count_ - 1; i > place; --i) touches_[i] = touches_[i - 1];
    touches_[place] = touch;
}

const Touch* Touches::at(std::size_t place, double until) noexcept {
    order_pending();
    // One that is as early as a pending one may be second to it.
    while (pending_count_ > 0 && pending_[0].earliest <= (place < count_ ? touches_[place].t : until)) ask_earliest();
    if (place >= count_) return nullptr;
    given_ = place + 1;
    return &touches_[place];
}

void Touches::order_pending() noexcept {
    if (is_heap_) return;
    std::make_heap(pending_.data(), pending_.data() + pending_count_, comes_later);
    is_heap_ = true;
}

void Touches::ask_earliest() noexcept {
    std::pop_heap(pending_.data(), pending_.data() + pending_count_, comes_later);
    surroundings_->ask(pending_[--pending_count_].index, volume_, motion_, *this);
}

}  // namespace surefoot::internal
