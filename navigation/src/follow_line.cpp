#include "follow_line.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace surefoot::navigation {
namespace {

using Points = std::vector<NavigationLine::Point>;

/// The last point that is not beyond `along`; never the very last one of a line of several.
std::size_t segment_at(const Points& points, double along) {
    const auto beyond = std::upper_bound(points.begin(), points.end(), along,
                                         [](double a, const NavigationLine::Point& point) { return a < point.along; });
    const auto count = static_cast<std::size_t>(beyond - points.begin());
    return std::min(count == 0 ? 0 : count - 1, points.size() < 2 ? 0 : points.size() - 2);
}

}  // namespace

void append(NavigationLine& line, const dvec3& place, std::optional<std::uint32_t> link) {
    const double along =
        line.points.empty() ? 0 : line.points.back().along + length(place - line.points.back().position);
    line.points.push_back({.position = place, .along = along, .link = link});
}

NavigationLine pulled_line(const NavigationPath& path) {
    NavigationLine line;
    for (const NavigationCorner& corner : path.corners) append(line, corner.position, corner.link);
    return line;
}

NavigationLine middle_line(const NavigationPath& path) {
    NavigationLine line;
    // midpoints[i + 1] lies in the portal between polygons[i] and [i + 1]; a link begins in the one that enters it.
    for (std::size_t i = 0; i < path.midpoints.size(); ++i) {
        std::optional<std::uint32_t> link;
        if (i > 0 && i < path.polygons.size())
            for (const NavigationCorner& corner : path.corners)
                if (corner.link && corner.polygon == path.polygons[i]) link = corner.link;
        append(line, path.midpoints[i], link);
    }
    return line;
}

NavigationLine line_from(const dvec3& place, const NavigationLine& line) {
    NavigationLine whole;
    append(whole, place);
    for (const NavigationLine::Point& point : line.points) append(whole, point.position, point.link);
    return whole;
}

NavigationLine without_loops(const NavigationLine& line, double cell) {
    using Cell = std::array<std::int64_t, 3>;
    std::map<Cell, std::size_t> known;  // which of the kept points lies in it
    std::vector<Cell> cells;
    std::vector<NavigationLine::Point> kept;
    for (const NavigationLine::Point& point : line.points) {
        Cell at{};
        for (int axis = 0; axis < 3; ++axis)
            at[static_cast<std::size_t>(axis)] = static_cast<std::int64_t>(std::floor(point.position[axis] / cell));
        const auto before = known.find(at);
        const auto is_link = [](const NavigationLine::Point& p) { return p.link.has_value(); };
        if (before != known.end() &&
            std::none_of(kept.begin() + static_cast<std::ptrdiff_t>(before->second), kept.end(), is_link)) {
            const std::size_t first = before->second;
            for (std::size_t i = first; i < kept.size(); ++i) known.erase(cells[i]);
            kept.resize(first);
            cells.resize(first);
        }
        known[at] = kept.size();
        kept.push_back(point);
        cells.push_back(at);
    }
    NavigationLine result;
    for (const NavigationLine::Point& point : kept) append(result, point.position, point.link);
    return result;
}

dvec3 place_on(const NavigationLine& line, double along) {
    const Points& points = line.points;
    if (points.empty()) return {0, 0, 0};
    if (points.size() == 1 || along <= 0) return points.front().position;
    const std::size_t i = segment_at(points, along);
    const double size = points[i + 1].along - points[i].along;
    const double share = size > 0 ? std::clamp((along - points[i].along) / size, 0.0, 1.0) : 1;
    return points[i].position + (points[i + 1].position - points[i].position) * share;
}

NearestOnLine nearest_on(const NavigationLine& line, const dvec3& place, const dvec3& up, double begin, double end) {
    const Points& points = line.points;
    NearestOnLine best{.along = begin, .distance = length(level(place_on(line, begin) - place, up))};
    if (points.size() < 2) return best;
    for (std::size_t i = segment_at(points, begin); i + 1 < points.size() && points[i].along <= end; ++i) {
        const dvec3 side = points[i + 1].position - points[i].position;
        const dvec3 flat = level(side, up);
        const double squared = dot(flat, flat);
        const double size = points[i + 1].along - points[i].along;
        double share = squared > 0 ? dot(place - points[i].position, flat) / squared : 0;
        const double along = std::clamp(points[i].along + std::clamp(share, 0.0, 1.0) * size, begin, end);
        share = size > 0 ? (along - points[i].along) / size : 0;
        const double distance = length(level(points[i].position + side * share - place, up));
        if (distance < best.distance) best = {.along = along, .distance = distance};
    }
    return best;
}

double next_stop(const NavigationLine& line, double along) {
    for (const NavigationLine::Point& point : line.points)
        if (point.link && point.along >= along - 1e-6) return point.along;
    return line.length();
}

double speed_here(const NavigationLine& line, const dvec3& up, double along, double stop, double deceleration,
                  double drift, double most) {
    const auto braking_from = [&](double speed, double distance) {
        return std::sqrt(speed * speed + 2 * deceleration * std::max(distance, 0.0));
    };
    double speed = std::min(most, braking_from(0, stop - along));
    const Points& points = line.points;
    if (points.size() < 3) return speed;
    for (std::size_t i = segment_at(points, along) + 1; i + 1 < points.size() && points[i].along < stop; ++i) {
        if (braking_from(0, points[i].along - along) >= speed) break;  // even a stop there asks for no less here
        const dvec3 before = level(points[i].position - points[i - 1].position, up);
        const dvec3 after = level(points[i + 1].position - points[i].position, up);
        const double sizes = length(before) * length(after);
        if (!(sizes > 0)) continue;
        const double cosine = dot(before, after) / sizes;
        // What has to be lost is the part of the velocity across the new way; all of it, where the way turns back.
        const double across = cosine <= 0 ? 1 : std::sqrt(std::max(0.0, 1 - cosine * cosine));
        if (!(across > 1e-3)) continue;
        speed = std::min(speed, braking_from(std::sqrt(2 * deceleration * drift) / across, points[i].along - along));
    }
    return speed;
}

}  // namespace surefoot::navigation
