/// What of a question can be taken by the hand, and how a hand moves it. Without a window: a camera is all it needs.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <surefoot/bounds.hpp>
#include <surefoot/shapes.hpp>

#include "debugger/history.hpp"
#include "debugger/question.hpp"
#include "view/camera.hpp"

namespace surefoot::playground {

/// What moves: one of both ends, or a corner of a triangle.
struct Target {
    enum class Kind : std::uint8_t { start, end, corner };
    Kind kind = Kind::start;
    std::size_t triangle = 0;
    std::size_t corner = 0;

    [[nodiscard]] bool operator==(const Target&) const = default;
};

[[nodiscard]] dvec3 place_of(const Target& target, const debugger::Question& question);
[[nodiscard]] debugger::Edit moved_to(const Target& target, const dvec3& place);

/// Something to take hold of. It is a body in the world, so that the library's own sweep finds it under the pointer.
struct Grip {
    enum class Kind : std::uint8_t {
        body,    ///< the target itself: moves in the plane that faces the eye
        corner,  ///< the same
        arrow,   ///< of the gizmo: moves along one axis
        face,    ///< a handle on a face of the shape's bounding box: moves in that face's plane
    };
    Kind kind = Kind::body;
    Target target;
    int axis = 0;           ///< of a face's normal or an arrow: 0 is x
    double towards = 1;     ///< which of the two faces of that axis: -1 or 1
    Volume volume{};        ///< what is swept against
    dvec3 place{0, 0, 0};   ///< of it
    dvec3 handle{0, 0, 0};  ///< where it is drawn: the tip of an arrow, the middle of a handle

    [[nodiscard]] bool is_same(const Grip& other) const {
        return kind == other.kind && target == other.target && axis == other.axis && towards == other.towards;
    }
};

/// The box whose faces carry the handles of START or END, somewhat wider than the shape.
[[nodiscard]] Bounds box_around(const Target& target, const debugger::Question& question);

/// From where the arrows of a target begin: the middle of the shape, or the corner.
[[nodiscard]] dvec3 gizmo_middle(const Target& target, const debugger::Question& question);

/// All grips: both ends and all corners, and of the target that is selected the arrows and the handles.
[[nodiscard]] std::vector<Grip> grips_of(const debugger::Question& question, const std::optional<Target>& selected,
                                         const view::Camera& camera, const view::ivec2& size);

struct Grabbed {
    Grip grip;
    dvec3 at{0, 0, 0};  ///< where the pointer's ray touches it
};

/// What is under the pointer. Handles go before arrows, these before corners, and corners before bodies, for the small
/// ones are drawn over the large ones; among equals the nearest.
[[nodiscard]] std::optional<Grabbed> grab(std::span<const Grip> grips, const view::Camera& camera,
                                          const view::dvec2& at, const view::ivec2& size);

/// A grip in the hand.
class Drag {
public:
    Drag(const Grabbed& grabbed, const debugger::Question& question)
        : grabbed_(grabbed), began_(place_of(grabbed.grip.target, question)) {}

    [[nodiscard]] const Grip& grip() const { return grabbed_.grip; }

    /// Where the target is to be with the pointer there; nothing where the pointer's ray does not meet the plane. With
    /// `grid` above 0, what moves is snapped to its multiples.
    [[nodiscard]] std::optional<dvec3> to(const view::Camera& camera, const view::dvec2& at, const view::ivec2& size,
                                          double grid) const;

private:
    Grabbed grabbed_;
    dvec3 began_;
};

}  // namespace surefoot::playground
