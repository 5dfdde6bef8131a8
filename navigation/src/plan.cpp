#include "plan.hpp"

#include <algorithm>
#include <limits>
#include <numbers>

#include "link_proposals.hpp"

namespace surefoot::navigation {
namespace {

Error invalid(std::string text) {
    return {.code = ErrorCode::invalid, .text = std::move(text), .file = {}};
}

bool is_finite(const dvec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// The box in the frame around all bodies that stand and are of these layers.
struct Extent {
    dvec3 min{std::numeric_limits<double>::infinity()};
    dvec3 max{-std::numeric_limits<double>::infinity()};

    void take(const dvec3& place) {
        for (int axis = 0; axis < 3; ++axis) {
            min[axis] = std::min(min[axis], place[axis]);
            max[axis] = std::max(max[axis], place[axis]);
        }
    }
    [[nodiscard]] bool is_empty() const { return min.x > max.x; }
};

std::vector<BodyPose> standing_bodies(const World& world, std::uint64_t layers) {
    std::vector<BodyPose> poses(world.body_count());
    poses.resize(world.save_poses(poses, layers));
    std::erase_if(poses, [](const BodyPose& pose) {
        return pose.start.position != pose.end.position || pose.start.orientation != pose.end.orientation;
    });
    return poses;
}

Extent extent_of(const World& world, std::uint64_t layers, const Frame& frame) {
    Extent extent;
    for (const BodyPose& body : standing_bodies(world, layers)) {
        const Bounds box = world.source(world.find(body.body))->bounds();
        for (int corner = 0; corner < 8; ++corner) {
            const dvec3 place{corner & 1 ? box.max.x : box.min.x, corner & 2 ? box.max.y : box.min.y,
                              corner & 4 ? box.max.z : box.min.z};
            extent.take(frame.turned_in(to_world(body.start, place) - frame.origin));
        }
    }
    return extent;
}

/// So wide that what the character jumps and drops ends in the next tile at the latest.
int chosen_tile_cells(const CharacterSettings& settings, double cell_size) {
    constexpr int least = 96;
    constexpr int most = 1024;
    constexpr double run_up = 1.2;  // from where a link begins to where the feet leave, and from there to where it ends
    const NavigationLinkOptions usual;
    const double longest =
        run_up + jump_range(settings, usual.run_speed, -usual.deepest_drop, most_air_jumps(settings));
    return static_cast<int>(std::clamp(std::ceil(longest / cell_size), double{least}, double{most}));
}

bool is_usable(const NavigationAgent& agent) {
    return agent.radius > 0 && agent.height > 0 && agent.climb >= 0 && agent.slope_limit_deg >= 0 &&
           agent.slope_limit_deg <= 89 && is_finite({agent.radius, agent.height, agent.climb}) &&
           std::isfinite(agent.feet);
}

std::optional<Error> fault_of(const NavigationOptions& options) {
    if (!is_finite(options.up) || length(options.up) == 0) return invalid("navigation: `up` has no direction");
    if (options.agent && !is_usable(*options.agent)) return invalid("navigation: the agent given is out of range");
    if (!(options.cell_size >= 0) || !(options.cell_height >= 0) || !std::isfinite(options.cell_size) ||
        !std::isfinite(options.cell_height))
        return invalid("navigation: a cell's size is not a length; leave it 0 to have it chosen");
    if (options.tile_cells != 0 && (options.tile_cells < 16 || options.tile_cells > 1024))
        return invalid("navigation: a tile has 16 to 1024 cells a side, not " + std::to_string(options.tile_cells));
    if (options.threads < 1 || options.threads > 64)
        return invalid("navigation: 1 to 64 threads, not " + std::to_string(options.threads));
    if (options.areas.size() > most_areas)
        return {{.code = ErrorCode::limit,
                 .text = "navigation: there is room for " + std::to_string(most_areas) + " areas, not for " +
                         std::to_string(options.areas.size()) + "; surfaces of one cost can share one",
                 .file = {}}};
    const std::size_t known = std::max<std::size_t>(options.areas.size(), 1);
    for (const NavigationArea& area : options.areas)
        if (!(area.cost >= 1 && area.cost <= most_cost))
            return invalid("navigation: area '" + area.name +
                           "' costs less than plain ground or too much; 1 is the least, 1e6 the most");
    for (const std::uint32_t area : options.surface_areas)
        if (area >= known && area != forbidden_area)
            return invalid("navigation: a surface is of area " + std::to_string(area) + ", which is not there");
    for (const NavigationRegion& region : options.regions) {
        if (!is_valid(region.pose) || !is_finite(region.half_extents) || !(region.half_extents.x > 0) ||
            !(region.half_extents.y > 0) || !(region.half_extents.z > 0))
            return invalid("navigation: region '" + region.name + "' has no box");
        if (region.kind == NavigationRegion::Kind::area && region.area >= known)
            return invalid("navigation: region '" + region.name + "' is of area " + std::to_string(region.area) +
                           ", which is not there");
    }
    return std::nullopt;
}

}  // namespace

std::optional<std::string> fault_of(const Plan& plan) {
    const Frame& frame = plan.frame;
    for (const dvec3* axis : {&frame.x, &frame.y, &frame.z})
        if (!is_finite(*axis) || std::abs(length(*axis) - 1) > 1e-9) return "its axes are not of unit length";
    if (length(cross(frame.x, frame.y) - frame.z) > 1e-9) return "its axes are not at right angles";
    const NavigationAgent& agent = plan.agent;
    const auto is_length = [](double value) { return value > 0 && value <= largest_coordinate; };
    if (!is_length(agent.radius) || !is_length(agent.height) || !(agent.climb >= 0) || !(agent.climb < agent.height) ||
        !(agent.slope_limit_deg >= 0 && agent.slope_limit_deg < 90) || !(std::abs(agent.feet) <= largest_coordinate))
        return "the agent is no size that a body can have";
    if (!is_length(plan.cell_size) || !is_length(plan.cell_height)) return "a cell's size is not a length";
    if (plan.cell_height > 4 * plan.cell_size)
        return "a cell is more than four times as high as it is wide, and steps are not told from walls; take a "
               "smaller "
               "`cell_height`";
    if (agent.radius > 256 * plan.cell_size || agent.height > 8192 * plan.cell_height)
        return "the agent is more than 256 cells wide or 8192 cells high; take larger cells";
    if (plan.tile_cells < 16 || plan.tile_cells > 1024) return "a tile has 16 to 1024 cells a side";
    if (plan.tile_size != plan.cell_size * plan.tile_cells) return "a tile's size is not that of its cells";
    if (plan.tiles_x < 1 || plan.tiles_z < 1 ||
        static_cast<std::size_t>(plan.tiles_x) * static_cast<std::size_t>(plan.tiles_z) > most_tiles)
        return "it has no tiles, or more than 16384";
    const double reach = std::max(plan.tiles_x, plan.tiles_z) * plan.tile_size;
    if (!is_finite(frame.origin) || length(frame.origin) > 2 * largest_coordinate ||
        !(reach <= 4 * largest_coordinate) || !(plan.low < plan.high) ||
        !(std::abs(plan.low) <= 4 * largest_coordinate) || !(std::abs(plan.high) <= 4 * largest_coordinate))
        return "it reaches farther than 1e9 m";
    return std::nullopt;
}

int Plan::border_cells() const {
    return static_cast<int>(std::ceil(agent.radius / cell_size)) + 3;
}

Expected<Plan> make_plan(const World& world, const CharacterSettings& settings, const NavigationOptions& options) {
    if (!is_valid(settings)) return tl::unexpected(invalid("navigation: the character's settings are out of range"));
    if (auto fault = fault_of(options)) return tl::unexpected(*std::move(fault));
    Plan plan;
    plan.agent = options.agent.value_or(navigation_agent(settings));
    plan.cell_size = options.cell_size > 0 ? options.cell_size : plan.agent.radius / 4;
    plan.cell_height = options.cell_height > 0 ? options.cell_height : plan.cell_size / 2;
    plan.tile_cells = options.tile_cells != 0 ? options.tile_cells : chosen_tile_cells(settings, plan.cell_size);
    plan.tile_size = plan.cell_size * plan.tile_cells;
    plan.layers = options.layers;
    plan.frame = Frame::about({0, 0, 0}, options.up);
    const Extent extent = extent_of(world, options.layers, plan.frame);
    if (extent.is_empty())
        return tl::unexpected(invalid("navigation: there is nothing in the world that stands still"));
    plan.frame.origin = plan.frame.out({extent.min.x, (extent.min.y + extent.max.y) / 2, extent.min.z});
    const dvec3 size = extent.max - extent.min;
    plan.low = static_cast<float>(-size.y / 2 - plan.cell_height);
    plan.high = static_cast<float>(size.y / 2 + plan.agent.height + plan.cell_height);
    const double tiles_x = std::max(1.0, std::ceil(size.x / plan.tile_size));
    const double tiles_z = std::max(1.0, std::ceil(size.z / plan.tile_size));
    if (!(tiles_x * tiles_z <= double{most_tiles}))
        return tl::unexpected(
            Error{.code = ErrorCode::limit,
                  .text = "navigation: a level of " + std::to_string(size.x) + " by " + std::to_string(size.z) +
                          " m needs more than 16384 tiles of " + std::to_string(plan.tile_size) +
                          " m; take larger tiles (`tile_cells`), larger cells, or fewer bodies (`layers`)",
                  .file = {}});
    plan.tiles_x = static_cast<std::int32_t>(tiles_x);
    plan.tiles_z = static_cast<std::int32_t>(tiles_z);
    if (auto fault = fault_of(plan)) return tl::unexpected(invalid("navigation: " + *fault));
    return plan;
}

std::vector<GroundTriangle> ground_of_tile(const World& world, const CharacterSettings& settings,
                                           const NavigationOptions& options, const Plan& plan, int tile_x, int tile_z) {
    const double border = (plan.border_cells() + 1) * plan.cell_size;
    const Bounds near =
        bounds_out(plan.frame, {tile_x * plan.tile_size - border, plan.low, tile_z * plan.tile_size - border},
                   {(tile_x + 1) * plan.tile_size + border, plan.high, (tile_z + 1) * plan.tile_size + border});
    const auto stands = [&](std::uint32_t body) {
        const BodyPose poses = world.poses(world.find(body));
        return poses.start.position == poses.end.position && poses.start.orientation == poses.end.orientation;
    };
    const BodyFilter bodies(stands);
    const WorldQuery query{.layers = plan.layers, .bodies = bodies};
    std::vector<SourceTriangle> found(4096);
    for (std::size_t count = 0; (count = world.gather(near, found, query)) > found.size();) found.resize(count);
    found.resize(world.gather(near, found, query));

    const double least_rise = std::cos(plan.agent.slope_limit_deg * std::numbers::pi / 180) - 1e-9;
    std::vector<GroundTriangle> ground;
    ground.reserve(found.size());
    for (const SourceTriangle& source : found) {
        GroundTriangle triangle{
            {plan.frame.in(source.triangle.a), plan.frame.in(source.triangle.b), plan.frame.in(source.triangle.c)}, 0};
        const dvec3 normal = cross(source.triangle.b - source.triangle.a, source.triangle.c - source.triangle.a);
        const double size = length(normal);
        // Triangles stop from both sides, so both are ground.
        const bool level = size > 0 && std::abs(dot(normal, plan.frame.y)) >= least_rise * size;
        const std::uint32_t area =
            source.surface < options.surface_areas.size() ? options.surface_areas[source.surface] : 0;
        if (level && area != forbidden_area && !settings.surfaces[source.surface].slippery)
            triangle.area = detour_area(area);
        ground.push_back(triangle);
    }
    return ground;
}

}  // namespace surefoot::navigation
