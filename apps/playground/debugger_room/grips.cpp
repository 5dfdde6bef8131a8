#include "playground/debugger_room/grips.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include <surefoot/pair.hpp>
#include <surefoot/pose.hpp>

#include "debugger/support.hpp"
#include "view/shapes.hpp"

namespace surefoot::playground {
namespace {

using debugger::Question;
using view::Camera;
using view::dvec2;
using view::ivec2;

// Sizes on the picture [window units].
constexpr double corner_size = 9;
constexpr double handle_size = 8;
constexpr double arrow_width = 6;
constexpr double arrow_length = 96;

dvec3 axis_of(int axis) {
    dvec3 direction(0, 0, 0);
    direction[axis] = 1;
    return direction;
}

/// Turns +Y into an axis.
dquat upright_along(int axis) {
    constexpr double half = std::numbers::sqrt2 / 2;
    if (axis == 0) return {half, 0, 0, -half};
    if (axis == 2) return {half, half, 0, 0};
    return {1, 0, 0, 0};
}

double depth_of(const dvec3& place, const Camera& camera) {
    return std::max(glm::dot(place - camera.eye, camera.forward), camera.nearest);
}

/// A ball that is this large on the picture.
Volume ball(const dvec3& place, double units, const Camera& camera, const ivec2& size) {
    return Sphere{std::clamp(units * camera.unit_at(depth_of(place, camera), size), 1e-6, 1e6)};
}

bool is_end(const Target& target) {
    return target.kind != Target::Kind::corner;
}

void add_gizmo(std::vector<Grip>& grips, const Target& target, const Question& question, const Camera& camera,
               const ivec2& size) {
    const dvec3 middle = gizmo_middle(target, question);
    const double unit = camera.unit_at(depth_of(middle, camera), size);
    const Bounds box = is_end(target) ? box_around(target, question) : Bounds{middle, middle};
    for (int axis = 0; axis < 3; ++axis) {
        // Out of the shape, so that its arrows can be seen, and long enough on the picture to be taken hold of.
        const double length = std::max(arrow_length * unit, (box.max[axis] - middle[axis]) + arrow_length * 0.5 * unit);
        Grip grip{.kind = Grip::Kind::arrow, .target = target, .axis = axis};
        grip.handle = middle + length * axis_of(axis);
        const double radius = std::clamp(arrow_width * unit, 1e-6, 1e6);
        grip.volume = Volume(Capsule{radius, std::clamp(length * 0.32, 1e-6, 1e6)}, upright_along(axis));
        grip.place = middle + length * 0.66 * axis_of(axis);  // near the middle there are other things to grab
        grips.push_back(grip);
    }
}

void add_handles(std::vector<Grip>& grips, const Target& target, const Question& question, const Camera& camera,
                 const ivec2& size) {
    const Bounds box = box_around(target, question);
    const dvec3 middle = (box.min + box.max) * 0.5;
    for (int axis = 0; axis < 3; ++axis) {
        for (const double towards : {-1.0, 1.0}) {
            Grip grip{.kind = Grip::Kind::face, .target = target, .axis = axis, .towards = towards};
            grip.handle = middle;
            grip.handle[axis] = towards < 0 ? box.min[axis] : box.max[axis];
            grip.place = grip.handle;
            grip.volume = ball(grip.place, handle_size, camera, size);
            grips.push_back(grip);
        }
    }
}

/// Where a ray meets a plane, in front of the eye.
std::optional<dvec3> on_plane(const dvec3& eye, const dvec3& direction, const dvec3& point, const dvec3& normal) {
    const double approach = glm::dot(direction, normal);
    constexpr double too_slanting = 0.02;  // a pixel more would be metres
    if (std::abs(approach) < too_slanting) return std::nullopt;
    const double far = glm::dot(point - eye, normal) / approach;
    if (!(far > 0)) return std::nullopt;
    return eye + far * direction;
}

/// The point of a line that is nearest to a ray.
std::optional<dvec3> on_line(const dvec3& eye, const dvec3& direction, const dvec3& point, const dvec3& axis) {
    const double along = glm::dot(direction, axis);
    const double apart = 1 - along * along;
    constexpr double too_parallel = 1e-3;
    if (apart < too_parallel) return std::nullopt;
    const dvec3 to = point - eye;
    return point + axis * ((along * glm::dot(direction, to) - glm::dot(axis, to)) / apart);
}

}  // namespace

dvec3 place_of(const Target& target, const Question& question) {
    switch (target.kind) {
        case Target::Kind::start:
            return question.motion.from;
        case Target::Kind::end:
            return question.motion.to;
        case Target::Kind::corner:
            break;
    }
    return debugger::corners_of(question.triangles[target.triangle])[target.corner];
}

debugger::Edit moved_to(const Target& target, const dvec3& place) {
    if (target.kind == Target::Kind::start) return debugger::MoveStart{place};
    if (target.kind == Target::Kind::end) return debugger::MoveEnd{place};
    return debugger::MoveCorner{.triangle = target.triangle, .corner = target.corner, .to = place};
}

Bounds box_around(const Target& target, const Question& question) {
    Bounds box = debugger::bounds_of(question.volume(), place_of(target, question));
    const dvec3 room = (box.max - box.min) * 0.06;
    return {box.min - room, box.max + room};
}

dvec3 gizmo_middle(const Target& target, const Question& question) {
    const dvec3 place = place_of(target, question);
    if (!is_end(target)) return place;
    const Volume volume = question.volume();
    return place + to_world({.orientation = volume.orientation}, view::middle_of(volume.shape));
}

std::vector<Grip> grips_of(const Question& question, const std::optional<Target>& selected, const Camera& camera,
                           const ivec2& size) {
    std::vector<Grip> grips;
    const Volume volume = question.volume();
    if (is_valid(volume)) {
        for (const auto kind : {Target::Kind::start, Target::Kind::end}) {
            const Target target{.kind = kind};
            const dvec3 place = place_of(target, question);
            grips.push_back(
                {.kind = Grip::Kind::body, .target = target, .volume = volume, .place = place, .handle = place});
        }
    }
    for (std::size_t i = 0; i < question.triangles.size(); ++i) {
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const Target target{Target::Kind::corner, i, corner};
            const dvec3 place = place_of(target, question);
            grips.push_back({.kind = Grip::Kind::corner,
                             .target = target,
                             .volume = ball(place, corner_size, camera, size),
                             .place = place,
                             .handle = place});
        }
    }
    if (selected && (!is_end(*selected) || is_valid(volume))) {
        add_gizmo(grips, *selected, question, camera, size);
        if (is_end(*selected)) add_handles(grips, *selected, question, camera, size);
    }
    return grips;
}

