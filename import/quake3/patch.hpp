/// Curved surfaces: patches of quadratic Bezier curves, cut into triangles that lie within a tolerance of them.
///
/// Neighbouring patches share a boundary curve, control point by control point, and nothing else tells that they are
/// neighbours. So every patch is told of before the first is cut: curves that are the same get the same number of
/// pieces, from whichever end they are read, and their points come out the same to the bit. No cracks are left between
/// such patches. Where the file's curves differ, as where a long edge meets two short ones, it has cracks of its own.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include <surefoot/math.hpp>

namespace surefoot::internal::quake3 {

/// Control points row by row; width and height are odd and at least 3. Each 3 x 3 of them, sharing borders, is one
/// biquadratic surface.
struct Patch {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::vector<vec3> points;

    [[nodiscard]] const vec3& at(std::size_t column, std::size_t row) const { return points[row * width + column]; }
};

/// A patch cut into triangles, counter-clockwise when seen from the front.
struct PatchTriangles {
    std::vector<dvec3> points;
    std::vector<std::array<std::uint32_t, 3>> triangles;  ///< none has two corners at one place
};

class PatchCutter {
public:
    /// Requires: tolerance > 0, in the units of the control points.
    explicit PatchCutter(double tolerance) : tolerance_(tolerance) {}

    /// Tells of a patch with finite control points. False if its curves need more pieces than max_pieces.
    [[nodiscard]] bool add(const Patch& patch);

    /// Decides the number of pieces of every curve, after the last `add`.
    void settle();

    /// How many triangles `cut` makes of the patch that was added as number `index`, at most, once all is settled.
    [[nodiscard]] std::uint64_t triangle_count(std::size_t index, std::uint32_t width, std::uint32_t height) const;

    /// Requires: `patch` is the one that was added as number `index`, and settle() was called.
    [[nodiscard]] PatchTriangles cut(std::size_t index, const Patch& patch) const;

    static constexpr std::uint32_t max_pieces = 1024;  ///< of one curve

private:
    /// A boundary curve of some 3 x 3, read from its smaller end, and the strip that cuts it.
    struct Curve {
        std::array<std::uint32_t, 9> bits{};
        std::uint32_t strip = 0;
    };

    void add_curve(const vec3& a, const vec3& b, const vec3& c, std::uint32_t strip);
    [[nodiscard]] std::vector<std::uint32_t> pieces(std::uint32_t first_strip, std::size_t count) const;

    double tolerance_;
    // A strip is a row or a column of 3 x 3s, which has one number of pieces all along.
    std::vector<std::uint32_t> first_strips_;  ///< of each patch: its columns, then its rows
    std::vector<std::uint32_t> needed_;        ///< of each strip: how many pieces
    std::vector<Curve> curves_;
};

}  // namespace surefoot::internal::quake3
