#include <algorithm>
#include <utility>

#include <surefoot/navigation_query.hpp>

#include "mesh_state.hpp"

namespace surefoot {
inline namespace v0 {

Expected<std::size_t> NavigationMesh::set_links(std::span<const NavigationLink> links) {
    if (state_->tile_meshes.empty())
        return tl::unexpected(Error{.code = ErrorCode::invalid,
                                    .text = "navigation: a mesh that was opened keeps the links it has; build it anew",
                                    .file = {}});
    if (!std::all_of(links.begin(), links.end(), navigation::is_sound))
        return tl::unexpected(Error{.code = ErrorCode::invalid,
                                    .text = "navigation: a link has a number that is not finite or far too large",
                                    .file = {}});
    std::vector<bool> touched(state_->tile_meshes.size(), false);
    const auto touch = [&] {
        for (const NavigationLink& link : state_->links)
            touched[state_->tile_at(state_->plan.frame.in(link.from))] = true;
    };
    touch();
    std::vector<NavigationLink> kept;
    {
        const NavigationQuery query(*this, 16);
        const double aside = agent().radius;
        const double vertical = std::max(agent().climb, 2 * state_->plan.cell_height);
        for (const NavigationLink& link : links)
            if (query.nearest(link.from, aside, vertical) && query.nearest(link.to, aside, vertical))
                kept.push_back(link);
    }
    // What was taken out stays so, though its tile is put in anew.
    const auto put = [&](const navigation::TileMesh& tile) -> Expected<void> {
        dtNavMesh& detour = *state_->detour;
        std::vector<std::uint16_t> flags;
        if (const dtMeshTile* before = std::as_const(detour).getTileAt(tile.x, tile.z, 0))
            for (int i = 0; i < before->header->offMeshBase; ++i) flags.push_back(before->polys[i].flags);
        if (auto done = navigation::put_tile(*state_, tile); !done) return done;
        const dtMeshTile* after = std::as_const(detour).getTileAt(tile.x, tile.z, 0);
        if (after == nullptr) return {};
        const dtPolyRef first = detour.getPolyRefBase(after);
        for (std::size_t i = 0; i < flags.size(); ++i) detour.setPolyFlags(first | static_cast<dtPolyRef>(i), flags[i]);
        return {};
    };
    const std::size_t left_out = links.size() - kept.size();
    state_->links = std::move(kept);
    touch();
    for (std::size_t i = 0; i < touched.size(); ++i)
        if (touched[i])
            if (auto done = put(state_->tile_meshes[i]); !done) return tl::unexpected(done.error());
    return left_out;
}

}  // namespace v0
}  // namespace surefoot
