#include "game/minds.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <span>
#include <string>

#include <surefoot/cook.hpp>
#include <surefoot/navigation_links.hpp>

#include "game/hero.hpp"

namespace surefoot::game {
namespace {

constexpr std::uint64_t cache_version = 3;  // another one whenever the same level would give another mesh
constexpr double jumper_speed = 4;          // [m/s]

Expected<NavigationMesh> walking_ground(const Level& level, const World& world, const CharacterSettings& settings) {
    const std::vector<NavigationRegion> regions = navigation_regions(level.markers);
    return NavigationMesh::build(world, settings, {.regions = regions, .layers = still_layer});
}

// Links are proved by simulating the feet, and that takes long: so only as far as its leash is ground for one who
// jumps.
std::vector<NavigationRegion> regions_about(const Level& level, const EnemyPlan& enemy) {
    std::vector<NavigationRegion> regions = navigation_regions(level.markers);
    constexpr double wide = 1e4;
    const double far = enemy.leash + 2 + 0.5 * wide;
    for (const dvec3& side : {dvec3{1, 0, 0}, dvec3{-1, 0, 0}, dvec3{0, 0, 1}, dvec3{0, 0, -1}})
        regions.push_back({.name = "beyond the leash",
                           .pose = {enemy.feet + side * far, {1, 0, 0, 0}},
                           .half_extents = {side.x != 0 ? 0.5 * wide : wide, wide, side.z != 0 ? 0.5 * wide : wide}});
    return regions;
}

Expected<NavigationMesh> jumping_ground(const Level& level, const World& world, const CharacterSettings& settings,
                                        const EnemyPlan& enemy, const std::atomic<bool>* stop) {
    struct Key {
        std::uint64_t level;
        dvec3 feet;
        double leash;
    };
    const Key made_from{level.hash, enemy.feet, enemy.leash};
    const std::uint64_t key = hash_bytes(std::as_bytes(std::span(&made_from, 1)), cache_version);
    const std::string path = level.hash != 0 ? cache_path(key) : std::string();
    if (!path.empty())
        if (auto kept = NavigationMesh::open(path)) return kept;
    const std::vector<NavigationRegion> regions = regions_about(level, enemy);
    auto mesh = NavigationMesh::build(world, settings, {.regions = regions, .layers = still_layer});
    if (!mesh) return mesh;
    const auto links = find_links(
        world, settings, *mesh,
        {.run_speed = jumper_speed, .spacing = 2.5, .margins = {.begin = 0}, .regions = regions, .stop = stop});
    // What was found until then is not all there is, so it is not kept.
    if (stop != nullptr && *stop)
        return tl::unexpected(Error{ErrorCode::invalid, level.file + ": looking for ways was stopped", level.file, 0});
    if (const auto set = mesh->set_links(links); !set) return tl::unexpected(set.error());
    if (!path.empty()) {
        // A cache that cannot be written costs time the next time, and nothing else.
        std::error_code error;
        std::filesystem::create_directories(std::filesystem::path(path).parent_path(), error);
        const std::vector<std::byte> bytes = mesh->to_bytes();
        const std::array sections{navigation_section(bytes, level.ground.made_from())};
        (void)level.ground.write(path, sections);
    }
    return mesh;
}

}  // namespace

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

Expected<std::unique_ptr<EnemyMinds>> EnemyMinds::make(const Level& level, const World& world,
                                                       const std::atomic<bool>* stop) {
    const auto walks = [](const EnemyPlan& plan) { return plan.kind != EnemyKind::shooter; };
    if (std::ranges::none_of(level.enemies, walks)) return nullptr;
    const CharacterSettings settings = enemy_settings(level.rules);
    std::unique_ptr<EnemyMinds> minds(new EnemyMinds(settings));
    for (std::uint32_t plan = 0; plan < level.enemies.size(); ++plan) {
        const EnemyPlan& enemy = level.enemies[plan];
        if (enemy.kind == EnemyKind::shooter) continue;
        const bool jumps = enemy.kind == EnemyKind::jumper;
        if (!jumps && minds->walkers_) continue;
        auto mesh =
            jumps ? jumping_ground(level, world, settings, enemy, stop) : walking_ground(level, world, settings);
        if (!mesh) return tl::unexpected(mesh.error());
        auto ground = std::make_unique<Ground>(std::move(*mesh));
        if (jumps)
            minds->jumpers_[plan] = std::move(ground);
        else
            minds->walkers_ = std::move(ground);
    }
    return minds;
}

std::uint32_t EnemyMinds::add(std::uint32_t plan) {
    const auto jumper = jumpers_.find(plan);
    minds_.push_back({jumper != jumpers_.end() ? jumper->second.get() : walkers_.get(),
                      NavigationFollower({.speed = 4, .arrival = 0.4, .attempts = 3, .go_near = true})});
    return std::uint32_t(minds_.size()) - 1;
}

CharacterInput EnemyMinds::go(const Enemy& enemy, const dvec3& feet, double speed) {
    Mind& mind = minds_[enemy.mind];
    if (mind.ground == nullptr) return {};  // it stands where it is
    NavigationFollower& follower = mind.follower;
    follower.go(mind.ground->query, feet);
    CharacterInput input = follower.input(mind.ground->query, enemy.body, settings_, tick_seconds);
    // A link is gone over at the speed with which it was found; else they walk as they feel.
    if (!follower.on_link()) input.wish = input.wish * (speed / follower.options().speed);
    return input;
}

void EnemyMinds::forget(const Enemy& enemy) {
    minds_[enemy.mind].follower.stop();
}

bool EnemyMinds::gave_up(const Enemy& enemy) const {
    return minds_[enemy.mind].follower.status() == NavigationFollowStatus::gave_up;
}

}  // namespace surefoot::game
