#include "check_tile.hpp"

#include <DetourNavMesh.h>
#include <array>
#include <cmath>
#include <cstring>

#include "mesh_state.hpp"

namespace surefoot::navigation {
namespace {

/// The parts of a tile where Detour will look for them.
struct Parts {
    dtMeshHeader header{};
    std::span<const float> vertices{};
    std::span<const dtPoly> polygons{};
    std::span<const dtPolyDetail> details{};
    std::span<const float> detail_vertices{};
    std::span<const unsigned char> detail_triangles{};
    std::span<const dtBVNode> boxes{};
    std::span<const dtOffMeshConnection> connections{};
};

class TileCheck {
public:
    TileCheck(std::span<const std::byte> bytes, const TileFrame& frame) : bytes_(bytes), frame_(frame) {}

    [[nodiscard]] std::optional<TileFault> fault() {
        if (header_is_sound() && parts_fit() && vertices_are_sound() && polygons_are_sound() && details_are_sound() &&
            boxes_are_sound() && connections_are_sound())
            return std::nullopt;
        return fault_;
    }

private:
    bool fail(std::size_t byte, std::string what) {
        fault_ = {byte, std::move(what)};
        return false;
    }
    bool fail(const void* at, std::string what) {
        return fail(static_cast<std::size_t>(static_cast<const std::byte*>(at) - bytes_.data()), std::move(what));
    }

    bool header_is_sound();
    bool parts_fit();
    bool vertices_are_sound();
    bool polygons_are_sound();
    bool ground_is_sound(std::size_t index);
    bool is_convex(const dtPoly& polygon) const;
    bool side_is_sound(std::size_t index, std::size_t corner);
    bool border_is_sound(const dtPoly& polygon, std::size_t corner);
    bool details_are_sound();
    bool boxes_are_sound();
    bool connections_are_sound();

    [[nodiscard]] const float* vertex(const dtPoly& polygon, std::size_t corner) const {
        return &parts_.vertices[3 * std::size_t{polygon.verts[corner % polygon.vertCount]}];
    }
    /// What floats lose at a coordinate, and then some [m].
    [[nodiscard]] double hair(double at) const { return 1e-6 * std::abs(at) + 1e-3 * frame_.plan.cell_size; }
    [[nodiscard]] bool is_inside(const float* place) const {
        for (int axis = 0; axis < 3; ++axis) {
            const double slack = hair(place[axis]) + (axis == 1 ? frame_.plan.cell_height : 0);
            if (!(place[axis] >= parts_.header.bmin[axis] - slack && place[axis] <= parts_.header.bmax[axis] + slack))
                return false;
        }
        return true;
    }
    [[nodiscard]] std::size_t ground() const { return static_cast<std::size_t>(parts_.header.offMeshBase); }