std::optional<Grabbed> grab(std::span<const Grip> grips, const Camera& camera, const dvec2& at, const ivec2& size) {
    std::optional<Grabbed> best;
    double best_far = 0;
    const dvec3 direction = camera.direction(at, size);
    for (const Grip& grip : grips) {
        if (best && grip.kind < best->grip.kind) continue;
        const double reach = view::reach_of(grip.volume.shape);
        const double length = glm::length(grip.place - camera.eye) + 2 * reach;
        // A pointer that is a pixel wide.
        const Volume pointer = ball(grip.place, 0.5, camera, size);
        const Motion ray{camera.eye, camera.eye + length * direction};
        const auto hit = pair_sweep(pointer, ray, grip.volume, grip.place);
        if (!hit || hit->status != HitStatus::ok || hit->started_inside) continue;
        const double far = hit->t * length;
        if (best && grip.kind == best->grip.kind && far >= best_far) continue;
        best = Grabbed{grip, camera.eye + far * direction};
        best_far = far;
    }
    return best;
}

std::optional<dvec3> Drag::to(const Camera& camera, const dvec2& at, const ivec2& size, double grid) const {
    const Grip& grip = grabbed_.grip;
    const dvec3 direction = camera.direction(at, size);
    const dvec3 axis = axis_of(grip.axis);
    std::optional<dvec3> hand;
    dvec3 held = grabbed_.at;
    if (grip.kind == Grip::Kind::arrow) {
        // Along the line through the arrow; what was taken hold of is the point of it under the pointer.
        const dvec3 eye_to_grab = glm::normalize(grabbed_.at - camera.eye);
        const auto grabbed = on_line(camera.eye, eye_to_grab, grip.place, axis);
        if (!grabbed) return std::nullopt;
        held = *grabbed;
        hand = on_line(camera.eye, direction, grip.place, axis);
    } else {
        hand = on_plane(camera.eye, direction, held, grip.kind == Grip::Kind::face ? axis : camera.forward);
    }
    if (!hand) return std::nullopt;
    dvec3 place = began_ + (*hand - held);
    const dvec3 on_grid = debugger::snapped(place, grid);
    for (int i = 0; i < 3; ++i) {
        const bool moves = grip.kind == Grip::Kind::arrow  ? i == grip.axis
                           : grip.kind == Grip::Kind::face ? i != grip.axis
                                                           : true;
        place[i] = moves ? on_grid[i] : began_[i];
    }
    return place;
}

}  // namespace surefoot::playground
