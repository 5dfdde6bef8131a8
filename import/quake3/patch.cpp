// How many pieces: D. Filip, R. Magedson, R. Markot, "Surface algorithms using bounds on derivatives", 1986. Over a
// triangle of the parameter plane that is du wide and dv high, the flat triangle through the three points of the
// surface lies within
//     (|f_uu| du^2 + 2 |f_uv| du dv + |f_vv| dv^2) / 8
// of it, with the largest second derivatives. Of a biquadratic Bezier surface those are bounded by its control points:
// f_uu by 2 (P0 - 2 P1 + P2) along each row, f_uv by 4 (P00 - P01 - P10 + P11) of each cell.
#include "patch.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>

namespace surefoot::internal::quake3 {
namespace {

dvec3 wide(const vec3& v) {
    return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}

double length(const dvec3& v) {
    return std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
}

/// Bounds on the second derivatives of one 3 x 3.
struct Bend {
    double uu = 0;
    double uv = 0;
    double vv = 0;
};

Bend bend_of(const Patch& patch, std::size_t column, std::size_t row) {
    const auto p = [&](std::size_t i, std::size_t k) { return wide(patch.at(column + i, row + k)); };
    Bend bend;
    for (std::size_t i = 0; i < 3; ++i) {
        bend.uu = std::max(bend.uu, 2 * length(p(0, i) - 2.0 * p(1, i) + p(2, i)));
        bend.vv = std::max(bend.vv, 2 * length(p(i, 0) - 2.0 * p(i, 1) + p(i, 2)));
    }
    for (std::size_t i = 0; i < 2; ++i) {
        for (std::size_t k = 0; k < 2; ++k)
            bend.uv = std::max(bend.uv, 4 * length(p(i, k) - p(i + 1, k) - p(i, k + 1) + p(i + 1, k + 1)));
    }
    return bend;
}

struct Pieces {
    std::uint32_t along_u = 1;
    std::uint32_t along_v = 1;
};

/// The fewest that keep within the tolerance, as far as growing one or the other by one can find them.
std::optional<Pieces> pieces_for(const Bend& bend, double tolerance) {
    const auto alone = [&](double second) { return std::ceil(std::sqrt(second / (8 * tolerance))); };
    const double most = PatchCutter::max_pieces;
    double u = std::max(1.0, alone(bend.uu));
    double v = std::max(1.0, alone(bend.vv));
    while (u <= most && v <= most) {
        const double from_u = bend.uu / (u * u);
        const double from_v = bend.vv / (v * v);
        const double from_twist = 2 * bend.uv / (u * v);
        if (from_u + from_twist + from_v <= 8 * tolerance)
            return Pieces{static_cast<std::uint32_t>(u), static_cast<std::uint32_t>(v)};
        // What one more piece takes away, to first order.
        const bool grow_u = (2 * from_u + from_twist) / u >= (2 * from_v + from_twist) / v;
        (grow_u ? u : v) += 1;
    }
    return std::nullopt;
}

/// The point i of n along the curve. Symmetric to the bit: i of n from one end is n - i of n from the other. The ends
/// are the ends, however many pieces there are in between.
dvec3 along(const dvec3& a, const dvec3& b, const dvec3& c, std::uint32_t i, std::uint32_t n) {
    if (i == 0) return a;
    if (i == n) return c;
    const double s = i;
    const double r = n - i;
    const double all = static_cast<double>(n) * n;
    return ((r * r * a + s * s * c) + 2 * r * s * b) / all;
}

/// Every sample along a row or a column of 3 x 3s: which of them, and which of its pieces.
struct Sample {
    std::size_t strip = 0;
    std::uint32_t i = 0;
    std::uint32_t n = 1;
};

std::vector<Sample> samples_of(const std::vector<std::uint32_t>& pieces) {
    std::vector<Sample> samples{{.strip = 0, .i = 0, .n = pieces.front()}};
    for (std::size_t strip = 0; strip < pieces.size(); ++strip) {
        for (std::uint32_t i = 1; i <= pieces[strip]; ++i)
            samples.push_back({.strip = strip, .i = i, .n = pieces[strip]});
    }
    return samples;
}

double squared_distance(const dvec3& a, const dvec3& b) {
    const dvec3 d = b - a;
    return d.x * d.x + d.y * d.y + d.z * d.z;
}

}  // namespace

void PatchCutter::add_curve(const vec3& a, const vec3& b, const vec3& c, std::uint32_t strip) {
    // The tip of a cone is no curve that anyone shares.
    if (a == b && b == c) return;
    const auto bits_of = [](const vec3& p, const vec3& q, const vec3& r) {
        std::array<std::uint32_t, 9> bits{};
        std::size_t next = 0;
        // Adding zero makes a negative zero a positive one, which is the same place.
        for (const vec3& point : {p, q, r}) {
            for (const float x : {point.x, point.y, point.z}) bits[next++] = std::bit_cast<std::uint32_t>(x + 0.0f);
        }
        return bits;
    };
    curves_.push_back({.bits = std::min(bits_of(a, b, c), bits_of(c, b, a)), .strip = strip});
}

bool PatchCutter::add(const Patch& patch) {
    const std::size_t columns = patch.width / 2;
    const std::size_t rows = patch.height / 2;
    const auto first = static_cast<std::uint32_t>(needed_.size());
    first_strips_.push_back(first);
    needed_.resize(first + columns + rows, 1);
    for (std::size_t row = 0; row < rows; ++row) {
        for (std::size_t column = 0; column < columns; ++column) {
            const auto pieces = pieces_for(bend_of(patch, 2 * column, 2 * row), tolerance_);
            if (!pieces) return false;
            std::uint32_t& u = needed_[first + column];
            std::uint32_t& v = needed_[first + columns + row];
            u = std::max(u, pieces->along_u);
            v = std::max(v, pieces->along_v);
        }
    }
    for (std::size_t row = 0; row < patch.height; row += 2) {
        for (std::size_t k = 0; k < columns; ++k) {
            add_curve(patch.at(2 * k, row), patch.at(2 * k + 1, row), patch.at(2 * k + 2, row),
                      first + static_cast<std::uint32_t>(k));
        }
    }
    for (std::size_t column = 0; column < patch.width; column += 2) {
        for (std::size_t k = 0; k < rows; ++k) {
            add_curve(patch.at(column, 2 * k), patch.at(column, 2 * k + 1), patch.at(column, 2 * k + 2),
                      first + static_cast<std::uint32_t>(columns + k));
        }
    }
    return true;
}

void PatchCutter::settle() {
    // Strips that share a curve, directly or through others, are a set, which the first of them stands for: the way to
    // it leads through parents, each an earlier strip.
    std::vector<std::uint32_t> parents(needed_.size());
    std::iota(parents.begin(), parents.end(), 0u);
    const auto find = [&](std::uint32_t strip) {
        // Halving the way each time it is walked keeps it short.
        while (parents[strip] != strip) strip = parents[strip] = parents[parents[strip]];
        return strip;
    };
    std::ranges::sort(curves_, {}, [](const Curve& curve) { return std::pair(curve.bits, curve.strip); });
    for (std::size_t i = 1; i < curves_.size(); ++i) {
        if (curves_[i].bits != curves_[i - 1].bits) continue;
        const auto [first, second] = std::minmax({find(curves_[i - 1].strip), find(curves_[i].strip)});
        parents[second] = first;
        needed_[first] = std::max(needed_[first], needed_[second]);
    }
    for (std::uint32_t strip = 0; strip < needed_.size(); ++strip) needed_[strip] = needed_[find(strip)];
    curves_.clear();
}

std::vector<std::uint32_t> PatchCutter::pieces(std::uint32_t first_strip, std::size_t count) const {
    const auto first = needed_.begin() + first_strip;
    return {first, first + static_cast<std::ptrdiff_t>(count)};
}

std::uint64_t PatchCutter::triangle_count(std::size_t index, std::uint32_t width, std::uint32_t height) const {
    const auto total = [](const std::vector<std::uint32_t>& all) {
        return std::accumulate(all.begin(), all.end(), std::uint64_t{0});
    };
    const std::uint32_t first = first_strips_[index];
    return 2 * total(pieces(first, width / 2)) * total(pieces(first + width / 2, height / 2));
}

PatchTriangles PatchCutter::cut(std::size_t index, const Patch& patch) const {
    const std::uint32_t first = first_strips_[index];
    const std::vector<Sample> columns = samples_of(pieces(first, patch.width / 2));
    const std::vector<Sample> rows = samples_of(pieces(first + patch.width / 2, patch.height / 2));

    PatchTriangles result;
    result.points.reserve(columns.size() * rows.size());
    for (const Sample& v : rows) {
        for (const Sample& u : columns) {
            std::array<dvec3, 3> across{};
            for (std::size_t k = 0; k < 3; ++k) {
                const std::size_t row = 2 * v.strip + k;
                across[k] = along(wide(patch.at(2 * u.strip, row)), wide(patch.at(2 * u.strip + 1, row)),
                                  wide(patch.at(2 * u.strip + 2, row)), u.i, u.n);
            }
            result.points.push_back(along(across[0], across[1], across[2], v.i, v.n));
        }
    }
    const auto add = [&](std::size_t a, std::size_t b, std::size_t c) {
        const auto& p = result.points;
        if (p[a] == p[b] || p[b] == p[c] || p[c] == p[a]) return;
        result.triangles.push_back(
            {static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b), static_cast<std::uint32_t>(c)});
    };
    for (std::size_t row = 0; row + 1 < rows.size(); ++row) {
        for (std::size_t column = 0; column + 1 < columns.size(); ++column) {
            const std::size_t a = row * columns.size() + column;
            const std::size_t b = a + 1;
            const std::size_t c = a + columns.size();
            const std::size_t d = c + 1;
            // The front is where columns go right and rows go up. The shorter diagonal makes the better triangles.
            if (squared_distance(result.points[a], result.points[d]) <=
                squared_distance(result.points[b], result.points[c])) {
                add(a, d, c);
                add(a, b, d);
            } else {
                add(a, b, c);
                add(b, d, c);
            }
        }
    }
    return result;
}

}  // namespace surefoot::internal::quake3
