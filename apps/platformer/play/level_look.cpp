#include "platformer/play/level_look.hpp"

#include <algorithm>
#include <cmath>

#include <surefoot/pose.hpp>

namespace surefoot::platformer {
namespace {

view::Colour colour_of(const game::Level& level, std::uint32_t surface) {
    const auto byte = [](double share) { return std::uint8_t(std::lround(share * 255)); };
    if (surface < level.materials.size() && level.materials[surface].colour) {
        const auto& colour = *level.materials[surface].colour;
        return {byte(colour[0]), byte(colour[1]), byte(colour[2]), 255};
    }
    return view::colour_of_surface(
        surface, surface < level.materials.size() ? std::string_view(level.materials[surface].name) : "");
}

view::Finish finish_of(const game::Level& level, std::uint32_t surface) {
    if (surface >= level.materials.size()) return colour_of(level, surface);
    const game::Material& material = level.materials[surface];
    // The two lists of drawings are the same words.
    return {colour_of(level, surface), material.glow, static_cast<view::Pattern>(material.drawing)};
}

std::shared_ptr<const view::Model> model_of(const game::Level& level, const Mesh& mesh) {
    if (mesh.triangle_count() == 0) return nullptr;
    return view::Model::make(mesh, [&](const SourceTriangle& triangle) { return finish_of(level, triangle.surface); });
}

/// A plain tint, for it covers much of the picture: the surface, and the sides for who looks out of it; and glints
/// that wander over the surface.
void draw_water(view::Renderer& renderer, const game::Zone& water, double seconds) {
    const auto at = [&](double x, double y, double z) {
        return to_world(Pose{water.middle, water.orientation}, dvec3(x, y, z) * water.half);
    };
    const auto face = [&](const dvec3& a, const dvec3& b, const dvec3& c, const dvec3& d, view::Colour colour) {
        renderer.triangle(a, b, c, colour);
        renderer.triangle(a, c, d, colour);
    };
    const view::Colour side = view::rgb(0x1F86C4, 0.22);
    for (const int turn : {-1, 1}) {
        face(at(turn, -1, -1), at(turn, 1, -1), at(turn, 1, 1), at(turn, -1, 1), side);
        face(at(-1, -1, turn), at(-1, 1, turn), at(1, 1, turn), at(1, -1, turn), side);
    }
    face(at(-1, 1, -1), at(-1, 1, 1), at(1, 1, 1), at(1, 1, -1), view::rgb(0x2FA3DC, 0.50));
    const int across = std::clamp(int(water.half.x / 1.6), 1, 12);
    const int along = std::clamp(int(water.half.z / 1.6), 1, 12);
    for (int i = 0; i < across; ++i)
        for (int k = 0; k < along; ++k) {
            const double own = 2.4 * i + 1.7 * k + 0.9 * ((i * 7 + k * 3) % 5);
            const double wave = std::sin(seconds * 1.3 + own);
            if (wave <= 0) continue;
            const double x = (i + 0.5 + 0.3 * std::sin(own)) / across;
            const double z = (k + 0.5 + 0.3 * std::cos(own + seconds * 0.2)) / along;
            renderer.disc({.place = at(2 * x - 1, 1, 2 * z - 1) + dvec3(0, 0.01, 0),
                           .radius = 0.35 + 0.35 * wave,
                           .normal = {0, 1, 0},
                           .colour = view::rgb(0xD8F4FF, 0.22 * wave),
                           .is_light = true});
        }
}

Bounds box_of(const game::Level& level) {
    return level.ground.triangle_count() > 0 ? level.ground.bounds() : Bounds{level.goal - 10.0, level.goal + 10.0};
}

// A body that is about to crumble trembles, and a door that opens slides up out of sight.
Pose drawn_pose(const game::MovingBody& body, const game::BodyPlan& plan, double blend) {
    Pose pose = pose_between(body.before, body.now, blend);
    if (body.phase == game::MovingBody::Phase::shakes) pose.position.x += 0.03 * std::sin(body.since * 70);
    if (body.phase == game::MovingBody::Phase::opens) {
        const Bounds box = plan.mesh.bounds();
        const double share = std::min(1.0, body.since);
        pose.position.y += (box.max.y - box.min.y) * share * share;
    }
    return pose;
}

}  // namespace

LevelLook::LevelLook(const game::Level& level)
    : level_(level),
      sky_(level.sky, box_of(level), level.kill_y),
      ground_(model_of(level, level.ground)),
      decor_(model_of(level, level.decor)),
      halos_(halos_of(level)) {
    for (const game::BodyPlan& plan : level.bodies) bodies_.push_back(model_of(level, plan.mesh));
}

void LevelLook::draw(view::Renderer& renderer, const game::Game& game, double blend) const {
    const view::ModelLook still{};
    const view::ModelLook moving{.moves = true};
    if (ground_) renderer.model(ground_, still);
    if (decor_) renderer.model(decor_, {.yields = true});
    for (const game::MovingBody& body : game.bodies()) {
        const game::BodyPlan& plan = level_.bodies[body.plan];
        const bool is_seen = body.is_there || body.phase == game::MovingBody::Phase::opens;
        if (is_seen && bodies_[body.plan]) renderer.model(bodies_[body.plan], moving, drawn_pose(body, plan, blend));
    }
    sky_.draw(renderer, game.seconds());  // behind all that: it need not be drawn where that is
    draw_halos(renderer, halos_, sky_.darkness());
    for (const game::Zone& water : level_.waters) draw_water(renderer, water, game.seconds());
}

}  // namespace surefoot::platformer
