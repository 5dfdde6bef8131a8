#include "game/minds.hpp"

#include <algorithm>

#include <surefoot/navigation_links.hpp>

#include "game/hero.hpp"

namespace surefoot::game {

CharacterSettings enemy_settings(std::span<const SurfaceRule> rules) {
    CharacterSettings settings;
    settings.volume = Ellipsoid{{0.4, 0.6, 0.4}};
    settings.flat_foot = true;
    settings.gravity = 22;
    settings.acceleration = 25;
    settings.jump_height = 1.7;
    settings.firmness = Firmness::soft;
    settings.surfaces = rules;
    return settings;
}

EnemyMinds::EnemyMinds(const CharacterSettings& settings, NavigationMesh mesh)
    : settings_(settings), mesh_(std::move(mesh)), query_(mesh_) {}

Expected<std::unique_ptr<EnemyMinds>> EnemyMinds::make(const Level& level, const World& world) {
    const auto walks = [](const EnemyPlan& plan) { return plan.kind != EnemyKind::shooter; };
    if (std::ranges::none_of(level.enemies, walks)) return nullptr;
    const CharacterSettings settings = enemy_settings(level.rules);
    const std::vector<NavigationRegion> regions = navigation_regions(level.markers);
    auto mesh = NavigationMesh::build(world, settings, {.regions = regions, .layers = still_layer});
    if (!mesh) return tl::unexpected(mesh.error());
    // Looking for links is dear; they are for those who jump.
    if (std::ranges::any_of(level.enemies, [](const EnemyPlan& plan) { return plan.kind == EnemyKind::jumper; })) {
        const auto links = find_links(world, settings, *mesh, {.run_speed = 4, .regions = regions});
        if (const auto set = mesh->set_links(links); !set) return tl::unexpected(set.error());
    }
    return std::unique_ptr<EnemyMinds>(new EnemyMinds(settings, std::move(*mesh)));
}

std::uint32_t EnemyMinds::add() {
    followers_.emplace_back(NavigationFollowOptions{.speed = 4, .arrival = 0.4, .attempts = 3, .go_near = true});
    return std::uint32_t(followers_.size()) - 1;
}

CharacterInput EnemyMinds::go(const Enemy& enemy, const dvec3& feet, double speed) {
    NavigationFollower& follower = followers_[enemy.mind];
    follower.go(query_, feet);
    CharacterInput input = follower.input(query_, enemy.body, settings_, tick_seconds);
    // A link is gone over at the speed with which it was found; else they walk as they feel.
    if (!follower.on_link()) input.wish = input.wish * (speed / follower.options().speed);
    return input;
}

void EnemyMinds::forget(const Enemy& enemy) {
    followers_[enemy.mind].stop();
}

bool EnemyMinds::has_arrived(const Enemy& enemy) const {
    return followers_[enemy.mind].status() == NavigationFollowStatus::arrived;
}

bool EnemyMinds::gave_up(const Enemy& enemy) const {
    return followers_[enemy.mind].status() == NavigationFollowStatus::gave_up;
}

}  // namespace surefoot::game
