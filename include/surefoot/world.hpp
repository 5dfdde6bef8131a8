/// A world: triangle sources placed by poses, some of them moving, and the queries over all of them.
///
/// Time. A tick of the game is the time [0, 1]. A body that moves has a pose at the start and one at the end of the
/// tick and goes from one to the other as `pose_between` says; all others stand. A query's motion takes the part
/// [begin, end] of the tick, by default all of it, so a sweep that stands still is hit by a lift that comes up. Queries
/// without a motion (overlap, nearest, gather) see the world at `begin`.
///
/// Threads. Const calls may run on any number of threads at once; everything else runs alone. Memory: `add` allocates,
/// nothing else does.
///
/// What is promised of a sweep (docs/world.md has the reasons):
///  - a body at the origin that is not turned answers with the very bits of its source, and one that only stands or
///    moves elsewhere with those of its source asked about the relative motion, wherever that is a double;
///  - any other pose rounds the question. The volume is grown by that rounding, 2^-46 of the distance to the body's
///    origin and of the volume's size, so that still nothing is missed and nothing late;
///  - a body that turns is asked in pieces, each with a volume grown by what the piece does not follow: nothing gets
///    deeper than `turn_gap` unreported, and a reported hit is at most `turn_gap` away.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <type_traits>

#include <surefoot/bounds.hpp>
#include <surefoot/error.hpp>
#include <surefoot/hit.hpp>
#include <surefoot/march.hpp>
#include <surefoot/math.hpp>
#include <surefoot/mesh.hpp>
#include <surefoot/overlap.hpp>
#include <surefoot/pose.hpp>
#include <surefoot/query.hpp>
#include <surefoot/shapes.hpp>
#include <surefoot/slab.hpp>
#include <surefoot/source.hpp>

namespace surefoot::internal {
struct WorldBody;
}

