/// A walk through a level that nobody prepared: where to stand, where to go, what is met on the way.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include <surefoot/hit.hpp>
#include <surefoot/mesh.hpp>

namespace surefoot::tools {

/// Why a sweep of the route was made.
enum class Step : std::uint8_t { walk, drop, climb };

/// One sweep of the route.
struct Leg {
    Motion motion;
    std::optional<Hit> hit;
    Step step = Step::walk;
    double seconds = 0;  ///< of this sweep alone, the median of several [s]
};

struct Route {
    std::vector<Leg> legs;
    std::size_t probes = 0;  ///< sweeps that only looked where to go next; they are not legs

    [[nodiscard]] std::size_t contacts(Feature feature) const;
};

struct Walker {
    Volume volume;
    dvec3 half_size{0.4, 0.9, 0.4};  ///< half the box around the volume [m]
    bool one_sided = false;
    std::size_t legs = 40;
};

/// Places where the walker can stand, found by rays down a grid over the level, floor under floor.
[[nodiscard]] std::vector<dvec3> standing_places(const Mesh& mesh, const Walker& walker);

/// Walks from `start`: ahead until something is met, over it if it is low, else along another way; after each step down
/// to the floor. Goes through `waypoints` in order if there are any. The same every time.
[[nodiscard]] Route walk_from(const Mesh& mesh, const Walker& walker, const dvec3& start,
                              std::span<const dvec3> waypoints);

/// The walk from the place among `places` that meets most: far, and with floors, walls, edges and corners.
[[nodiscard]] Route best_route(const Mesh& mesh, const Walker& walker, std::span<const dvec3> places,
                               std::span<const dvec3> waypoints);

/// Fills in `seconds` by sweeping each leg again.
void measure(const Mesh& mesh, const Walker& walker, Route& route);

[[nodiscard]] std::string_view word(Step step);

}  // namespace surefoot::tools
