/// A character controller on the course. Ours, Bullet's, broken ones, or any program that speaks the line protocol.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "course/scene.hpp"

namespace surefoot::course {

/// What a mover answers: where its centre is after the tick, and whether it stands on ground.
struct Answer {
    dvec3 position{0, 0, 0};
    bool grounded = false;
};

/// Moves one character at a time. A mover that cannot go on throws `MoverFailure`.
class Mover {
public:
    Mover() = default;
    Mover(const Mover&) = delete;
    Mover& operator=(const Mover&) = delete;
    virtual ~Mover() = default;

    /// Can it move such a body? Most have a capsule and nothing else.
    [[nodiscard]] virtual bool takes(const Shape& shape) const { return std::holds_alternative<Capsule>(shape); }

    /// Forgets the run before and puts the character at the start of this one. The run outlives the walk.
    virtual void load(const Run& run) = 0;

    /// One tick. `poses` are those of all bodies at its end, by number; at its start they are where they were.
    [[nodiscard]] virtual Answer tick(const Input& input, double dt, std::span<const Pose> poses) = 0;
};

struct MoverFailure {
    std::string text;
};

/// A mover that comes with the course.
struct MoverName {
    std::string_view name;
    std::string_view about;
    bool is_broken = false;  ///< on purpose
};

[[nodiscard]] std::span<const MoverName> movers();

/// Null for a name that is none of these, and for a peer whose library was missing when this was built.
[[nodiscard]] std::unique_ptr<Mover> make_mover(std::string_view name);

/// A program of somebody's that speaks the line protocol (docs/course-protocol.md), started by the shell.
/// It is waited for that long before each answer [s]. Throws `MoverFailure` when it does not start.
[[nodiscard]] std::unique_ptr<Mover> make_external_mover(const std::string& command, double patience = 60);

/// What is missing and how to get it; empty if nothing is.
[[nodiscard]] std::string_view bullet_missing();

}  // namespace surefoot::course
