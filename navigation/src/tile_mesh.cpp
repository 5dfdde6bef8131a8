#include "tile_mesh.hpp"

#include <Recast.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>

#include "clearance.hpp"

namespace surefoot::navigation {
namespace {

// A contour may leave the cells' edges by so many cells: what Recast's makers found to follow walls without steps. One
// that is made so simple may cross itself, and polygons are cut from it then that are turned in on themselves; the next
// finer one is taken in that case, and the finest are the cells' own edges.
constexpr std::array contour_errors{1.3F, 0.9F, 0.5F, 0.0F};
// Islands of ground smaller than this many cells are noise of the sampling; what is smaller holds no feet.
constexpr int least_island = 6;
constexpr int mergeable_region = 400;

template <auto Free>
struct Freed {
    template <typename T>
    void operator()(T* object) const {
        Free(object);
    }
};
using Solid = std::unique_ptr<rcHeightfield, Freed<rcFreeHeightField>>;
using Ground = std::unique_ptr<rcCompactHeightfield, Freed<rcFreeCompactHeightfield>>;
using Contours = std::unique_ptr<rcContourSet, Freed<rcFreeContourSet>>;
using Polygons = std::unique_ptr<rcPolyMesh, Freed<rcFreePolyMesh>>;
using Details = std::unique_ptr<rcPolyMeshDetail, Freed<rcFreePolyMeshDetail>>;

/// Keeps the last complaint, for our error.
class Context : public rcContext {
public:
    [[nodiscard]] Error error(int tile_x, int tile_z) const {
        const std::string where = "navigation, tile " + std::to_string(tile_x) + ", " + std::to_string(tile_z) + ": ";
        return {.code = said_.empty() ? ErrorCode::out_of_memory : ErrorCode::limit,
                .text = where + (said_.empty() ? "out of memory" : said_ + "; take smaller tiles or larger cells"),
                .file = {}};
    }

protected:
    void doLog(const rcLogCategory category, const char* text, const int length) override {
        if (category == RC_LOG_ERROR) said_.assign(text, static_cast<std::size_t>(length));
    }

private:
    std::string said_;
};

struct Cells {
    int border = 0;
    int side = 0;  ///< of the tile with its border
    int height = 0;
    int climb = 0;
    int bank = 0;  ///< what no ground rises by within half the agent's radius
    int radius = 0;
    float size = 0;
    float step = 0;
    float min[3] = {};
    float max[3] = {};
};

Cells cells_of(const Plan& plan, std::span<const GroundTriangle> ground, int tile_x, int tile_z) {
    Cells cells;
    cells.border = plan.border_cells();
    cells.side = plan.tile_cells + 2 * cells.border;
    cells.size = static_cast<float>(plan.cell_size);
    cells.step = static_cast<float>(plan.cell_height);
    cells.height = static_cast<int>(std::ceil(plan.agent.height / plan.cell_height));
    // A step of just the height that is climbed is climbed; the hair is what floats lose on the way here.
    cells.climb = static_cast<int>(std::floor(plan.agent.climb / plan.cell_height + 1e-3));
    const double steepest = std::tan(plan.agent.slope_limit_deg * std::numbers::pi / 180);
    cells.bank =
        std::max(cells.climb, static_cast<int>(std::ceil(steepest * plan.agent.radius / 2 / plan.cell_height)) + 1);
    cells.radius = static_cast<int>(std::ceil(plan.agent.radius / plan.cell_size - 1e-6));
    float low = plan.high;
    float high = plan.low;
    for (const GroundTriangle& triangle : ground) {
        for (const vec3& corner : triangle.corners) {
            low = std::min(low, corner.y);
            high = std::max(high, corner.y);
        }
    }
    const double border = cells.border * plan.cell_size;
    cells.min[0] = static_cast<float>(tile_x * plan.tile_size - border);
    cells.min[1] = std::max(low, plan.low) - cells.step;
    cells.min[2] = static_cast<float>(tile_z * plan.tile_size - border);
    cells.max[0] = static_cast<float>((tile_x + 1) * plan.tile_size + border);
    cells.max[1] = std::min(high, plan.high) + cells.step;
    cells.max[2] = static_cast<float>((tile_z + 1) * plan.tile_size + border);
    return cells;
}

/// The corners of a region's box in the frame, seen from above: their convex hull, and how far it reaches up and down.
struct RegionPrism {
    std::vector<float> outline;  ///< x, y, z a corner
    float low = 0;
    float high = 0;
};

RegionPrism prism_of(const NavigationRegion& region, const Frame& frame) {
    std::vector<vec3> corners;
    for (int corner = 0; corner < 8; ++corner) {
        const dvec3 half = region.half_extents * dvec3{corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1};
        corners.push_back(frame.in(to_world(region.pose, half)));
    }
    RegionPrism prism{{}, corners[0].y, corners[0].y};
    for (const vec3& corner : corners) {
        prism.low = std::min(prism.low, corner.y);
        prism.high = std::max(prism.high, corner.y);
    }
    // Andrew's monotone chain.
    std::sort(corners.begin(), corners.end(),
              [](const vec3& a, const vec3& b) { return a.x != b.x ? a.x < b.x : a.z < b.z; });
    std::vector<vec3> hull;
    const auto turn = [](const vec3& a, const vec3& b, const vec3& c) {
        return (b.x - a.x) * (c.z - a.z) - (b.z - a.z) * (c.x - a.x);
    };
    for (int pass = 0; pass < 2; ++pass) {
        const std::size_t first = hull.size();
        for (const vec3& corner : corners) {
            while (hull.size() >= first + 2 && turn(hull[hull.size() - 2], hull.back(), corner) <= 0) hull.pop_back();
            hull.push_back(corner);
        }
        hull.pop_back();
        std::reverse(corners.begin(), corners.end());
    }
    for (const vec3& corner : hull) prism.outline.insert(prism.outline.end(), {corner.x, 0, corner.z});
    return prism;
}

void mark_regions(rcContext& context, rcCompactHeightfield& ground, std::span<const NavigationRegion> regions,
                  const Frame& frame) {
    for (const NavigationRegion& region : regions) {
        if (region.kind == NavigationRegion::Kind::require) continue;
        const RegionPrism prism = prism_of(region, frame);
        const bool forbid = region.kind == NavigationRegion::Kind::forbid;
        rcMarkConvexPolyArea(&context, prism.outline.data(), static_cast<int>(prism.outline.size() / 3), prism.low,
                             prism.high, forbid ? RC_NULL_AREA : detour_area(region.area), ground);
    }
}

bool rasterize(rcContext& context, std::span<const GroundTriangle> ground, const Cells& cells, rcHeightfield& solid) {
    if (!rcCreateHeightfield(&context, solid, cells.side, cells.side, cells.min, cells.max, cells.size, cells.step))
        return false;
    for (const GroundTriangle& triangle : ground)
        if (!rcRasterizeTriangle(&context, &triangle.corners[0].x, &triangle.corners[1].x, &triangle.corners[2].x,
                                 triangle.area, solid, cells.climb))
            return false;
    rcFilterLowHangingWalkableObstacles(&context, cells.climb, solid);
    rcFilterWalkableLowHeightSpans(&context, cells.height, solid);
    return true;
}

template <typename To, typename From>
std::vector<To> copied(const From* from, std::size_t count) {
    return std::vector<To>(from, from + count);
}

TileMesh tile_of(const rcPolyMesh& polygons, const rcPolyMeshDetail& details, int tile_x, int tile_z) {
    TileMesh tile{.x = tile_x, .z = tile_z};
    tile.min = {polygons.bmin[0], polygons.bmin[1], polygons.bmin[2]};
    tile.max = {polygons.bmax[0], polygons.bmax[1], polygons.bmax[2]};
    const auto size = [](int count) { return static_cast<std::size_t>(count); };
    tile.vertices = copied<std::uint16_t>(polygons.verts, 3 * size(polygons.nverts));
    tile.polygons = copied<std::uint16_t>(polygons.polys, 2 * size(corners_per_polygon) * size(polygons.npolys));
    tile.areas = copied<std::uint8_t>(polygons.areas, size(polygons.npolys));
    tile.detail_meshes = copied<std::uint32_t>(details.meshes, 4 * size(details.nmeshes));
    tile.detail_vertices = copied<float>(details.verts, 3 * size(details.nverts));
    tile.detail_triangles = copied<std::uint8_t>(details.tris, 4 * size(details.ntris));
    return tile;
}

/// Are all polygons convex and turned the same way, as whole cells?
bool are_convex(const rcPolyMesh& mesh) {
    for (int p = 0; p < mesh.npolys; ++p) {
        const unsigned short* const polygon = mesh.polys + std::size_t(p) * 2 * std::size_t(mesh.nvp);
        int corners = 0;
        while (corners < mesh.nvp && polygon[corners] != RC_MESH_NULL_IDX) ++corners;
        const auto at = [&](int corner) { return mesh.verts + std::size_t(polygon[corner % corners]) * 3; };
        long around = 0;
        for (int i = 0; i < corners; ++i) {
            const unsigned short* const a = at(i);
            const unsigned short* const b = at(i + 1);
            const unsigned short* const c = at(i + 2);
            if ((b[2] - a[2]) * (c[0] - b[0]) - (b[0] - a[0]) * (c[2] - b[2]) < 0) return false;
            around += long(a[2]) * b[0] - long(a[0]) * b[2];
        }
        if (around <= 0) return false;
    }
    return true;
}

/// The ground's polygons; none where there is no ground. Null if something went wrong.
Polygons polygons_of(Context& context, rcCompactHeightfield& ground) {
    Polygons polygons;
    for (const float error : contour_errors) {
        const Contours contours(rcAllocContourSet());
        if (!contours || !rcBuildContours(&context, ground, error, 0, *contours)) return nullptr;
        polygons.reset(rcAllocPolyMesh());
        if (!polygons) return nullptr;
        if (contours->nconts == 0) return polygons;
        if (!rcBuildPolyMesh(&context, *contours, corners_per_polygon, *polygons)) return nullptr;
        if (are_convex(*polygons)) break;
    }
    return polygons;
}

}  // namespace

Expected<TileMesh> build_tile(std::span<const GroundTriangle> ground, std::span<const NavigationRegion> regions,
                              const Plan& plan, int tile_x, int tile_z) {
    const bool walkable =
        std::any_of(ground.begin(), ground.end(), [](const auto& triangle) { return triangle.area != 0; });
    if (!walkable) return TileMesh{.x = tile_x, .z = tile_z};
    const Cells cells = cells_of(plan, ground, tile_x, tile_z);
    Context context;
    const auto failed = [&] { return tl::unexpected(context.error(tile_x, tile_z)); };
    if ((cells.max[1] - cells.min[1]) / cells.step > RC_SPAN_MAX_HEIGHT)
        return tl::unexpected(Error{.code = ErrorCode::limit,
                                    .text = "navigation, tile " + std::to_string(tile_x) + ", " +
                                            std::to_string(tile_z) + ": is " +
                                            std::to_string(cells.max[1] - cells.min[1]) +
                                            " m high, more than 8191 cells; take a larger `cell_height`",
                                    .file = {}});

    const Solid solid(rcAllocHeightfield());
    if (!solid || !rasterize(context, ground, cells, *solid)) return failed();
    const Ground compact(rcAllocCompactHeightfield());
    if (!compact || !rcBuildCompactHeightfield(&context, cells.height, cells.climb, *solid, *compact)) return failed();
    bar_banks(*compact, cells.bank, plan.agent.radius / 2);
    keep_clear(*solid, *compact, cells.radius, cells.climb, cells.height);
    mark_regions(context, *compact, regions, plan.frame);
    if (!rcBuildDistanceField(&context, *compact) ||
        !rcBuildRegions(&context, *compact, cells.border, least_island, mergeable_region))
        return failed();
    const Polygons polygons = polygons_of(context, *compact);
    if (!polygons) return failed();
    if (polygons->npolys == 0) return TileMesh{.x = tile_x, .z = tile_z};
    const Details details(rcAllocPolyMeshDetail());
    if (!details || !rcBuildPolyMeshDetail(&context, *polygons, *compact, 6 * cells.size, 1.5F * cells.step, *details))
        return failed();
    return tile_of(*polygons, *details, tile_x, tile_z);
}

}  // namespace surefoot::navigation
