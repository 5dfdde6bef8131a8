/// Many followers that get out of each other's way: each follows its own path, and Detour's obstacle avoidance bends
/// what it wants where others or the mesh's borders are in the way. The feet are those of `step_all` with a `Crowd`.
///
///     crowd.gather(states);                          // where everybody is now
///     crowd.steer(worker, settings, dt, inputs);     // what everybody is told
///     feet.gather(characters, dt);                   // and then as in crowd.hpp
///     step_all(world, feet, characters, dt);
///
/// Everybody sees the others as they were at the tick's start, so neither their order nor the number of threads changes
/// what they are told. Avoidance is done in floats and by the system's library: it may differ in its last bits from
/// machine to machine. Send inputs, not goals.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include <surefoot/character.hpp>
#include <surefoot/character_settings.hpp>
#include <surefoot/math.hpp>
#include <surefoot/navigation_follow.hpp>
#include <surefoot/navigation_mesh.hpp>
#include <surefoot/navigation_query.hpp>

namespace surefoot::navigation {
struct CrowdState;
struct WorkerState;
}

namespace [[gnu::visibility("default")]] surefoot {
inline namespace v0 {

/// How many velocities are tried for each who has somebody near.
enum class NavigationAvoidance : std::uint8_t {
    none,    ///< everybody goes as if alone: `step` keeps them apart, and they jam
    few,     ///< about 15
    medium,  ///< about 45
    many,    ///< about 65
};

struct NavigationCrowdOptions {
    /// Of every one. They wait longer for each other than they would before a wall.
    NavigationFollowOptions follow{.attempts = 20};

    NavigationAvoidance avoidance = NavigationAvoidance::few;

    /// Others and borders so near are heeded [m, > 0].
    double range = 3;

    /// How far ahead in time they look for collisions [s, > 0]. Small: they dodge late. Large: they shy.
    double horizon = 1.5;

    /// Where the goal is taken by others with the same goal, having come up to them counts as having arrived.
    bool arrive_beside = true;
};

/// What one thread needs to steer: make one for each.
class NavigationCrowdWorker {
public:
    explicit NavigationCrowdWorker(const NavigationMesh& mesh);
    NavigationCrowdWorker(NavigationCrowdWorker&& other) noexcept;
    NavigationCrowdWorker& operator=(NavigationCrowdWorker&& other) noexcept;
    ~NavigationCrowdWorker();

    [[nodiscard]] const NavigationQuery& query() const noexcept;
    [[nodiscard]] navigation::WorkerState& state() noexcept { return *state_; }  ///< for the parts of the wing

private:
    std::unique_ptr<navigation::WorkerState> state_;
};

/// See the top of this file. Threads may share `steer`: each with a worker and a range of its own; everything else runs
/// alone. Memory: `resize`, `go` and plans allocate, and `gather` when there are more than there ever were.
class NavigationCrowd {
public:
    explicit NavigationCrowd(const NavigationMesh& mesh, std::size_t count, const NavigationCrowdOptions& options = {});
    NavigationCrowd(NavigationCrowd&& other) noexcept;
    NavigationCrowd& operator=(NavigationCrowd&& other) noexcept;
    ~NavigationCrowd();

    [[nodiscard]] std::size_t size() const noexcept;

    /// Those beyond what there were are idle.
    void resize(std::size_t count);

    /// As `NavigationFollower::go` and `stop`. Requires: an index below `size`.
    void go(const NavigationQuery& query, std::size_t index, const dvec3& goal);
    void stop(std::size_t index) noexcept;
    [[nodiscard]] const NavigationFollower& follower(std::size_t index) const noexcept;

    /// Takes in where all are: `size` of them. False, and nothing is changed, if there are not as many.
    [[nodiscard]] bool gather(std::span<const CharacterState> states);

    /// Says for each in the range what to tell it in a step of `dt` [s]. Those who were sent nowhere, have arrived or
    /// gave up are told to stand still. Requires: gathered states, and room for as many inputs; does nothing otherwise.
    void steer(NavigationCrowdWorker& worker, const CharacterSettings& settings, double dt,
               std::span<CharacterInput> inputs, StepRange range = {});

private:
    std::unique_ptr<navigation::CrowdState> state_;
};

}  // namespace v0
}  // namespace surefoot
