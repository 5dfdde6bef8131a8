#include "character/touches.hpp"

#include <algorithm>
#include <bitset>

#include "character/surroundings.hpp"

namespace surefoot::internal {

static_assert(Touches::most_pending >= Surroundings::most);

Touches::Rank Touches::rank_of(const Touch& touch) const noexcept {
    if (touch.is_neighbour) return {touch.t, true, 0, static_cast<std::uint32_t>(touch.index)};
    const SourceTriangle& triangle = surroundings_->triangle(touch.index);
    return {touch.t, false, triangle.body, triangle.id};
}

bool Touches::comes_before(const Rank& a, const Rank& b) noexcept {
    if (a.t != b.t) return a.t < b.t;
    if (a.is_neighbour != b.is_neighbour) return b.is_neighbour;
    return a.body != b.body ? a.body < b.body : a.number < b.number;
}

bool Touches::is_before(const Touch& a, const Touch& b) const noexcept {
    return a.t != b.t ? a.t < b.t : comes_before(rank_of(a), rank_of(b));
}

bool Touches::turn_page() noexcept {
    if (!lost_some_) return false;
    page_ends_ = rank_of(touches_[most - 1]);
    return true;
}

void Touches::begin(const Surroundings& surroundings, const Volume& volume, const Motion& motion) noexcept {
    surroundings_ = &surroundings;
    volume_ = volume;
    motion_ = motion;
    count_ = 0;
    given_ = 0;
    pending_count_ = 0;
    lost_some_ = false;
    after_ = page_ends_;
    page_ends_.reset();
    is_heap_ = true;
}

void Touches::put_off(std::size_t index, double earliest) noexcept {
    pending_[pending_count_++] = {earliest, static_cast<std::uint32_t>(index)};
    is_heap_ = false;
}

void Touches::add(const Touch& touch) noexcept {
    if (after_ && !comes_before(*after_, rank_of(touch))) return;
    std::size_t place = count_;
    while (place > given_ && is_before(touch, touches_[place - 1])) --place;
    if (count_ == most) lost_some_ = true;
    if (place == most) return;
    if (count_ < most) ++count_;
    for (std::size_t i = count_ - 1; i > place; --i) touches_[i] = touches_[i - 1];
    touches_[place] = touch;
}

std::size_t Touches::spare_index() const noexcept {
    std::bitset<most + 1> used;
    for (std::size_t i = 0; i < count_; ++i) used.set(touches_[i].index);
    std::size_t index = 0;
    while (used[index]) ++index;
    return index;
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
