// A navigation mesh from bytes that may be anything: looked at whole before Detour gets to see them.
#include <cmath>
#include <cstring>

#include <surefoot/private_section.hpp>

#include "check_tile.hpp"
#include "mesh_state.hpp"
#include "section_format.hpp"

namespace surefoot {

namespace navigation {
namespace {

dvec3 vector_of(const double (&from)[3]) {
    return {from[0], from[1], from[2]};
}

/// Where the bytes came from, for errors.
struct Origin {
    std::string file;
    std::uint64_t offset = 0;  ///< of the section in the file

    [[nodiscard]] tl::unexpected<Error> error(ErrorCode code, std::uint64_t byte, const std::string& what) const {
        const std::string name = file.empty() ? "this navigation section" : file;
        return tl::unexpected(Error{code,
                                    name + ": the navigation mesh " + what + " (at byte " +
                                        std::to_string(offset + byte) + "): make it again with `surefoot nav build " +
                                        (file.empty() ? "LEVEL" : file) + "`",
                                    file, offset + byte});
    }
    [[nodiscard]] tl::unexpected<Error> damaged(std::uint64_t byte, const std::string& what) const {
        return error(ErrorCode::unreadable, byte, what);
    }
};

class SectionReader {
public:
    SectionReader(std::span<std::byte> bytes, const Origin& origin, MeshState& state)
        : bytes_(bytes), origin_(origin), state_(state) {}

    [[nodiscard]] Expected<void> read() {
        if (auto done = read_header(); !done) return done;
        if (auto done = read_plan(); !done) return done;
        if (auto done = read_areas(); !done) return done;
        if (auto done = read_links(); !done) return done;
        return read_tiles();
    }

private:
    Expected<void> read_header();
    Expected<void> read_plan();
    Expected<void> read_areas();
    Expected<void> read_links();
    Expected<void> read_tiles();
    Expected<void> read_tile(const SectionTile& entry);

    template <typename T>
    [[nodiscard]] T at(std::uint64_t offset) const {
        T item;
        std::memcpy(&item, bytes_.data() + offset, sizeof item);
        return item;
    }

