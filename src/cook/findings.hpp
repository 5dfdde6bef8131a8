// What is odd about the triangles of a level.
#pragma once

#include <surefoot/cook.hpp>

#include "cook/soup.hpp"
#include "mesh/edges.hpp"

namespace surefoot::internal {

/// Degenerate triangles, and edges that are open, shared by too many, or between triangles that face opposite ways.
void find_faults(const Soup& soup, const EdgeMatches& matches, std::size_t most_places, CookReport& report);

/// Corners that lie on an open edge of another triangle, within the tolerance or what floats cannot express.
void find_t_junctions(const Soup& soup, const EdgeMatches& matches, const CookOptions& options, CookReport& report);

inline void add_place(Finding& finding, std::uint32_t triangle, const Vec& point, std::size_t most_places) {
    ++finding.count;
    if (finding.places.size() < most_places) finding.places.push_back({triangle, to_dvec3(point)});
}

}  // namespace surefoot::internal
