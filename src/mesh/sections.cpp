#include "mesh/sections.hpp"

#include <algorithm>
#include <cstring>

#include "limits.hpp"

namespace surefoot::internal {
namespace {

constexpr std::string_view array_names[] = {"nodes", "leaves", "places", "surfaces", "tiles", "hidden"};
constexpr std::string_view info_name = "mesh";

template <typename T>
Section section(std::string_view name, std::span<const T> items) noexcept {
    return {surefoot_owner, name, mesh_version, 0, std::as_bytes(items)};
}

class Reader {
public:
    explicit Reader(const Container& container) : container_(container) {}

    /// An array of so many; none at all unless it is needed.
    template <typename T>
    [[nodiscard]] Expected<std::span<const T>> array(std::string_view name, bool needed) const {
        const Section* const found = container_.find(surefoot_owner, name);
        if (found == nullptr) {
            if (!needed) return std::span<const T>{};
            return fail(0, "has no section '" + std::string(name) + "'");
        }
        const std::uint64_t at = container_.offset_of(*found);
        if (found->version != mesh_version) {
            Error error =
                file_error(ErrorCode::unsupported, container_.file(), at,
                           "has version " + std::to_string(found->version) + " of its section '" + std::string(name) +
                               "', and this Surefoot reads version " + std::to_string(mesh_version));
            return tl::unexpected(std::move(error));
        }
        if (found->bytes.size() % sizeof(T) != 0)
            return fail(at, "has a section '" + std::string(name) + "' of an odd size");
        // Sections begin at multiples of 64, so that the arrays are aligned where they lie.
        return std::span<const T>{reinterpret_cast<const T*>(found->bytes.data()), found->bytes.size() / sizeof(T)};
    }

    [[nodiscard]] tl::unexpected<Error> fail(std::uint64_t byte, const std::string& what) const {
        return tl::unexpected(file_error(ErrorCode::unreadable, container_.file(), byte, what));
    }
    [[nodiscard]] tl::unexpected<Error> fail(std::string_view name, const std::string& what) const {
        const Section* const found = container_.find(surefoot_owner, name);
        return fail(found == nullptr ? 0 : container_.offset_of(*found), what);
    }

private:
    const Container& container_;
};

bool is_within_limits(const MeshInfo& info) noexcept {
    for (int i = 0; i < 3; ++i)
        if (!(info.low[i] <= info.high[i] && info.low[i] >= -largest_coordinate && info.high[i] <= largest_coordinate))
            return false;
    return true;
}

}  // namespace

MeshInfo info_of(const MeshView& view) noexcept {
    MeshInfo info;
    info.triangle_count = view.places.size();
    info.vertex_count = view.vertex_count;
    const Vec sides[2] = {view.bounds.min, view.bounds.max};
    double* const out[2] = {info.low, info.high};
    for (int i = 0; i < 2; ++i) {
        out[i][0] = sides[i].x;
        out[i][1] = sides[i].y;
        out[i][2] = sides[i].z;
    }
    return info;
}

std::vector<Section> sections_of(const MeshView& view, const MeshInfo& info) {
    std::vector<Section> sections{section(info_name, std::span(&info, 1)), section("nodes", view.nodes),
                                  section("leaves", view.leaves), section("places", view.places)};
    if (!view.surfaces.empty()) sections.push_back(section("surfaces", view.surfaces));
    if (!view.tiles.empty()) sections.push_back(section("tiles", view.tiles));
    if (!view.hidden.empty()) sections.push_back(section("hidden", view.hidden));
    return sections;
}

bool is_mesh_section(const Section& section) noexcept {
    return section.owner == surefoot_owner &&
           (section.name == info_name ||
            std::find(std::begin(array_names), std::end(array_names), section.name) != std::end(array_names));
}

Expected<MeshView> view_of(const Container& container, Check check) {
    if (check == Check::everything)
        if (const auto sums = container.check_sums(); !sums) return tl::unexpected(sums.error());
    const Reader reader(container);
    const auto infos = reader.array<MeshInfo>(info_name, true);
    const auto nodes = reader.array<WideNode>("nodes", true);
    const auto leaves = reader.array<std::uint32_t>("leaves", true);
    const auto places = reader.array<std::uint32_t>("places", true);
    const auto surfaces = reader.array<std::uint32_t>("surfaces", false);
    const auto tiles = reader.array<dvec3>("tiles", false);
    const auto hidden = reader.array<std::uint64_t>("hidden", false);
    for (const Error* error :
         {infos ? nullptr : &infos.error(), nodes ? nullptr : &nodes.error(), leaves ? nullptr : &leaves.error(),
          places ? nullptr : &places.error(), surfaces ? nullptr : &surfaces.error(), tiles ? nullptr : &tiles.error(),
          hidden ? nullptr : &hidden.error()})
        if (error != nullptr) return tl::unexpected(*error);
    if (infos->size() != 1) return reader.fail(info_name, "has a section 'mesh' of an odd size");
    const MeshInfo& info = infos->front();
    if (info.node_size != sizeof(WideNode) || info.leaf_padding_words != leaf_padding)
        return reader.fail(info_name, "has nodes or leaves of another layout");
    if (!is_within_limits(info)) return reader.fail(info_name, "has bounds that are no box within 1e9 m");
    if (info.triangle_count != places->size() || places->size() > std::uint64_t{leaf_bit} ||
        nodes->size() >= std::uint64_t{leaf_bit} || leaves->size() > std::uint64_t{most_leaf_words} + leaf_padding)
        return reader.fail("places", "has another number of triangles than it says, or too many");
    if (!surfaces->empty() && surfaces->size() != places->size())
        return reader.fail("surfaces", "has another number of surfaces than of triangles");
    MeshView view{.nodes = *nodes,
                  .leaves = *leaves,
                  .places = *places,
                  .surfaces = *surfaces,
                  .tiles = *tiles,
                  .hidden = *hidden,
                  .bounds = {{info.low[0], info.low[1], info.low[2]}, {info.high[0], info.high[1], info.high[2]}},
                  .vertex_count = info.vertex_count};
    if (check != Check::header)
        if (const auto sound = check_structure(view, container); !sound) return tl::unexpected(sound.error());
    return view;
}

}  // namespace surefoot::internal