namespace [[gnu::visibility("default")]] surefoot {
inline namespace v0 {

/// Names a body for as long as it is in the world; afterwards it is dead, for ever.
using BodyHandle = SlabHandle<internal::WorldBody>;

inline constexpr std::uint64_t all_layers = ~std::uint64_t{0};

/// The id that `add` replaces by the lowest that no body has.
inline constexpr std::uint32_t lowest_free_body = ~std::uint32_t{0};

/// How a source comes into the world.
struct Placement {
    Pose pose{};
    /// Your own number for it: what hits call `body`, what decides ties, what snapshots go by. No two bodies share one.
    std::uint32_t body = lowest_free_body;
    /// A query meets the body if they have a bit in common [a mask of 64].
    std::uint64_t layers = 1;
};

/// A condition: any callable `bool(Arguments...)`. Non-owning: it must outlive the call that it is handed to. It may
/// not throw, and its answer may not depend on when it is asked. By default it lets everything pass.
template <typename... Arguments>
class Condition {
public:
    constexpr Condition() noexcept = default;

    template <typename Callable>
    requires(!std::is_same_v<Callable, Condition> &&
             std::is_invocable_r_v<bool, const Callable&, Arguments...>) constexpr Condition(const Callable&
                                                                                                 callable) noexcept
        : callable_(&callable), call_([](const void* target, Arguments... arguments) -> bool {
              return (*static_cast<const Callable*>(target))(arguments...);
          }) {}

    [[nodiscard]] bool operator()(Arguments... arguments) const {
        return call_ == nullptr || call_(callable_, arguments...);
    }
    [[nodiscard]] explicit operator bool() const noexcept { return call_ != nullptr; }

private:
    const void* callable_ = nullptr;
    bool (*call_)(const void*, Arguments...) = nullptr;
};

/// `bool(body)`: may the query meet anything of this body?
using BodyFilter = Condition<std::uint32_t>;

/// `bool(body, triangle, surface)`: does this triangle exist for the query?
using BodyTriangleFilter = Condition<std::uint32_t, std::uint32_t, std::uint32_t>;

/// What a query on a world may be told.
struct WorldQuery {
    bool one_sided = false;             ///< see SweepOptions and OverlapOptions
    Search search = Search::tree;       ///< brute force goes over all bodies and all triangles
    Trace* trace = nullptr;             ///< records of every triangle that was tested; none by default
    std::uint64_t layers = all_layers;  ///< bodies without a bit of these do not exist for the query
    BodyFilter bodies{};                ///< which bodies exist for the query; all by default
    BodyTriangleFilter triangles{};     ///< which triangles exist for the query; all by default
    QueryWork* work = nullptr;          ///< counts, for benchmarks and debuggers; none by default
    double begin = 0;                   ///< when in the tick the motion begins [0, 1]
    double end = 1;                     ///< and when it ends [begin, 1]; outside: blocked, `invalid`
    /// How far away a turning body may be when it is hit [m, > 0]; make it half your skin. What turns so far in one
    /// tick that 4096 pieces do not follow it this closely blocks, where it is met at all, and says `overflow`.
    double turn_gap = 0.001;
};

/// The poses of one body, for a snapshot.
struct BodyPose {
    std::uint32_t body = 0;  ///< your own number for it
    std::uint32_t reserved = 0;
    Pose start{};  ///< at the start of the tick
    Pose end{};    ///< at its end
};

static_assert(std::is_trivially_copyable_v<BodyPose> && sizeof(BodyPose) == 120);

/// Bodies and their queries; see the top of this file. A world that was moved from may only be destroyed or assigned
/// to.
class World {
public:
    World();
    World(World&& other) noexcept;
    World& operator=(World&& other) noexcept;
    ~World();

    /// Places a mesh. The world holds a copy, which shares the mesh's triangles. Fails with `invalid` when the pose is
    /// not finite or beyond the limits, or the body's id is taken; with `out_of_memory` when there is no room.
    Expected<BodyHandle> add(const Mesh& mesh, const Placement& placement = {});

    /// Places any other source. The world refers to it, so it must outlive the body, and it may not change while a
    /// query runs. Fails as above.
    Expected<BodyHandle> add(const SourceView& source, const Placement& placement = {});
    template <TriangleSource Gone>
    requires(!std::same_as<Gone, Mesh> &&
             !std::same_as<Gone, SourceView>) void add(const Gone&& does_not_live_long_enough,
                                                       const Placement& placement = {}) = delete;

    /// Takes a body out. Requires: it is in; asserts otherwise, and with asserts off does nothing and says false.
    bool remove(BodyHandle handle) noexcept;

    /// A new tick: every body that moved stands where it arrived.
    void begin_tick() noexcept;

    /// The body goes from where it is at the start of this tick to `end`. False, and nothing is changed, if the pose is
    /// NaN or beyond the limits. Requires: the body is in; asserts otherwise, and with asserts off says false.
    [[nodiscard]] bool move(BodyHandle handle, const Pose& end) noexcept;

    /// The body goes from `start` to `end` during this tick; `start` equal to `end` puts it there. Otherwise as above.
    [[nodiscard]] bool move(BodyHandle handle, const Pose& start, const Pose& end) noexcept;

    /// Which queries meet the body from now on. Requires: the body is in; asserts otherwise, else says false.
    bool set_layers(BodyHandle handle, std::uint64_t layers) noexcept;

    /// Reads the source's bounds again, after its triangles have changed. Requires: as above.
    bool refit(BodyHandle handle) noexcept;

    /// The body with your own number `body`; the handle of nothing if there is none.
    [[nodiscard]] BodyHandle find(std::uint32_t body) const noexcept;
    [[nodiscard]] bool contains(BodyHandle handle) const noexcept;
    [[nodiscard]] std::size_t body_count() const noexcept;

    /// The body's source, to be asked in the body's own frame; good as long as the body is in the world. Requires: it
    /// is in; asserts otherwise, else there is none.
    [[nodiscard]] std::optional<SourceView> source(BodyHandle handle) const noexcept;

    /// The body's number and poses. Requires: the body is in; asserts otherwise, else says all zeros.
    [[nodiscard]] BodyPose poses(BodyHandle handle) const noexcept;

    /// Where the point of the body that is at `place` at `begin` will be at `end` [times of the tick]: what a rider
    /// adds to its own motion. Requires: the body is in; asserts otherwise, else says `place`.
    [[nodiscard]] dvec3 carried(BodyHandle handle, const dvec3& place, double begin = 0, double end = 1) const noexcept;

    /// How fast the body moves at `place`, on the average over a tick of `seconds` [s, > 0; else zero] [m/s]. Requires:
    /// as above.
    [[nodiscard]] dvec3 velocity_at(BodyHandle handle, const dvec3& place, double seconds) const noexcept;

    /// A triangle in the world, at a time of the tick; none if there is no such body. For `barycentrics` of a hit, ask
    /// at the hit's own time. Requires: `triangle` is one of the source's.
    [[nodiscard]] std::optional<Triangle> triangle(std::uint32_t body, std::uint32_t triangle,
                                                   double at = 0) const noexcept;

    /// Fills `room` with the poses of the bodies of these layers, in the order of their numbers, and returns how many
    /// there are, which may be more than found room.
    std::size_t save_poses(std::span<BodyPose> room, std::uint64_t layers = all_layers) const noexcept;

    /// Puts the bodies back, to the last bit. Requires: each is in, with a valid pose; asserts otherwise, and with
    /// asserts off changes nothing and says false.
    bool restore_poses(std::span<const BodyPose> saved) noexcept;

    /// The first touch of `volume` along `motion`; ties in t go to the lowest (body, triangle). `point` and `normal`
    /// are in the world at the time of the hit. A body that cannot be answered blocks if nothing is hit before it.
    [[nodiscard]] std::optional<Hit> sweep(const Volume& volume, const Motion& motion,
                                           const WorldQuery& query = {}) const noexcept;

    /// Is there any touch along `motion`? The same as asking whether `sweep` has an answer.
    [[nodiscard]] bool sweep_any(const Volume& volume, const Motion& motion,
                                 const WorldQuery& query = {}) const noexcept;

    /// Where the segment first meets a body. A ray has no thickness to grow: at the outer edges of a body whose pose
    /// rounds, and of one that turns, it is right to within that rounding and `turn_gap`; between two triangles of one
    /// body it never slips. For a line of sight, which takes no time, let `begin` and `end` be one moment.
    [[nodiscard]] std::optional<Hit> ray(const Motion& motion, const WorldQuery& query = {}) const noexcept;

    /// Does the segment meet anything? The same as asking whether `ray` has an answer.
    [[nodiscard]] bool ray_any(const Motion& motion, const WorldQuery& query = {}) const noexcept;

    /// All triangles that `volume` at `position` touches, by (body, triangle). Fills `found` from the front and returns
    /// how many there were, which may be more than found room.
    std::size_t overlap(const Volume& volume, const dvec3& position, std::span<Overlap> found,
                        const WorldQuery& query = {}) const noexcept;

    /// The point of all bodies that is nearest to `point`, if it is within `farthest` [m, >= 0].
    [[nodiscard]] std::optional<NearestPoint> nearest(const dvec3& point, double farthest,
                                                      const WorldQuery& query = {}) const noexcept;

    /// All triangles, placed in the world, whose own box in the frame of their body meets the box around `near` there:
    /// each triangle that reaches into `near`, and a few beside it; by (body, id). See `Mesh::gather`.
    std::size_t gather(const Bounds& near, std::span<SourceTriangle> found,
                       const WorldQuery& query = {}) const noexcept;

private:
    struct State;
    State* state_;
};

/// Walks `volume` along `path` through a world; see march.hpp. The path takes the part [begin, end] of the tick; give
/// both the same time to walk through the world as it stands at that moment. One-sided if either option says so.
[[nodiscard]] std::optional<MarchHit> march(const Volume& volume, const Path& path, const World& world,
                                            const MarchOptions& options = {}, const WorldQuery& query = {});

}  // namespace v0
}  // namespace surefoot
