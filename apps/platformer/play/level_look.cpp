#include "platformer/play/level_look.hpp"

#include <algorithm>
#include <cmath>

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

std::shared_ptr<const view::Model> model_of(const game::Level& level, const Mesh& mesh) {
    if (mesh.triangle_count() == 0) return nullptr;
    return view::Model::make(mesh, [&](const SourceTriangle& triangle) { return colour_of(level, triangle.surface); });
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

view::Sky sky_of(const std::string& name) {
    view::Sky sky;
    sky.shadow_radius = 60;
    sky.fog_distance = 260;
    // Softer than noon, so that snow and sand keep their drawing, and bluer.
    sky.sun = {0.90F, 0.82F, 0.69F};
    sky.above = {0.31F, 0.38F, 0.48F};
    sky.zenith = {0.08F, 0.30F, 0.66F};
    sky.horizon = {0.56F, 0.75F, 0.88F};
    sky.nadir = {0.40F, 0.58F, 0.72F};
    if (name == "dusk") {
        sky.towards_sun = {0.78, 0.38, 0.5};
        sky.sun = {1.15F, 0.72F, 0.45F};
        sky.above = {0.36F, 0.34F, 0.48F};
        sky.zenith = {0.13F, 0.15F, 0.34F};
        sky.horizon = {0.82F, 0.48F, 0.34F};
        sky.nadir = {0.34F, 0.28F, 0.34F};
    } else if (name == "night") {
        sky.towards_sun = {-0.35, 0.86, 0.38};
        sky.sun = {0.42F, 0.52F, 0.78F};
        sky.above = {0.20F, 0.24F, 0.40F};
        sky.below = {0.10F, 0.10F, 0.16F};
        sky.zenith = {0.012F, 0.02F, 0.07F};
        sky.horizon = {0.07F, 0.10F, 0.22F};
        sky.nadir = {0.03F, 0.04F, 0.10F};
        sky.fog_distance = 160;
    } else if (name == "cave") {
        sky.towards_sun = {0.2, 0.95, 0.25};
        sky.sun = {0.70F, 0.64F, 0.56F};
        sky.above = {0.30F, 0.32F, 0.38F};
        sky.below = {0.20F, 0.17F, 0.16F};
        sky.zenith = {0.035F, 0.05F, 0.07F};
        sky.horizon = {0.12F, 0.16F, 0.19F};
        sky.nadir = {0.06F, 0.07F, 0.09F};
        sky.fog_distance = 120;
    }
    return sky;
}

LevelLook::LevelLook(const game::Level& level)
    : level_(level), ground_(model_of(level, level.ground)), decor_(model_of(level, level.decor)) {
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
    for (const game::Zone& water : level_.waters)
        renderer.shape(Volume{Box{water.half}, water.orientation}, water.middle,
                       {.colour = view::rgb(0x2F9BD6), .opacity = 0.38, .outline = 0, .casts_shadow = false});
}

}  // namespace surefoot::platformer
