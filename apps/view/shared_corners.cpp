#include "view/shared_corners.hpp"

#include <bit>

namespace surefoot::view {
namespace {

// At one place: the hub of a fan of thousands would take long.
constexpr int most_looked_at = 8;

bool same(Colour a, Colour b) {
    return a.r == b.r && a.g == b.g && a.b == b.b && a.a == b.a;
}

}  // namespace

std::size_t SharedCorners::PlaceHash::operator()(const Place& place) const {
    std::uint64_t sum = 0;
    for (const std::uint32_t part : place) {
        sum = (sum ^ part) * 0x9E3779B97F4A7C15U;
        sum ^= sum >> 29U;
    }
    return static_cast<std::size_t>(sum);
}

SharedCorners::Place SharedCorners::place_of(const Corner& corner) const {
    const auto bits = [](float x) { return std::bit_cast<std::uint32_t>(x); };
    return {bits(corner.position.x), bits(corner.position.y), bits(corner.position.z),
            flat_ ? 0 : std::bit_cast<std::uint32_t>(corner.normal)};
}

std::uint32_t SharedCorners::newest_at(const Corner& corner) const {
    const auto found = newest_at_.find(place_of(corner));
    return found == newest_at_.end() ? none : found->second;
}

std::uint32_t SharedCorners::make(const Corner& corner, Colour colour) {
    const auto vertex = static_cast<std::uint32_t>(vertices_.size());
    std::uint32_t& newest = newest_at_.try_emplace(place_of(corner), none).first->second;
    vertices_.push_back({corner.position, corner.normal, colour});
    older_.push_back(newest);
    is_last_.push_back(0);
    newest = vertex;
    return vertex;
}

std::uint32_t SharedCorners::find_last(const Corner& corner, Colour colour, bool alike) const {
    std::uint32_t v = newest_at(corner);
    for (int looked_at = 0; v != none && looked_at < most_looked_at; v = older_[v], ++looked_at) {
        if (!alike && is_last_[v] == 0) return v;
        if (alike && is_last_[v] != 0 && same(vertices_[v].colour, colour) &&
            (!flat_ || vertices_[v].normal == corner.normal))
            return v;
    }
    return none;
}

void SharedCorners::add(const Face& face) {
    std::size_t last = 2;
    std::uint32_t vertex = none;
    for (const bool alike : {true, false}) {
        for (std::size_t k = 0; k < 3 && vertex == none; ++k) {
            vertex = find_last(face.corners[k], face.colour, alike);
            if (vertex != none) last = k;
        }
    }
    if (vertex == none) vertex = make(face.corners[last], face.colour);
    is_last_[vertex] = 1;
    vertices_[vertex].normal = face.corners[last].normal;
    vertices_[vertex].colour = face.colour;
    for (const std::size_t k : {(last + 1) % 3, (last + 2) % 3}) {
        const std::uint32_t at_corner = newest_at(face.corners[k]);
        indices_.push_back(at_corner != none ? at_corner : make(face.corners[k], face.colour));
    }
    indices_.push_back(vertex);
}

}  // namespace surefoot::view
