#include "playground/navigation/target.hpp"

#include <surefoot/hitboxes.hpp>

namespace surefoot::playground {
namespace {

constexpr double sight = 5000;  // [m]

}  // namespace

NavigationTarget::NavigationTarget(const NavigationScene& scene) : scene_(&scene) {
    const NavigationAgent& agent = scene.mesh.agent();
    shape_ = Ellipsoid{{agent.radius, agent.height / 2, agent.radius}};
}

dvec3 NavigationTarget::middle() const {
    return feet_ + scene_->up() * shape_.radii.y;
}

std::optional<dvec3> NavigationTarget::place_under(const view::dvec2& at, const Eye& eye) const {
    const auto hit = scene_->world.ray(eye.camera.ray(at, eye.size, sight));
    return hit && hit->status == HitStatus::ok ? std::optional(hit->point) : std::nullopt;
}

bool NavigationTarget::is_under(const view::dvec2& at, const Eye& eye) const {
    const Motion look = eye.camera.ray(at, eye.size, sight);
    const HitPart part{.volume = shape_};
    const auto hit = Hitboxes({&part, 1}, Pose{.position = middle()}).ray(look);
    if (!hit || hit->status != HitStatus::ok) return false;
    const auto wall = scene_->world.ray(look);
    return !wall || wall->t >= hit->t;
}

bool NavigationTarget::grab(const view::dvec2& at, const Eye& eye) {
    if (!is_under(at, eye)) return false;
    const auto feet = eye.camera.project(feet_, eye.size);
    held_ = feet ? feet->at - at : view::dvec2(0);
    return true;
}

bool NavigationTarget::drag(const view::dvec2& at, const Eye& eye) {
    if (!held_) return false;
    const auto place = place_under(at + *held_, eye);
    if (place) feet_ = *place;
    return place.has_value();
}

}  // namespace surefoot::playground
