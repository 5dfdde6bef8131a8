#include "crowd/order.hpp"

#include "sweep/query.hpp"

namespace surefoot::internal {

bool NearestFirst::is_before(const Neighbour& a, const Neighbour& b) const noexcept {
    const Vec to_a = to_vec(a.position) - from_;
    const Vec to_b = to_vec(b.position) - from_;
    const double size_a = size_of(a.volume.shape);
    const double size_b = size_of(b.volume.shape);
    // What is large is met from farther away.
    const double far_a = size_a == size_b ? dot(to_a, to_a) : length(to_a) - size_a;
    const double far_b = size_a == size_b ? dot(to_b, to_b) : length(to_b) - size_b;
    if (far_a != far_b) return far_a < far_b;
    for (const auto part : {&Neighbour::position, &Neighbour::velocity}) {
        const Vec of_a = to_vec(a.*part);
        const Vec of_b = to_vec(b.*part);
        if (!(of_a == of_b)) return lexicographically_less(of_a, of_b);
    }
    return a.id < b.id;
}

void NearestFirst::offer(const Neighbour& neighbour) noexcept {
    std::size_t place = count_ < room_.size() ? count_ : room_.size();
    const std::size_t last = place;
    ++count_;
    while (place > 0 && is_before(neighbour, room_[place - 1])) --place;
    if (place == room_.size()) return;
    for (std::size_t i = last < room_.size() ? last : room_.size() - 1; i > place; --i) room_[i] = room_[i - 1];
    room_[place] = neighbour;
}

}  // namespace surefoot::internal
