/// From a path to feet: what a character is told, tick by tick, so that it gets where it is sent.
///
///     NavigationFollower follower;
///     follower.go(query, goal);
///     while (follower.status() == NavigationFollowStatus::following)
///         state = step(world, settings, follower.input(query, state, settings, dt), dt, state).state;
///
/// It moves nothing itself; the feet are those of `step`.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include <surefoot/character.hpp>
#include <surefoot/character_settings.hpp>
#include <surefoot/math.hpp>
#include <surefoot/navigation_drive.hpp>
#include <surefoot/navigation_field.hpp>
#include <surefoot/navigation_line.hpp>
#include <surefoot/navigation_link.hpp>
#include <surefoot/navigation_query.hpp>

namespace [[gnu::visibility("default")]] surefoot {
inline namespace v0 {

/// How to follow. Every default is meant for a grown person in metres.
struct NavigationFollowOptions {
    double speed = 6;      ///< of the wish, where nothing calls for less [m/s, > 0]
    double arrival = 0.2;  ///< so near to the goal, seen from above, it has arrived [m, > 0]

    /// How far along the path it looks for a place to head for [m, > 0]. It heads for none to which the straight way
    /// leaves the mesh, so that corners are cut only where there is ground. Small: it runs from corner to corner.
    double look_ahead = 3;

    /// So far from the path, it plans anew from where it is [m, > 0].
    double off_path = 1.5;

    /// How far beside the mesh a start or a goal may lie; the nearest ground is meant then [m, >= 0].
    double beside_mesh = 1;

    /// A goal that moved farther than this since the last plan is planned for anew [m, >= 0], or farther than a tenth
    /// of the way that is left, if that is more. Else the path's end follows it.
    double goal_moved = 2;

    /// Without progress along the path for so long, it plans anew [s, > 0].
    double patience = 1;

    /// So many plans without progress between them, and it gives up [>= 1].
    std::uint32_t attempts = 4;

    /// Where there is no way to the goal: goes as near as it can before it gives up.
    bool go_near = false;
};

enum class NavigationFollowStatus : std::uint8_t {
    idle,       ///< was sent nowhere
    following,  ///< is on its way
    arrived,
    gave_up,  ///< `NavigationFollower::reason` says why
};

/// Why a follower gave up.
enum class NavigationFollowReason : std::uint8_t {
    none,
    off_mesh,       ///< there is no ground of the mesh near it
    goal_off_mesh,  ///< there is none near the goal
    no_path,        ///< none leads to the goal, or none any more: a door was shut
    stuck,          ///< it ran on and got nowhere, however often it planned
    local_minimum,  ///< of the field that it descends: no way leads down any more
    link_failed,    ///< a link was tried again and again and did not lead to its end
};

/// The same as a sentence for a person.
[[nodiscard]] std::string_view sentence(NavigationFollowReason reason) noexcept;

/// See the top of this file. A value: copies go on from the same place. `go` and plans allocate, which happens at the
/// start and when something went wrong; other ticks do not. Not for two threads at once, no more than the query.
class NavigationFollower {
public:
    explicit NavigationFollower(const NavigationFollowOptions& options = {}) noexcept : options_(options) {}

    /// Sends it to a place of feet. To be called again when the goal moves, every tick if need be: as long as it moves
    /// little, that costs one ray on the mesh. Who gave up tries again for a goal that is another by more than
    /// `goal_moved`, or after `stop`.
    void go(const NavigationQuery& query, const dvec3& goal);

    /// Sends it to the goal of a field, down the field instead of along a path of its own, and makes do with that until
    /// it is sent somewhere else. Non-owning: the field must outlive that.
    void go(const NavigationQuery& query, const NavigationField& field, const NavigationDescendOptions& options = {});

    /// It stays where it is, sent nowhere. On a link that is where it happens to be.
    void stop() noexcept;

    /// Counts as having arrived where it is: the goal is taken, or near enough for you.
    void arrive() noexcept;

    /// What to give to the next `step` of `dt` [s]. Once it has arrived or given up, and for a `dt` that is not
    /// positive: to stand still.
    [[nodiscard]] CharacterInput input(const NavigationQuery& query, const CharacterState& state,
                                       const CharacterSettings& settings, double dt);

    [[nodiscard]] NavigationFollowStatus status() const noexcept { return status_; }
    [[nodiscard]] NavigationFollowReason reason() const noexcept { return reason_; }
    [[nodiscard]] const NavigationFollowOptions& options() const noexcept { return options_; }

    /// The path of the last plan (that of a field has none), the line that is followed on it, and how far along that
    /// line it is [m].
    [[nodiscard]] const NavigationPath& path() const noexcept { return path_; }
    [[nodiscard]] const NavigationLine& line() const noexcept { return line_; }
    [[nodiscard]] double along() const noexcept { return along_; }
    [[nodiscard]] double left() const noexcept { return line_.length() - along_; }

    [[nodiscard]] const dvec3& heading_for() const noexcept { return aim_; }  ///< a place of the mesh
    [[nodiscard]] const NavigationPoint& place() const noexcept { return place_; }
    [[nodiscard]] const NavigationPoint& goal() const noexcept { return goal_; }
    [[nodiscard]] std::size_t plans() const noexcept { return plans_; }  ///< how often it planned since it was sent
    [[nodiscard]] std::size_t links() const noexcept { return links_; }  ///< how many links it went over since
    [[nodiscard]] bool on_link() const noexcept { return drives_; }      ///< the driver has it

    /// The link that it is on, or else the one that begins at most so far along the line from here [m].
    [[nodiscard]] std::optional<std::uint32_t> next_link(double within) const noexcept;

    /// Whether to wait before the next link, because somebody else is on it, instead of going over it.
    void hold(bool holds) noexcept { holds_ = holds; }

    /// Of `NavigationMesh::links`, since it was sent: those that failed it twice, the second time with care. It takes
    /// other ways, as long as there are any.
    [[nodiscard]] std::span<const std::uint32_t> failed_links() const noexcept { return failed_; }

private:
    /// After the mesh has changed; false if it gave up over that.
    [[nodiscard]] bool refresh(const NavigationQuery& query);
    [[nodiscard]] std::optional<NavigationPoint> near_goal(const NavigationQuery& query, const dvec3& goal) const;
    [[nodiscard]] CharacterInput find_back(const NavigationQuery& query, const CharacterState& state, const dvec3& feet,
                                           double dt);
    [[nodiscard]] bool locate(const NavigationQuery& query, const CharacterState& state, const dvec3& feet);
    [[nodiscard]] bool plan(const NavigationQuery& query);
    [[nodiscard]] std::optional<NavigationPoint> step_aside(const NavigationQuery& query) const;
    void begin(const NavigationPoint& goal);
    [[nodiscard]] bool plan_down(const NavigationQuery& query, const std::optional<NavigationPoint>& beside);
    void move_goal(const NavigationQuery& query, const NavigationPoint& goal);
    void move_along(const NavigationQuery& query);
    void watch(const CharacterState& state, double dt);
    void try_again(NavigationFollowReason reason) noexcept;
    [[nodiscard]] std::optional<NavigationPath> find_path(const NavigationQuery& query, const NavigationPoint& from);
    void fail_link();
    [[nodiscard]] CharacterInput walk(const NavigationQuery& query, const CharacterState& state,
                                      const CharacterSettings& settings, double dt);
    [[nodiscard]] CharacterInput drive_link(const NavigationQuery& query, const CharacterState& state,
                                            const CharacterSettings& settings, double dt);
    [[nodiscard]] bool begin_link(const NavigationQuery& query);
    [[nodiscard]] double aim_along(const NavigationQuery& query) const;
    void give_up(NavigationFollowReason reason) noexcept;

    NavigationFollowOptions options_{};
    NavigationFollowStatus status_ = NavigationFollowStatus::idle;
    NavigationFollowReason reason_ = NavigationFollowReason::none;
    NavigationPoint goal_{};
    dvec3 planned_goal_{0, 0, 0};
    NavigationPoint place_{};
    NavigationPath path_;
    const NavigationField* field_ = nullptr;
    NavigationDescendOptions descend_{};
    NavigationLine line_;
    dvec3 aim_{0, 0, 0};
    double along_ = 0;
    double begin_ = 0;                ///< of the part of the line that it is on: where the last link ended [m]
    double best_along_ = 0;           ///< the farthest along the line since there was a plan [m]
    double least_left_ = 0;           ///< the shortest way left since attempts were counted [m]
    double without_ = 0;              ///< time without progress [s]
    double lost_ = 0;                 ///< time on ground that is no ground of the mesh [s]
    double since_check_ = 0;          ///< time since the path was looked over for doors [s]
    std::uint64_t link_changes_ = 0;  ///< of the mesh, as it last saw it
    std::uint32_t tried_ = 0;         ///< plans without progress between them
    std::size_t plans_ = 0;
    std::size_t links_ = 0;
    NavigationLink link_;  ///< that is gone over; without its inputs
    NavigationDrive drive_{};
    std::uint32_t link_id_ = 0;                 ///< of `NavigationMesh::links`
    std::vector<std::uint32_t> careful_{};      ///< links that failed once: they are tried again with care
    std::vector<std::uint32_t> failed_{};       ///< links that failed with care, too,
    std::vector<NavigationPolygon> avoided_{};  ///< and their polygons: no way goes over them
    bool drives_ = false;
    bool holds_ = false;
    bool wants_plan_ = false;
};

}  // namespace v0
}  // namespace surefoot
