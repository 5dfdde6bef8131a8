// Samples at h, 2h, 3h, ... miss a stretch [a, b] if and only if some k >= 0 has k h < a and (k + 1) h > b. So h can
// only begin to miss everything just above some b / m, m = k + 1; and to have no sample in the longest stretch it must
// be larger than that is long, which leaves a few m to try.
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <glm/geometric.hpp>

#include <surefoot/sweep.hpp>

#include "debugger/equation.hpp"
#include "debugger/strategies.hpp"

namespace surefoot::debugger {

namespace {

/// The stretch that one triangle makes. It is one, because both are convex.
std::optional<TouchingPart> part_of(const Volume& volume, const Motion& motion, const Triangle& triangle,
                                    double length) {
    const bool at_start = overlap(volume, motion.from, triangle).has_value();
    const bool at_end = overlap(volume, motion.to, triangle).has_value();
    const auto ahead = sweep(volume, motion, triangle);
    const auto back = sweep(volume, {motion.to, motion.from}, triangle);
    if (!at_start && !ahead) return std::nullopt;
    TouchingPart part{0, length};
    if (!at_start) part.begin = ahead->t * length;
    if (!at_end) part.end = back ? (1 - back->t) * length : part.begin;
    return part;
}

/// What `overlap` leaves of it when it is one-sided: while the reference point is not behind the triangle's plane.
std::optional<TouchingPart> in_front(TouchingPart part, const Motion& motion, const Triangle& triangle, double length) {
    const dvec3 normal = glm::cross(triangle.b - triangle.a, triangle.c - triangle.a);
    const double height = glm::dot(motion.from - triangle.a, normal);
    const double rise = glm::dot(motion.to - motion.from, normal);
    if (normal == dvec3(0, 0, 0)) return part;
    if (rise == 0) return height >= 0 ? std::optional(part) : std::nullopt;
    const double crossing = -height / rise * length;
    if (rise < 0) part.end = std::min(part.end, crossing);
    if (rise > 0) part.begin = std::max(part.begin, crossing);
    return part.begin <= part.end ? std::optional(part) : std::nullopt;
}

std::vector<TouchingPart> joined(std::vector<TouchingPart> parts) {
    std::sort(parts.begin(), parts.end(),
              [](const TouchingPart& a, const TouchingPart& b) { return a.begin < b.begin; });
    std::vector<TouchingPart> together;
    for (const TouchingPart& part : parts) {
        if (together.empty() || part.begin > together.back().end)
            together.push_back(part);
        else
            together.back().end = std::max(together.back().end, part.end);
    }
    return together;
}

/// Has this step, or one that is larger by nothing to speak of, no sample in any part?
bool misses_all(const std::vector<TouchingPart>& parts, double step) {
    const double more = step * (1 + 1e-12);
    return std::none_of(parts.begin(), parts.end(), [&](const TouchingPart& part) {
        return std::max(1.0, std::ceil(part.begin / more)) * more <= part.end;
    });
}

std::string in_words(const Tunnelling& found, bool anything, double speed) {
    if (!anything) return "There is nothing in the way to tunnel through.";
    if (!found.begins_above) return "END itself is in touch, so no step misses everything.";
    return fmt::format("Tunnelling begins at {} m, below {} frames a second at {} m/s.",
                       short_text(*found.begins_above), short_text(speed / *found.begins_above), short_text(speed));
}

}  // namespace

std::vector<TouchingPart> touching_parts(const Arena& arena, const Volume& volume, const Motion& motion,
                                         bool one_sided) {
    const double length = glm::length(motion.to - motion.from);
    std::vector<TouchingPart> parts;
    for (const Triangle& triangle : arena.along(volume, motion)) {
        auto part = part_of(volume, motion, triangle, length);
        if (part && one_sided) part = in_front(*part, motion, triangle, length);
        if (part) parts.push_back(*part);
    }
    return joined(std::move(parts));
}

Tunnelling tunnelling(const std::vector<TouchingPart>& parts, double length, double metres_per_second) {
    Tunnelling found;
    const bool end_touches = !parts.empty() && parts.back().end >= length;
    if (!parts.empty() && !end_touches) {
        double longest = 0;
        for (const TouchingPart& part : parts) longest = std::max(longest, part.end - part.begin);
        double least = parts.back().end;  // with a larger step the first sample lies beyond everything
        for (const TouchingPart& part : parts) {
            const double most = std::min(1e6, longest > 0 ? std::floor(part.end / longest) : 1e6);
            for (double m = most; m >= 1 && part.end / m < least; --m)
                if (misses_all(parts, part.end / m)) least = part.end / m;
        }
        found.begins_above = least;
        found.always_above = parts.back().end;
    }
    found.text = in_words(found, !parts.empty(), metres_per_second);
    return found;
}

}  // namespace surefoot::debugger
