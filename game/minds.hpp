/// How enemies find their ways: one navigation mesh for all who walk, one of its own with links for each who jumps, and
/// a follower each.
#pragma once

#include <atomic>
#include <map>
#include <memory>
#include <vector>

#include <surefoot/navigation_follow.hpp>
#include <surefoot/navigation_mesh.hpp>
#include <surefoot/navigation_query.hpp>
#include <surefoot/world.hpp>

#include "game/level.hpp"
#include "game/things.hpp"

namespace surefoot::game {

/// The still ground is in layer 1 of the world, what moves in layer 2.
inline constexpr std::uint64_t still_layer = 1;
inline constexpr std::uint64_t moving_layer = 2;

/// All enemies have the same body, so that one mesh serves them; they are drawn as they like.
[[nodiscard]] CharacterSettings enemy_settings(std::span<const SurfaceRule> rules);

class EnemyMinds {
public:
    /// Null where nobody needs to walk. Fails as building a navigation mesh does. What takes long, the links of those
    /// who jump, is kept in the user's cache folder for the next time; once `stop` is true it ends soon and fails.
    [[nodiscard]] static Expected<std::unique_ptr<EnemyMinds>> make(const Level& level, const World& world,
                                                                    const std::atomic<bool>* stop = nullptr);

    /// A follower for an enemy of this plan; its number.
    [[nodiscard]] std::uint32_t add(std::uint32_t plan);

    /// What an enemy does to get to a place.
    [[nodiscard]] CharacterInput go(const Enemy& enemy, const dvec3& feet, double speed);

    /// It was moved by force: it plans anew.
    void forget(const Enemy& enemy);
    [[nodiscard]] bool gave_up(const Enemy& enemy) const;

    [[nodiscard]] const CharacterSettings& settings() const { return settings_; }

private:
    struct Ground {
        explicit Ground(NavigationMesh made) : mesh(std::move(made)), query(mesh) {}
        NavigationMesh mesh;
        NavigationQuery query;
    };
    struct Mind {
        const Ground* ground;
        NavigationFollower follower;
    };
    explicit EnemyMinds(const CharacterSettings& settings) : settings_(settings) {}

    CharacterSettings settings_;
    std::unique_ptr<Ground> walkers_;
    std::map<std::uint32_t, std::unique_ptr<Ground>> jumpers_;  // by plan
    std::vector<Mind> minds_;
};

}  // namespace surefoot::game
