/// The levels of the course: bodies of triangles, some of them moving, and a builder that makes them here and now.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include <surefoot/math.hpp>
#include <surefoot/pose.hpp>
#include <surefoot/world.hpp>

namespace surefoot::course {

/// Triangles, as a mover gets them: vertices in the body's own frame, three indices a triangle, counter-clockwise from
/// the front.
struct Triangles {
    std::vector<vec3> vertices;
    std::vector<std::uint32_t> indices;

    Triangles& triangle(const dvec3& a, const dvec3& b, const dvec3& c);

    /// A flat four-sided face.
    Triangles& quad(const dvec3& a, const dvec3& b, const dvec3& c, const dvec3& d);

    /// A four-sided face cut into `along` x `across` pieces of two triangles each: along ab, across bc.
    Triangles& sheet(const dvec3& a, const dvec3& b, const dvec3& c, const dvec3& d, int along, int across);

    /// Level ground, `pieces` squares along x and as many along z.
    Triangles& floor(const dvec3& low, const dvec3& high, int pieces = 1);

    /// A block with all its six sides, faces outwards.
    Triangles& block(const dvec3& low, const dvec3& high);

    /// The same from inside: a closed room.
    Triangles& room(const dvec3& low, const dvec3& high);

    /// Stairs up along +x from (x, 0): `steps` risers and treads, then a landing of `landing` metres.
    Triangles& stairs(double x, int steps, double rise, double tread, double half_width, double landing = 10);

    /// A slope up along +x from (x, 0) over `run` metres of level way.
    Triangles& ramp(double x, double run, double degrees, double half_width, int pieces = 1);
};

/// One body of a level.
struct LevelBody {
    Triangles triangles;
    Pose pose{};                              ///< at time 0
    std::function<Pose(double time)> path{};  ///< where it is at a time [s]; empty: it stands at `pose`
};

/// A body's number is its place here.
struct Level {
    std::vector<LevelBody> bodies;

    Level& add(Triangles triangles, const Pose& pose = {}, std::function<Pose(double)> path = {});
};

using LevelPointer = std::shared_ptr<const Level>;

/// The level of one standing body.
[[nodiscard]] LevelPointer level_of(Triangles triangles, const Pose& pose = {});

/// The level in a world of the core, for whoever asks it questions. Throws std::runtime_error for triangles that no
/// mesh can be made of.
class LevelWorld {
public:
    explicit LevelWorld(const Level& level);

    /// The bodies that move go to where they are at `time`; the tick before ended where it began.
    void move_to(double time);

    /// As above, with poses told by someone else: of all bodies, by number.
    void move_to(std::span<const Pose> poses);

    [[nodiscard]] const World& world() const { return world_; }

private:
    const Level* level_;
    World world_;
    std::vector<BodyHandle> handles_;
};

/// Where all bodies are at a time.
[[nodiscard]] std::vector<Pose> poses_at(const Level& level, double time);

/// Degrees to radians.
[[nodiscard]] constexpr double radians(double degrees) {
    return degrees * 0.017453292519943295;
}

}  // namespace surefoot::course