    std::span<std::byte> bytes_;
    const Origin& origin_;
    MeshState& state_;
    SectionHeader header_;
    SectionLayout layout_;
};

Expected<void> SectionReader::read_header() {
    if (bytes_.size() < sizeof header_) return origin_.damaged(bytes_.size(), "ends within its header");
    header_ = at<SectionHeader>(0);
    if (header_.magic != section_magic) return origin_.damaged(0, "is none, or was transferred as text");
    if (header_.version != section_version || header_.detour_version != DT_NAVMESH_VERSION)
        return origin_.error(ErrorCode::unsupported, offsetof(SectionHeader, version),
                             "has format " + std::to_string(header_.version) + "." +
                                 std::to_string(header_.detour_version) + ", and this Surefoot reads format " +
                                 std::to_string(section_version) + "." + std::to_string(DT_NAVMESH_VERSION));
    if (header_.size != bytes_.size())
        return origin_.damaged(offsetof(SectionHeader, size), "should have " + std::to_string(header_.size) +
                                                                  " bytes but has " + std::to_string(bytes_.size()));
    layout_ = layout_of(header_, sizeof(NavigationInput));
    if (layout_.tiles > bytes_.size())
        return origin_.damaged(offsetof(SectionHeader, areas), "has fewer bytes than what it counts takes");
    return {};
}

Expected<void> SectionReader::read_plan() {
    Plan& plan = state_.plan;
    plan.frame = {vector_of(header_.origin), vector_of(header_.x), vector_of(header_.y), vector_of(header_.z)};
    plan.agent = {.radius = header_.radius,
                  .height = header_.height,
                  .climb = header_.climb,
                  .slope_limit_deg = header_.slope_limit_deg,
                  .feet = header_.feet};
    plan.cell_size = header_.cell_size;
    plan.cell_height = header_.cell_height;
    plan.tile_size = header_.tile_size;
    plan.tile_cells = header_.tile_cells;
    plan.tiles_x = header_.tiles_x;
    plan.tiles_z = header_.tiles_z;
    plan.low = header_.low;
    plan.high = header_.high;
    plan.layers = header_.layers;
    if (const auto fault = fault_of(plan))
        return origin_.damaged(offsetof(SectionHeader, origin), "cannot be: " + *fault);
    return {};
}

Expected<void> SectionReader::read_areas() {
    if (header_.areas < 1 || header_.areas > most_areas)
        return origin_.damaged(offsetof(SectionHeader, areas), "has " + std::to_string(header_.areas) + " areas");
    std::uint64_t name = layout_.names;
    for (std::uint32_t i = 0; i < header_.areas; ++i) {
        const std::uint64_t offset = layout_.areas + i * sizeof(SectionArea);
        const auto area = at<SectionArea>(offset);
        if (!(area.cost >= 1 && area.cost <= most_cost) || area.closed > 1 ||
            area.name_bytes > layout_.names + header_.name_bytes - name)
            return origin_.damaged(offset, "has an area that cannot be");
        state_.areas.push_back(
            {.name = std::string(reinterpret_cast<const char*>(bytes_.data() + name), area.name_bytes),
             .cost = area.cost,
             .closed = area.closed != 0});
        name += area.name_bytes;
    }
    if (name != layout_.names + header_.name_bytes)
        return origin_.damaged(layout_.names, "has names of areas that are not there");
    return {};
}

Expected<void> SectionReader::read_links() {
    std::uint64_t input = layout_.inputs;
    for (std::uint32_t i = 0; i < header_.links; ++i) {
        const std::uint64_t offset = layout_.links + i * sizeof(SectionLink);
        const auto record = at<SectionLink>(offset);
        if (record.inputs > (layout_.table - input) / sizeof(NavigationInput))
            return origin_.damaged(offset, "has a link with inputs that are not there");
        if (record.kind > static_cast<std::uint32_t>(NavigationLinkKind::ladder))
            return origin_.damaged(offset, "has a link of no known kind");
        NavigationLink link{.from = vector_of(record.from),
                            .to = vector_of(record.to),
                            .takeoff = vector_of(record.takeoff),
                            .kind = static_cast<NavigationLinkKind>(record.kind),
                            .speed = record.speed,
                            .air_jumps = record.air_jumps,
                            .seconds = record.seconds,
                            .tick = record.tick,
                            .inputs = std::vector<NavigationInput>(record.inputs),
                            .end = vector_of(record.end)};
        if (record.inputs != 0)
            std::memcpy(link.inputs.data(), bytes_.data() + input, record.inputs * sizeof(NavigationInput));
        input += record.inputs * sizeof(NavigationInput);
        if (!is_sound(link)) return origin_.damaged(offset, "has a link that cannot be gone over");
        state_.links.push_back(std::move(link));
    }
    if (input != layout_.table) return origin_.damaged(input, "has inputs of no link");
    return {};
}

Expected<void> SectionReader::read_tiles() {
    auto detour = make_detour(state_.plan, 0);
    if (!detour) return tl::unexpected(detour.error());
    state_.detour = *std::move(detour);
    std::uint64_t end = layout_.tiles;
    std::int64_t last = -1;
    for (std::uint32_t i = 0; i < header_.tiles; ++i) {
        const std::uint64_t offset = layout_.table + i * sizeof(SectionTile);
        const auto entry = at<SectionTile>(offset);
        if (entry.x < 0 || entry.x >= state_.plan.tiles_x || entry.z < 0 || entry.z >= state_.plan.tiles_z)
            return origin_.damaged(offset, "has a tile beyond its grid");
        const auto place = static_cast<std::int64_t>(state_.tile_index(entry.x, entry.z));
        if (place <= last) return origin_.damaged(offset, "has its tiles twice or in another order");
        last = place;
        if (entry.offset != end || end > bytes_.size() || entry.size > bytes_.size() - end || entry.size > INT32_MAX)
            return origin_.damaged(offset, "has a tile that lies elsewhere than behind the one before");
        end = aligned(end + entry.size, tile_alignment);
        if (auto put = read_tile(entry); !put) return put;
    }
    if (end != bytes_.size()) return origin_.damaged(end, "has something behind its tiles");
    return {};
}

Expected<void> SectionReader::read_tile(const SectionTile& entry) {
    const std::span<std::byte> bytes =
        bytes_.subspan(static_cast<std::size_t>(entry.offset), static_cast<std::size_t>(entry.size));
    const TileFrame frame{.plan = state_.plan,
                          .x = entry.x,
                          .z = entry.z,
                          .areas = state_.areas,
                          .links = state_.links.size(),
                          .most_polygons = static_cast<std::size_t>(state_.detour->getParams()->maxPolys)};
    const std::string name = "tile " + std::to_string(entry.x) + ", " + std::to_string(entry.z);
    if (auto fault = tile_fault(bytes, frame))
        return origin_.damaged(entry.offset + fault->byte, "has a damaged tile: " + name + " " + fault->what);
    // The memory stays ours: Detour writes into it, and does not free it.
    constexpr int stays_ours = 0;
    if (dtStatusFailed(state_.detour->addTile(reinterpret_cast<unsigned char*>(bytes.data()),
                                              static_cast<int>(bytes.size()), stays_ours, 0, nullptr)))
        return origin_.damaged(entry.offset, "has a tile that Detour does not take: " + name);
    return {};
}

}  // namespace

bool is_sound(const NavigationLink& link) {
    const auto is_place = [](const dvec3& v) {
        return std::abs(v.x) <= largest_coordinate && std::abs(v.y) <= largest_coordinate &&
               std::abs(v.z) <= largest_coordinate;
    };
    constexpr double longest = 3600;  // [s] whoever needs an hour for a link is stuck
    if (!is_place(link.from) || !is_place(link.to) || !is_place(link.takeoff) || !is_place(link.end) ||
        !(link.speed > 0 && link.speed <= largest_coordinate) || !(link.tick > 0 && link.tick <= 1) ||
        !(link.seconds >= 0 && link.seconds <= longest))
        return false;
    double seconds = 0;
    for (const NavigationInput& input : link.inputs) {
        if (!is_place(input.wish) || input.jump > 1 || input.crouch > 1) return false;
        seconds += input.ticks * link.tick;
    }
    return seconds <= longest;
}

}  // namespace navigation

inline namespace v0 {

using navigation::MeshState;

Expected<NavigationMesh> NavigationMesh::open(const std::string& path) {
    auto opened = PrivateSection::open(path, navigation::section_owner, navigation::section_name, Check::everything);
    if (!opened) return tl::unexpected(std::move(opened.error()));
    std::optional<PrivateSection>& section = *opened;
    const navigation::Origin origin{path, section ? section->offset() : 0};
    if (!section) return origin.error(ErrorCode::not_found, 0, "is not there");
    if (section->made_from() != section->mesh_made_from())
        return origin.damaged(0, "was made from other triangles than those of the file");
    auto state = std::make_unique<MeshState>();
    if (auto read = navigation::SectionReader(section->bytes(), origin, *state).read(); !read)
        return tl::unexpected(read.error());
    state->section = std::move(section);
    return NavigationMesh(std::move(state));
}

namespace {

Expected<std::unique_ptr<MeshState>> read_copy(std::span<const std::byte> bytes, const navigation::Origin& origin) {
    auto state = std::make_unique<MeshState>();
    state->bytes.assign(bytes.begin(), bytes.end());
    if (auto read = navigation::SectionReader(state->bytes, origin, *state).read(); !read)
        return tl::unexpected(read.error());
    return state;
}

}  // namespace

Expected<NavigationMesh> NavigationMesh::read(const Mesh& mesh) {
    const navigation::Origin origin{};
    const auto section = mesh.section(navigation::section_owner, navigation::section_name);
    if (!section) return origin.error(ErrorCode::not_found, 0, "is not there");
    if (section->made_from != mesh.made_from())
        return origin.damaged(0, "was made from other triangles than those of the file");
    auto state = read_copy(section->bytes, origin);
    if (!state) return tl::unexpected(state.error());
    return NavigationMesh(*std::move(state));
}

Expected<NavigationMesh> NavigationMesh::read(std::span<const std::byte> bytes, const std::string& file) {
    auto state = read_copy(bytes, {file, 0});
    if (!state) return tl::unexpected(state.error());
    return NavigationMesh(*std::move(state));
}

}  // namespace v0
}  // namespace surefoot
