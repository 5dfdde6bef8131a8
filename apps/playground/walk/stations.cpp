#include "playground/walk/stations.hpp"

#include <algorithm>
#include <filesystem>
#include <glm/geometric.hpp>
#include <optional>

#include <surefoot/pose.hpp>

namespace surefoot::playground {
namespace {

constexpr dvec3 north{0, 0, -1};
constexpr dvec3 south{0, 0, 1};
constexpr dvec3 east{1, 0, 0};

// levels/README.md has the map.
std::vector<Station> training_ground() {
    return {
        {"Start",
         {0, 0, 20},
         north,
         "Walk, run (Shift), jump (Space). The floor is cut into slivers; nothing is felt."},
        {"Stairs of 0.1 m", {-31.4, 0, 4.6}, north, "Up and down at a run: no bump, and the feet stay on the steps."},
        {"Stairs of 0.3 m",
         {-26.4, 0, 0.2},
         north,
         "Up diagonally, and along the side. The speed is that of the flat."},
        {"Stairs of 0.4 m", {-23.9, 0, -0.6}, north, "As high as step_up allows. A centimetre less, and it refuses."},
        {"Stairs of 0.5 m",
         {-21.4, 0, -0.2},
         north,
         "Too high: Why names the rule and the number. Jump, or raise step_up."},
        {"Ramp of 30 degrees", {20.3, 0, 2.6}, north, "Stand still half way up: it does not creep. Run down: no hops."},
        {"Ramp of 50 degrees",
         {25.2, 0, 0.2},
         north,
         "Just what slope_limit_deg allows. Lower it by a degree: it slides."},
        {"Ramp of 60 degrees", {27.65, 0, -0.4}, north, "Too steep. Jumping at it does not help either."},
        {"Ramp of ice", {16.85, 0, 5.2}, north, "Hardly any grip: it slides back. Grip of surfaces changes that."},
        {"Rink", {-7, 0, 4}, east, "Ice: run on to it and try to stop."},
        {"Inner corner of 90 degrees", {23.5, 0, 20.6}, north, "Walk into the corner: it comes to rest, to the bit."},
        {"Inner corner of 10 degrees", {18, 0, 26.5}, north, "A wedge: as far in as it fits, and no trembling."},
        {"Outer corner of 90 degrees", {-24.5, 0, 22}, north, "Walk against the tip: slides off to one side."},
        {"Thin walls of a centimetre", {-11, 0, -12.4}, north, "Dash (Q) at them. Speed does not get it through."},
        {"Walls without thickness", {10.4, 0, -12.4}, north, "Single triangles, seen from both sides."},
        {"Crevice", {-24, 0, -11.6}, north, "Run in: it ends where the body no longer fits, and comes out again."},
        {"Ledge of 1.2 m", {-28, 0, -12.3}, south, "Jump and reach: it hangs. Sideways goes along, forward climbs."},
        {"Low ceiling",
         {24.5, 0, -11.4},
         north,
         "1.9 m, 1.7 m, 1.2 m. Crouch (Control); it stands up where there is room."},
        {"Dome", {0, 0, -12.6}, north, "Walk up as far as the slope limit; jump on, and slide off."},
        {"Bridge of planks", {-18.4, 2.4, -7}, east, "Gaps of a centimetre: not felt by any of the six shapes."},
        {"Beam", {-18.4, 2.4, -9.33}, east, "0.25 m wide. Step off: perch_distance says when it slips."},
        {"Hills", {0, 0, 25.5}, south, "Run over crests: snap_down keeps it on the ground. Set that to 0."},
    };
}

/// The lowest ground below the middle of the level that has room for a person above it, so that a house is begun in and
/// not on its roof; else what is met first from above, else the middle itself.
Station below_the_middle(const Mesh& mesh) {
    const Bounds bounds = mesh.bounds();
    const dvec3 middle = (bounds.min + bounds.max) * 0.5;
    const dvec3 low(middle.x, bounds.min.y - 1, middle.z);
    dvec3 from(middle.x, bounds.max.y + 1, middle.z);
    std::optional<dvec3> first;
    std::optional<dvec3> lowest;
    constexpr int most_floors = 64;
    for (int i = 0; i < most_floors; ++i) {
        const auto hit = mesh.ray({from, low});
        if (!hit || hit->status != HitStatus::ok) break;
        if (!first) first = hit->point;
        const Triangle t = mesh.triangle(hit->triangle);
        constexpr double person = 2;  // [m]
        const dvec3 above = hit->point + dvec3(0, 0.05, 0);
        const bool faces_up = glm::cross(t.b - t.a, t.c - t.a).y > 0;
        if (faces_up && !mesh.ray_any({above, above + dvec3(0, person, 0)})) lowest = hit->point;
        from = hit->point - dvec3(0, 1e-3, 0);
    }
    return {"The middle", lowest ? *lowest : first.value_or(middle), north, "Walk, run (Shift), jump (Space)."};
}

}  // namespace

std::vector<Station> stations_of(const tools::Level& level) {
    if (std::filesystem::path(level.file).stem() == "training-ground") return training_ground();
    std::vector<Station> stations;
    for (const ImportedMarker& marker : level.markers) {
        constexpr std::size_t most = 64;
        const bool is_place = marker.kind == "spawn" || marker.kind == "goal" || marker.kind == "waypoint";
        if (!is_place || stations.size() == most) continue;
        dvec3 look = to_world(Pose{{0, 0, 0}, marker.orientation}, {0, 0, 1});  // the front of a node
        look.y = 0;
        const double length = glm::length(look);
        stations.push_back({marker.name.empty() ? marker.kind : marker.name, marker.position,
                            length > 0.1 ? look / length : north, "A place of the level's own."});
    }
    std::stable_sort(stations.begin(), stations.end(), [](const Station& a, const Station& b) {
        const auto begins = [](const Station& s) { return s.name.find("spawn") != std::string::npos; };
        return begins(a) && !begins(b);
    });
    if (stations.empty()) stations.push_back(below_the_middle(level.mesh));
    return stations;
}

}  // namespace surefoot::playground
