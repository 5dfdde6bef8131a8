/// The six shapes on the course: each as high and as wide as the capsule of a scene, and what bars ask of their
/// geometry. Bars and spots speak of the centre of a body, the middle of its height above its lowest point, whatever
/// its reference point is.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include <surefoot/character_settings.hpp>
#include <surefoot/math.hpp>

namespace surefoot::course {

enum class BodyShape : std::uint8_t { capsule, ellipsoid, sphere, box, cylinder, cone };

struct ShapeName {
    BodyShape shape;
    std::string_view name;
    std::string_view about;
};

[[nodiscard]] std::span<const ShapeName> shapes();

/// Such a body, as high and as wide as the capsule. A ball cannot be both: it is as wide.
[[nodiscard]] Volume volume_as(BodyShape shape, const Capsule& capsule);

/// The capsule of these settings. Requires: `volume` is one.
[[nodiscard]] Capsule capsule_of(const CharacterSettings& settings);

/// How high the centre is above level ground that it stands on, without any gap: half of its height [m].
[[nodiscard]] double standing(const CharacterSettings& settings);

/// How far level ground is kept from its lowest point: a skin, and under an apex what a skin along its sides leaves
/// [m].
[[nodiscard]] double gap_below(const CharacterSettings& settings);

/// Half of its width [m].
[[nodiscard]] double half_width(const CharacterSettings& settings);

/// How far it reaches from its centre along a direction of unit length [m].
[[nodiscard]] double reach(const CharacterSettings& settings, const dvec3& direction);

/// From the centre to the reference point [m]: nothing but for a cone, whose apex is that.
[[nodiscard]] dvec3 reference_from_centre(const CharacterSettings& settings);

/// How far below its centre the point is that touches ground of so many degrees [m].
[[nodiscard]] double touches_below(const CharacterSettings& settings, double degrees);

/// From how high above its lowest point it has its whole width: the end that rolls off an edge [m].
[[nodiscard]] double tapered_end(const CharacterSettings& settings);

/// How much lower than on level ground it is when an edge holds it at this distance from its axis, both a skin apart
/// [m].
[[nodiscard]] double dip(const CharacterSettings& settings, double distance);

/// A body and `by` more all round, sharp edges kept sharp, and where its reference point is from the centre.
struct GrownBody {
    Volume volume;
    dvec3 reference{0, 0, 0};
};
[[nodiscard]] GrownBody grown_body(const CharacterSettings& settings, double by);

}  // namespace surefoot::course
