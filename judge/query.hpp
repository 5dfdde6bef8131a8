/// The judge's own words for a query and an answer. Nothing here, or anywhere in this folder, comes from the library
/// under judgement: the two meet only in the program or test that hands the answers over.
#pragma once

#include <cstdint>

namespace judge {

struct Vec {
    double x = 0, y = 0, z = 0;
};

enum class Kind : std::uint8_t { sphere, ellipsoid, capsule, box, cylinder, cone };
inline constexpr int kind_count = 6;

enum class Feature : std::uint8_t { face, edge, vertex };
enum class Status : std::uint8_t { ok, invalid, overflow };

/// A shape moves its reference point from `from` to `to`; when does it first touch the triangle a, b, c?
struct Query {
    Kind kind = Kind::sphere;
    /// sphere: {r, -, -}; ellipsoid: radii; box: half extents; capsule, cylinder: {r, half height, -};
    /// cone: {r, height, -}. [m]
    Vec size;
    double qw = 1, qx = 0, qy = 0, qz = 0;  ///< orientation, of any length but zero
    Vec from, to;
    Vec a, b, c;
    bool one_sided = false;
};

struct Answer {
    bool hit = false;
    double t = 0;
    Vec normal, point;
    Feature feature = Feature::face;
    Status status = Status::ok;
    bool started_inside = false;
};

/// The name of a shape as the command line spells it.
[[nodiscard]] const char* name_of(Kind kind) noexcept;

/// How many numbers of `Query::size` the shape uses.
[[nodiscard]] int size_count(Kind kind) noexcept;

/// Within the limits that the promise is made for?
[[nodiscard]] bool is_valid(const Query& query) noexcept;

/// The largest coordinate or dimension in the query: what the bound on the gap is relative to.
[[nodiscard]] double largest(const Query& query) noexcept;

/// The largest dimension of the shape.
[[nodiscard]] double largest_dimension(const Query& query) noexcept;

}  // namespace judge
