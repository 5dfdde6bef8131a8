/// What is wrong with a camera, counted: it looks on at every tick of a run and needs no picture.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>
#include <string>

#include "platformer/camera/game_camera.hpp"
#include "platformer/camera/sight.hpp"

namespace surefoot::platformer::tests {

class CameraWatch {
public:
    /// Ticks, but for what says otherwise.
    struct Found {
        int ticks = 0;
        int inside = 0;      ///< the ball of the eye touches something
        int outside = 0;     ///< less than half of the hero is in the picture, which is as high as 3/4 of its width
        int hidden = 0;      ///< or something solid stands before more than half of it
        int hidden_for = 0;  ///< the most of these two one after the other
        int unseen = 0;      ///< something does, be it solid or leaves, that is not drawn as a screen door; or it is
                             ///< outside
        int near = 0;        ///< the eye is within a metre of the hero
        int cuts = 0;        ///< the eye moves by more than 0.5 m, relative to the hero, or turns by more than 0.15
        double fastest = 0;  ///< the farthest it moved in one tick, relative to the hero [m]
        double fastest_turn = 0;  ///< and the most it turned [rad]

        void add(const Found& other) {
            ticks += other.ticks;
            inside += other.inside;
            outside += other.outside;
            hidden += other.hidden;
            hidden_for = std::max(hidden_for, other.hidden_for);
            unseen += other.unseen;
            near += other.near;
            cuts += other.cuts;
            fastest = std::max(fastest, other.fastest);
            fastest_turn = std::max(fastest_turn, other.fastest_turn);
        }
        [[nodiscard]] double share(int count) const { return double(count) / std::max(ticks, 1); }
    };

    /// `before` and `after` are the states at the ends of a tick in which the hero moved to where `target` says.
    void tick(const CameraScene& scene, const CameraTarget& target, const CameraState& before,
              const CameraState& after) {
        const view::Camera last = camera_between(before, before, 1);
        const view::Camera now = camera_between(after, after, 1);
        const bool was_put = glm::length(target.position - before.target) > 2;
        const auto is_solid = [&](std::uint32_t, std::uint32_t, std::uint32_t surface) {
            return !scene.surfaces[surface].one_way;
        };
        const WorldQuery at_end{.begin = 1, .end = 1};
        std::array<Overlap, 4> room;
        const dvec3 feet = target.position - dvec3(0, target.half_height, 0);
        ++found_.ticks;
        if (scene.world.overlap(Sphere{eye_radius}, now.eye, room, {.triangles = is_solid, .begin = 1, .end = 1}) > 0)
            ++found_.inside;
        int within = 0;
        int seen = 0;
        int shown = 0;
        for (const dvec3& point : body_points(target, now.eye)) {
            const auto at = now.project(point, picture);
            const bool is_within = at && at->at.x > 0 && at->at.y > 0 && at->at.x < picture.x && at->at.y < picture.y;
            within += is_within ? 1 : 0;
            if (!is_within) continue;
            const bool is_seen = !scene.world.ray_any({now.eye, point}, at_end);
            const bool is_bare = scene.decor == nullptr || !scene.decor->ray_any({now.eye, point}, at_end);
            seen += is_seen ? 1 : 0;
            shown += (is_seen && is_bare) || after.door > 0.5 ? 1 : 0;
        }
        constexpr int enough = 3;
        if (within < enough) ++found_.outside;
        const bool is_hidden = seen < enough;
        found_.hidden += is_hidden ? 1 : 0;
        hidden_for_ = is_hidden ? hidden_for_ + 1 : 0;
        found_.hidden_for = std::max(found_.hidden_for, hidden_for_);
        if (shown < enough) ++found_.unseen;
        if (glm::length(now.eye - target.position) < 1) ++found_.near;
        if (was_put || found_.ticks == 1) {
            feet_ = feet;
            return;
        }
        const double moved = glm::length(now.eye - last.eye - (feet - feet_));
        const double turned = std::acos(std::clamp(glm::dot(now.forward, last.forward), -1.0, 1.0));
        if (moved > 0.5 || turned > 0.15) ++found_.cuts;
        feet_ = feet;
        found_.fastest = std::max(found_.fastest, moved);
        found_.fastest_turn = std::max(found_.fastest_turn, turned);
    }

    [[nodiscard]] const Found& found() const { return found_; }

    static void print(const std::string& name, const Found& f) {
        std::printf(
            "%-36s %5d ticks, inside %d, outside %.2f%%, hidden %.2f%% (%.2f s), unseen %.2f%%, near %.2f%%, "
            "%d cuts (%.2f m, %.2f rad)\n",
            name.c_str(), f.ticks, f.inside, 100 * f.share(f.outside), 100 * f.share(f.hidden), f.hidden_for / 60.0,
            100 * f.share(f.unseen), 100 * f.share(f.near), f.cuts, f.fastest, f.fastest_turn);
    }

private:
    static constexpr view::ivec2 picture{800, 600};

    static std::array<dvec3, 5> body_points(const CameraTarget& target, const dvec3& eye) {
        const dvec3 look = target.position - eye;
        const double flat = std::hypot(look.x, look.z);
        const dvec3 side = flat > 1e-6 ? dvec3(look.z, 0, -look.x) / flat : dvec3(1, 0, 0);
        const dvec3& middle = target.position;
        const dvec3 up(0, target.half_height, 0);
        return {middle + up * 0.8, middle + up * 0.1, middle - up * 0.7, middle + up * 0.2 + side * 0.25,
                middle + up * 0.2 - side * 0.25};
    }
    Found found_;
    dvec3 feet_{0, 0, 0};
    int hidden_for_ = 0;
};

}  // namespace surefoot::platformer::tests
