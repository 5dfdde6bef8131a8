#include "playground/debugger_room/framing.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "view/shapes.hpp"
#include "view/widgets.hpp"

namespace surefoot::playground {
namespace {

constexpr view::dvec2 air{34, 40};  // around what is seen, for labels: at the sides, above and below
constexpr double hardly = 6;        // by how much a part has to differ to be another
constexpr int young = 5;            // [ticks]

view::Area free_part(const view::ivec2& size) {
    view::Area part = view::ui::uncovered(size);
    const view::dvec2 inset = glm::min(air, part.size() * 0.2);
    return {part.low + inset, part.high - inset};
}

bool differ(const view::dvec2& a, const view::dvec2& b) {
    return std::max(std::abs(a.x - b.x), std::abs(a.y - b.y)) > hardly;
}

}  // namespace

void Framing::show(std::vector<dvec3> places, const view::ivec2& size) {
    kept_ = std::move(places);
    part_ = free_part(size);
    orbit_->frame(kept_, part_, size);
}

void Framing::look_along(const dvec3& way) {
    constexpr double beside = 0.75;  // [rad]
    if (way.x == 0 && way.z == 0) return;
    auto stand = orbit_->goal();
    const auto [first, second] = view::across({0, 1, 0});
    stand.yaw = std::atan2(-glm::dot(way, second), -glm::dot(way, first)) + beside;
    stand.pitch = 0.34;
    orbit_->go_to(stand);
}

view::OrbitCamera::Stand Framing::depart() {
    if (!before_) before_.emplace(orbit_->goal(), kept_);
    return before_->first;
}

void Framing::come_back() {
    if (!before_) return;
    orbit_->go_to(before_->first);
    keep(std::move(before_->second));
    before_.reset();
}

void Framing::update(const view::ivec2& size) {
    age_ = std::min(age_ + 1, young);
    const view::Area part = free_part(size);
    if (!differ(part.low, part_.low) && !differ(part.high, part_.high)) return;
    part_ = part;
    if (kept_.empty())
        orbit_->keep_pivot_in(part_, size);
    else
        orbit_->frame(kept_, part_, size);
    // Before anybody has seen it, there is nothing to follow with the eyes.
    if (age_ < young) orbit_->arrive();
}

void append_corners(std::vector<dvec3>& places, const Bounds& box) {
    for (const double x : {box.min.x, box.max.x})
        for (const double y : {box.min.y, box.max.y})
            for (const double z : {box.min.z, box.max.z}) places.emplace_back(x, y, z);
}

}  // namespace surefoot::playground
