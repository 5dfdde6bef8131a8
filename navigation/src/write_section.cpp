// A navigation mesh as the bytes of a section.
#include <bit>
#include <cstring>

#include "mesh_state.hpp"
#include "section_format.hpp"

namespace surefoot {
inline namespace v0 {

using namespace navigation;

namespace {

void copy(double (&to)[3], const dvec3& from) {
    for (int axis = 0; axis < 3; ++axis) to[axis] = from[axis];
}

SectionHeader header_of(const MeshState& state) {
    const Plan& plan = state.plan;
    SectionHeader header;
    header.detour_version = DT_NAVMESH_VERSION;
    copy(header.origin, plan.frame.origin);
    copy(header.x, plan.frame.x);
    copy(header.y, plan.frame.y);
    copy(header.z, plan.frame.z);
    header.radius = plan.agent.radius;
    header.height = plan.agent.height;
    header.climb = plan.agent.climb;
    header.slope_limit_deg = plan.agent.slope_limit_deg;
    header.feet = plan.agent.feet;
    header.cell_size = plan.cell_size;
    header.cell_height = plan.cell_height;
    header.tile_size = plan.tile_size;
    header.layers = plan.layers;
    header.low = plan.low;
    header.high = plan.high;
    header.tile_cells = plan.tile_cells;
    header.tiles_x = plan.tiles_x;
    header.tiles_z = plan.tiles_z;
    header.areas = static_cast<std::uint32_t>(state.areas.size());
    for (const NavigationArea& area : state.areas) header.name_bytes += static_cast<std::uint32_t>(area.name.size());
    header.links = static_cast<std::uint32_t>(state.links.size());
    for (const NavigationLink& link : state.links) header.inputs += static_cast<std::uint32_t>(link.inputs.size());
    return header;
}

SectionLink record_of(const NavigationLink& link) {
    SectionLink record;
    copy(record.from, link.from);
    copy(record.to, link.to);
    copy(record.takeoff, link.takeoff);
    copy(record.end, link.end);
    record.speed = link.speed;
    record.air_jumps = link.air_jumps;
    record.seconds = link.seconds;
    record.tick = link.tick;
    record.kind = static_cast<std::uint32_t>(link.kind);
    record.inputs = static_cast<std::uint32_t>(link.inputs.size());
    return record;
}

/// Tiles of Detour's mesh by their place in the grid, so that equal meshes have equal bytes however they came about.
std::vector<const dtMeshTile*> tiles_in_order(const MeshState& state) {
    std::vector<const dtMeshTile*> tiles;
    for (int z = 0; z < state.plan.tiles_z; ++z)
        for (int x = 0; x < state.plan.tiles_x; ++x)
            if (const dtMeshTile* tile = state.detour->getTileAt(x, z, 0)) tiles.push_back(tile);
    return tiles;
}

class Writer {
public:
    explicit Writer(std::uint64_t size) : bytes_(static_cast<std::size_t>(size)) {}

    void put(const void* data, std::size_t size) {
        if (size != 0) std::memcpy(bytes_.data() + at_, data, size);
        at_ += size;
    }
    template <typename T>
    void put(const T& item) {
        put(&item, sizeof item);
    }
    void align(std::uint64_t to) { at_ = static_cast<std::size_t>(aligned(at_, to)); }
    [[nodiscard]] std::byte* here() { return bytes_.data() + at_; }
    [[nodiscard]] std::vector<std::byte> take() { return std::move(bytes_); }

private:
    std::vector<std::byte> bytes_;
    std::size_t at_ = 0;
};

/// Detour makes its links anew whenever a tile is put in; what they were is nobody's business.
void forget_links(std::byte* blob, const dtMeshTile& tile) {
    const auto offset_of = [&](const void* part) {
        return static_cast<std::size_t>(static_cast<const unsigned char*>(part) - tile.data);
    };
    std::memset(blob + offset_of(tile.links), 0, static_cast<std::size_t>(tile.header->maxLinkCount) * sizeof(dtLink));
    for (int i = 0; i < tile.header->polyCount; ++i)
        std::memset(blob + offset_of(&tile.polys[i].firstLink), 0, sizeof(tile.polys[i].firstLink));
    // The ends of connections were moved onto the ground; where they were meant to be stands in the connection.
    for (int i = 0; i < tile.header->offMeshConCount; ++i) {
        const dtOffMeshConnection& connection = tile.offMeshCons[i];
        for (std::size_t end = 0; end < 2; ++end)
            std::memcpy(blob + offset_of(tile.verts + 3 * std::size_t{tile.polys[connection.poly].verts[end]}),
                        connection.pos + 3 * end, 3 * sizeof(float));
    }
}

}  // namespace

std::vector<std::byte> NavigationMesh::to_bytes() const {
    const MeshState& state = *state_;
    const std::vector<const dtMeshTile*> tiles = tiles_in_order(state);
    SectionHeader header = header_of(state);
    header.tiles = static_cast<std::uint32_t>(tiles.size());
    std::vector<SectionTile> table;
    std::uint64_t end = layout_of(header, sizeof(NavigationInput)).tiles;
    for (const dtMeshTile* tile : tiles) {
        const auto size = static_cast<std::uint64_t>(tile->dataSize);
        table.push_back({.offset = end, .size = size, .x = tile->header->x, .z = tile->header->y});
        end = aligned(end + size, tile_alignment);
    }
    header.size = end;

    Writer out(end);
    out.put(header);
    for (const NavigationArea& area : state.areas)
        out.put(SectionArea{area.cost, area.closed ? 1U : 0U, static_cast<std::uint32_t>(area.name.size())});
    for (const NavigationArea& area : state.areas) out.put(area.name.data(), area.name.size());
    out.align(8);
    for (const NavigationLink& link : state.links) out.put(record_of(link));
    for (const NavigationLink& link : state.links)
        out.put(link.inputs.data(), link.inputs.size() * sizeof(NavigationInput));
    for (const SectionTile& tile : table) out.put(tile);
    for (const dtMeshTile* tile : tiles) {
        out.align(tile_alignment);
        std::byte* const blob = out.here();
        out.put(tile->data, static_cast<std::size_t>(tile->dataSize));
        forget_links(blob, *tile);
    }
    return out.take();
}

Section navigation_section(std::span<const std::byte> bytes, std::uint64_t made_from) noexcept {
    return {section_owner, section_name, section_version, made_from, bytes};
}

static_assert(std::endian::native == std::endian::little, "cooked files are little-endian and used where they lie");

}  // namespace v0
}  // namespace surefoot
