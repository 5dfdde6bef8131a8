/// Does a character get from here to there? Walks it with a follower and the real `step`, and tells how it went.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <surefoot/character.hpp>
#include <surefoot/character_settings.hpp>
#include <surefoot/math.hpp>
#include <surefoot/navigation_follow.hpp>
#include <surefoot/navigation_query.hpp>
#include <surefoot/world.hpp>

namespace [[gnu::visibility("default")]] surefoot {
inline namespace v0 {

struct WalkOptions {
    NavigationFollowOptions follow{};
    double tick = 1.0 / 60;  ///< [s, > 0]

    /// The longest that it may take [s]; 0: ten seconds and four times what the planned way takes at full speed.
    double most_seconds = 0;
};

/// One tick, as `capture_step` wants it.
struct WalkMoment {
    CharacterState before;
    CharacterInput input;
};

struct WalkReport {
    bool arrived = false;
    NavigationFollowReason reason = NavigationFollowReason::none;  ///< why not; none, too, if time ran out
    bool out_of_time = false;
    double seconds = 0;  ///< how long it walked [s]
    double planned = 0;  ///< the length of the first plan [m]; 0: there was none
    double walked = 0;   ///< how far the feet went, seen from above [m]
    std::size_t plans = 0;
    std::size_t links = 0;  ///< that were gone over
    dvec3 end{0, 0, 0};     ///< where the feet were in the end [m]

    std::vector<std::uint32_t>
        failed_links{};              ///< of `NavigationMesh::links`: failed it twice, the second time with care
    NavigationPolygon last_polygon;  ///< on which it was last
    NavigationPolygon next_polygon;  ///< beyond it, on the last plan; none at its end

    /// If it did not arrive: the last tick in which it wanted to go and more was near than a step looks at
    /// (`overflow`), else the last in which something blocked it, else the last in which it wanted to go; none if it
    /// never did.
    std::optional<WalkMoment> stuck{};
};

/// Puts the character at rest over `from`, lets it come to stand, and walks it to `to`; both are places of feet.
/// `query` is of the mesh to walk on. Requires: a tick and a speed above zero; nothing is walked otherwise.
[[nodiscard]] WalkReport walk_path(const World& world, const CharacterSettings& settings, const NavigationQuery& query,
                                   const dvec3& from, const dvec3& to, const WalkOptions& options = {});

/// The same with a query of its own, for one walk.
[[nodiscard]] WalkReport walk_path(const World& world, const CharacterSettings& settings, const NavigationMesh& mesh,
                                   const dvec3& from, const dvec3& to, const WalkOptions& options = {});

}  // namespace v0
}  // namespace surefoot