    std::span<const std::byte> bytes_;
    const TileFrame& frame_;
    Parts parts_;
    TileFault fault_;
};

bool TileCheck::header_is_sound() {
    dtMeshHeader& header = parts_.header;
    if (bytes_.size() < sizeof header) return fail(std::size_t{0}, "ends within its header");
    std::memcpy(&header, bytes_.data(), sizeof header);
    const Plan& plan = frame_.plan;
    if (header.magic != DT_NAVMESH_MAGIC || header.version != DT_NAVMESH_VERSION)
        return fail(offsetof(dtMeshHeader, magic), "is no tile of this Detour");
    if (header.x != frame_.x || header.y != frame_.z || header.layer != 0 || header.userId != 0)
        return fail(offsetof(dtMeshHeader, x), "lies elsewhere than it should");
    const auto count_is_sound = [&](const int& count, int least, std::size_t most) {
        if (count >= least && static_cast<std::size_t>(count) <= most) return true;
        const auto at = reinterpret_cast<const std::byte*>(&count) - reinterpret_cast<const std::byte*>(&header);
        return fail(static_cast<std::size_t>(at), "has a count that cannot be, " + std::to_string(count));
    };
    if (!count_is_sound(header.polyCount, 1, frame_.most_polygons) || !count_is_sound(header.vertCount, 3, 0xffff) ||
        !count_is_sound(header.maxLinkCount, 1, bytes_.size()) ||
        !count_is_sound(header.offMeshBase, 1, static_cast<std::size_t>(header.polyCount)) ||
        !count_is_sound(header.detailVertCount, 0, bytes_.size()) ||
        !count_is_sound(header.detailTriCount, 1, bytes_.size()))
        return false;
    if (header.detailMeshCount != header.offMeshBase || header.bvNodeCount != 2 * header.offMeshBase ||
        header.offMeshConCount != header.polyCount - header.offMeshBase)
        return fail(offsetof(dtMeshHeader, detailMeshCount), "has counts that do not fit each other");
    if (header.walkableHeight != static_cast<float>(plan.agent.height) ||
        header.walkableRadius != static_cast<float>(plan.agent.radius) ||
        header.walkableClimb != static_cast<float>(plan.agent.climb) ||
        header.bvQuantFactor != 1 / static_cast<float>(plan.cell_size))
        return fail(offsetof(dtMeshHeader, walkableHeight), "is for another agent or other cells");
    const std::array<double, 2> corner{frame_.x * plan.tile_size, frame_.z * plan.tile_size};
    for (std::size_t axis : {0U, 2U}) {
        const double low = corner[axis / 2];
        const double high = low + plan.tile_size;
        if (!(std::abs(header.bmin[axis] - low) <= hair(high) && std::abs(header.bmax[axis] - high) <= hair(high)))
            return fail(offsetof(dtMeshHeader, bmin), "does not fill its place in the grid");
    }
    const double slack = 2 * plan.cell_height + hair(plan.high) + hair(plan.low);
    if (!(header.bmin[1] >= plan.low - slack && header.bmax[1] <= plan.high + slack &&
          header.bmin[1] <= header.bmax[1] && (header.bmax[1] - header.bmin[1]) * header.bvQuantFactor < 65530))
        return fail(offsetof(dtMeshHeader, bmin), "reaches higher or lower than its level");
    return true;
}

bool TileCheck::parts_fit() {
    std::uint64_t at = sizeof(dtMeshHeader);
    const auto take = [&]<typename T>(std::span<const T>& part, int count, int per) {
        const std::uint64_t size = static_cast<std::uint64_t>(count) * static_cast<std::uint64_t>(per) * sizeof(T);
        if (at <= bytes_.size() && size <= bytes_.size() - at)
            part = {reinterpret_cast<const T*>(bytes_.data() + at), static_cast<std::size_t>(size / sizeof(T))};
        at += size;
    };
    const dtMeshHeader& header = parts_.header;
    std::span<const dtLink> links;
    take(parts_.vertices, header.vertCount, 3);
    take(parts_.polygons, header.polyCount, 1);
    take(links, header.maxLinkCount, 1);
    take(parts_.details, header.detailMeshCount, 1);
    take(parts_.detail_vertices, header.detailVertCount, 3);
    take(parts_.detail_triangles, header.detailTriCount, 4);
    take(parts_.boxes, header.bvNodeCount, 1);
    take(parts_.connections, header.offMeshConCount, 1);
    if (at == bytes_.size()) return true;
    return fail(offsetof(dtMeshHeader, polyCount),
                "has " + std::to_string(bytes_.size()) + " bytes, and what it counts takes " + std::to_string(at));
}

bool TileCheck::vertices_are_sound() {
    // The two ends of each connection come last, and may lie in a tile beside.
    const std::size_t of_ground = static_cast<std::size_t>(parts_.header.vertCount);
    const std::size_t of_connections = 2 * parts_.connections.size();
    if (of_connections + 3 > of_ground) return fail(offsetof(dtMeshHeader, vertCount), "has too few corners");
    for (std::size_t i = 0; i < of_ground - of_connections; ++i)
        if (!is_inside(&parts_.vertices[3 * i])) return fail(&parts_.vertices[3 * i], "has a corner outside of it");
    for (std::size_t i = 3 * (of_ground - of_connections); i < parts_.vertices.size(); ++i)
        if (!(std::abs(parts_.vertices[i]) <= largest_coordinate))
            return fail(&parts_.vertices[i], "has a link that ends nowhere");
    for (std::size_t i = 0; i < parts_.detail_vertices.size(); i += 3)
        if (!is_inside(&parts_.detail_vertices[i]))
            return fail(&parts_.detail_vertices[i], "has a height outside of it");
    return true;
}

bool TileCheck::polygons_are_sound() {
    for (std::size_t i = 0; i < ground(); ++i)
        if (!ground_is_sound(i)) return false;
    for (std::size_t i = ground(); i < parts_.polygons.size(); ++i) {
        const dtPoly& polygon = parts_.polygons[i];
        const std::size_t first = parts_.vertices.size() / 3 - 2 * (parts_.polygons.size() - i);
        if (polygon.getType() != DT_POLYTYPE_OFFMESH_CONNECTION || polygon.vertCount != 2 ||
            polygon.verts[0] != first || polygon.verts[1] != first + 1 || polygon.getArea() != detour_area(0) ||
            (polygon.flags & ~(walkable | closed | taken_out)) != 0)
            return fail(&polygon, "has a link that is none");
    }
    return true;
}

bool TileCheck::ground_is_sound(std::size_t index) {
    const dtPoly& polygon = parts_.polygons[index];
    if (polygon.getType() != DT_POLYTYPE_GROUND || polygon.vertCount < 3 || polygon.vertCount > DT_VERTS_PER_POLYGON)
        return fail(&polygon, "has a polygon that is none");
    const std::size_t corners = static_cast<std::size_t>(parts_.header.vertCount) - 2 * parts_.connections.size();
    for (std::size_t i = 0; i < polygon.vertCount; ++i)
        if (polygon.verts[i] >= corners)
            return fail(&polygon.verts[i], "has a polygon with a corner that is not there");
    const std::size_t area = polygon.getArea();
    if (area == 0 || area > frame_.areas.size()) return fail(&polygon, "has ground of an area that is not there");
    const unsigned shut = frame_.areas[area - 1].closed ? closed : 0U;
    if ((polygon.flags & ~taken_out) != (walkable | shut))
        return fail(&polygon.flags, "has ground that is open or shut otherwise than its area");
    if (!is_convex(polygon)) return fail(&polygon, "has a polygon that is not convex");
    for (std::size_t i = 0; i < polygon.vertCount; ++i)
        if (!side_is_sound(index, i)) return false;
    return true;
}

bool TileCheck::is_convex(const dtPoly& polygon) const {
    double around = 0;
    for (std::size_t i = 0; i < polygon.vertCount; ++i) {
        const float* a = vertex(polygon, i);
        const float* b = vertex(polygon, i + 1);
        const float* c = vertex(polygon, i + 2);
        const std::array<double, 4> way{double{b[0]} - a[0], double{b[2]} - a[2], double{c[0]} - b[0],
                                        double{c[2]} - b[2]};
        const double turn = way[1] * way[2] - way[0] * way[3];
        const double reach = std::abs(way[0]) + std::abs(way[1]) + std::abs(way[2]) + std::abs(way[3]);
        if (!(turn >= -4 * (hair(b[0]) + hair(b[2])) * reach)) return false;
        around += double{a[2]} * b[0] - double{a[0]} * b[2];
    }
    return around > 0;
}

bool TileCheck::side_is_sound(std::size_t index, std::size_t corner) {
    const dtPoly& polygon = parts_.polygons[index];
    const unsigned beside = polygon.neis[corner];
    if (beside == 0) return true;
    if ((beside & DT_EXT_LINK) != 0) return border_is_sound(polygon, corner);
    const std::size_t other = beside - 1U;
    if (other >= ground() || other == index)
        return fail(&polygon.neis[corner], "has a polygon beside one that is not there");
    const dtPoly& neighbour = parts_.polygons[other];
    if (neighbour.vertCount <= DT_VERTS_PER_POLYGON) {
        const unsigned from = polygon.verts[corner];
        const unsigned to = polygon.verts[(corner + 1) % polygon.vertCount];
        for (std::size_t i = 0; i < neighbour.vertCount; ++i)
            if (neighbour.neis[i] == index + 1 && neighbour.verts[i] == to &&
                neighbour.verts[(i + 1) % neighbour.vertCount] == from)
                return true;
    }
    return fail(&polygon.neis[corner], "has polygons that are not beside each other as they say");
}

/// Where ground goes on in the next tile: the side lies on the tile's border, along it.
bool TileCheck::border_is_sound(const dtPoly& polygon, std::size_t corner) {
    const unsigned side = polygon.neis[corner] & 0xffU;
    const float* a = vertex(polygon, corner);
    const float* b = vertex(polygon, corner + 1);
    bool sound = (polygon.neis[corner] & ~(DT_EXT_LINK | 0xffU)) == 0 && side % 2 == 0 && side <= 6;
    if (sound) {
        const std::size_t across = side % 4 == 0 ? 0 : 2;
        const float border = side < 4 ? parts_.header.bmax[across] : parts_.header.bmin[across];
        for (const float* end : {a, b}) sound = sound && std::abs(end[across] - border) <= 2 * hair(border);
        sound = sound && a[2 - across] != b[2 - across];
    }
    return sound || fail(&polygon.neis[corner], "has ground that goes on where no tile is beside it");
}

bool TileCheck::details_are_sound() {
    for (std::size_t i = 0; i < parts_.details.size(); ++i) {
        const dtPolyDetail& detail = parts_.details[i];
        const std::uint64_t triangles_end = std::uint64_t{detail.triBase} + detail.triCount;
        const std::uint64_t vertices_end = std::uint64_t{detail.vertBase} + detail.vertCount;
        if (detail.triCount == 0 || triangles_end > parts_.detail_triangles.size() / 4 ||
            vertices_end > parts_.detail_vertices.size() / 3)
            return fail(&detail, "has heights that are not there");
        const unsigned known = parts_.polygons[i].vertCount + unsigned{detail.vertCount};
        bool has_border = false;
        for (std::size_t t = detail.triBase; t < triangles_end; ++t) {
            const unsigned char* triangle = &parts_.detail_triangles[4 * t];
            if (triangle[0] >= known || triangle[1] >= known || triangle[2] >= known)
                return fail(triangle, "has a triangle of heights with a corner that is not there");
            for (int edge = 0; edge < 3; ++edge)
                has_border = has_border || (dtGetDetailTriEdgeFlags(triangle[3], edge) & DT_DETAIL_EDGE_BOUNDARY) != 0;
        }
        // Detour looks for the nearest point of the border and does not expect that there is none.
        if (!has_border) return fail(&detail, "has heights without a border");
    }
    return true;
}

bool TileCheck::boxes_are_sound() {
    const auto count = static_cast<std::int64_t>(parts_.boxes.size());
    for (std::int64_t i = 0; i < count; ++i) {
        const dtBVNode& box = parts_.boxes[static_cast<std::size_t>(i)];
        const bool leaf_is_sound = box.i >= 0 && static_cast<std::size_t>(box.i) < ground();
        const bool escape_is_sound = box.i < 0 && -std::int64_t{box.i} <= count - i;
        if (!leaf_is_sound && !escape_is_sound) return fail(&box, "has a tree of boxes that leads out of it");
    }
    return true;
}

bool TileCheck::connections_are_sound() {
    for (std::size_t i = 0; i < parts_.connections.size(); ++i) {
        const dtOffMeshConnection& connection = parts_.connections[i];
        for (const float at : connection.pos)
            if (!(std::abs(at) <= largest_coordinate)) return fail(&connection, "has a link that ends nowhere");
        if (connection.poly != ground() + i || connection.flags != 0 ||
            (connection.side > 7 && connection.side != 0xff) || connection.userId >= frame_.links ||
            connection.rad != static_cast<float>(frame_.plan.agent.radius))
            return fail(&connection, "has a link that is none");
    }
    return true;
}

}  // namespace

std::optional<TileFault> tile_fault(std::span<const std::byte> bytes, const TileFrame& frame) {
    return TileCheck(bytes, frame).fault();
}

}  // namespace surefoot::navigation
