/// A path from a file: lines of x,y,z.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <surefoot/math.hpp>

namespace surefoot::tools {

/// Straight pieces between points, each taking the same share of t; a callable `dvec3(double)` for a march.
struct Polyline {
    std::vector<dvec3> points;  ///< at least two

    [[nodiscard]] std::uint32_t segments() const { return static_cast<std::uint32_t>(points.size() - 1); }
    [[nodiscard]] dvec3 operator()(double t) const;
};

/// Reads lines x,y,z; blank lines, comments from # on, and a heading on the first line are passed over. Throws
/// `Failure` that names the line.
[[nodiscard]] Polyline read_polyline(const std::string& file);

}  // namespace surefoot::tools
