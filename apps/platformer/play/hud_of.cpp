#include "platformer/play/hud_of.hpp"

#include <algorithm>

namespace surefoot::platformer {
namespace {

using game::BodyKind;
using game::PickupKind;

MapItem::Kind map_kind(PickupKind kind) {
    switch (kind) {
        case PickupKind::coin:
            return MapItem::Kind::coin;
        case PickupKind::star:
            return MapItem::Kind::star;
        case PickupKind::heart:
            return MapItem::Kind::heart;
        case PickupKind::key:
            return MapItem::Kind::key;
    }
    return MapItem::Kind::coin;
}

// The goal, the next checkpoint, keys, and doors whose key is in hand.
void add_markers(const game::Game& game, HudView& hud) {
    const game::Level& level = game.level();
    hud.markers.push_back({HudMarker::Kind::goal, level.goal + dvec3{0, 1.5, 0}});
    if (game.checkpoint() + 1 < level.checkpoints.size())
        hud.markers.push_back(
            {HudMarker::Kind::checkpoint, level.checkpoints[game.checkpoint() + 1].feet + dvec3{0, 1.5, 0}});
    for (const game::Pickup& pickup : game.pickups())
        if (level.pickups[pickup.plan].kind == PickupKind::key)
            hud.markers.push_back(
                {HudMarker::Kind::key, level.pickups[pickup.plan].place, level.pickups[pickup.plan].door});
    for (const game::MovingBody& body : game.bodies()) {
        const game::BodyPlan& plan = level.bodies[body.plan];
        const bool has_key = std::ranges::find(game.keys(), plan.door) != game.keys().end();
        if (plan.kind == BodyKind::door && body.is_there && has_key)
            hud.markers.push_back({HudMarker::Kind::door, plan.origin, plan.door});
    }
}

void add_map(const Run& run, ColourVision colours, HudView& hud) {
    const game::Game& game = run.game();
    const game::Level& level = game.level();
    for (const game::Pickup& pickup : game.pickups()) {
        const game::PickupPlan& plan = level.pickups[pickup.plan];
        if (plan.kind == PickupKind::star) continue;  // where those are is for the player to find
        MapItem item{map_kind(plan.kind), plan.place};
        if (plan.kind == PickupKind::key) item.colour = key_colour(plan.door, colours);
        hud.map.push_back(item);
    }
    for (const game::Enemy& enemy : game.enemies()) hud.map.push_back({MapItem::Kind::enemy, enemy.body.position});
    for (std::size_t i = game.checkpoint() + 1; i < level.checkpoints.size(); ++i)
        hud.map.push_back({MapItem::Kind::checkpoint, level.checkpoints[i].feet});
    hud.map.push_back({MapItem::Kind::goal, level.goal});
    if (run.ghost()) hud.map.push_back({MapItem::Kind::ghost, run.ghost()->pose.soles});
}

}  // namespace

HudView hud_of(const Run& run, const Screens& screens, const view::Camera& camera, const view::ivec2& window) {
    const game::Game& game = run.game();
    const game::Level& level = game.level();
    HudView hud;
    hud.health = game.hero().health;
    hud.most_health = game::most_health;
    hud.coins = game.coins();
    hud.coins_all = level.count(PickupKind::coin);
    hud.stars = game.stars();
    hud.stars_all = level.count(PickupKind::star);
    hud.keys = game.keys();
    hud.seconds = game.seconds();
    hud.section = level.checkpoints[game.checkpoint()].section;
    hud.section_age = game.seconds() - run.section_began();
    if (const game::Prompt* prompt = game.prompt())
        hud.prompt = prompt_parts(prompt->text, screens.settings().bindings, screens.device());
    add_markers(game, hud);
    if (run.since_hurt() < 2) hud.hurts.push_back({run.hurt_from(), run.since_hurt()});
    add_map(run, screens.settings().colours, hud);
    hud.hero = game.hero().body.position;
    hud.facing = game.hero().facing;
    hud.hero_height = 1.6;
    hud.since_coin = run.since_coin();
    hud.since_health = run.since_hurt();
    hud.watching = run.is_watched();
    hud.camera = camera;
    hud.window = window;
    return hud;
}

Plan plan_of(const game::Level& level) {
    std::vector<dvec3> corners;
    corners.reserve(3 * level.ground.triangle_count());
    for (std::uint32_t id = 0; id < level.ground.triangle_count(); ++id) {
        const Triangle triangle = level.ground.triangle(id);
        corners.insert(corners.end(), {triangle.a, triangle.b, triangle.c});
    }
    return make_plan(corners);
}

}  // namespace surefoot::platformer
