#include <algorithm>
#include <utility>

#include <surefoot/navigation_query.hpp>

#include "mesh_state.hpp"

namespace surefoot {

namespace navigation {
namespace {

/// Those that begin and end on the mesh, doors open or shut, in tiles that Detour joins.
std::vector<NavigationLink> near_mesh(const NavigationMesh& mesh, std::span<const NavigationLink> links) {
    const NavigationQuery query(mesh, 16, NavigationDoors::open);
    const double aside = mesh.agent().radius;
    const double vertical = std::max(mesh.agent().climb, 2 * mesh.state().plan.cell_height);
    std::vector<NavigationLink> near;
    for (const NavigationLink& link : links)
        if (mesh.state().are_near(link.from, link.to) && query.nearest(link.from, aside, vertical) &&
            query.nearest(link.to, aside, vertical))
            near.push_back(link);
    return near;
}

/// What was taken out stays so, though its tile is put in anew.
Expected<void> put_anew(MeshState& state, const TileMesh& tile) {
    dtNavMesh& detour = *state.detour;
    std::vector<std::uint16_t> flags;
    if (const dtMeshTile* before = std::as_const(detour).getTileAt(tile.x, tile.z, 0))
        for (int i = 0; i < before->header->offMeshBase; ++i) flags.push_back(before->polys[i].flags);
    if (auto done = put_tile(state, tile); !done) return done;
    const dtMeshTile* after = std::as_const(detour).getTileAt(tile.x, tile.z, 0);
    if (after == nullptr) return {};
    const dtPolyRef first = detour.getPolyRefBase(after);
    for (std::size_t i = 0; i < flags.size(); ++i) detour.setPolyFlags(first | static_cast<dtPolyRef>(i), flags[i]);
    return {};
}

/// Does a polygon lead on to another?
bool leads_to(const dtNavMesh& detour, dtPolyRef from, dtPolyRef to) {
    const dtMeshTile* tile = nullptr;
    const dtPoly* polygon = nullptr;
    if (dtStatusFailed(detour.getTileAndPolyByRef(from, &tile, &polygon))) return false;
    for (unsigned int i = polygon->firstLink; i != DT_NULL_LINK; i = tile->links[i].next)
        if (tile->links[i].ref == to) return true;
    return false;
}

/// Of each link: did Detour find the ground on to which and off which it leads? It says nothing where it did not.
std::vector<bool> links_that_lead(const MeshState& state) {
    const dtNavMesh& detour = *state.detour;
    std::vector<bool> leads(state.links.size(), false);
    for (int i = 0; i < detour.getMaxTiles(); ++i) {
        const dtMeshTile* tile = detour.getTile(i);
        if (tile->header == nullptr) continue;
        for (int c = 0; c < tile->header->offMeshConCount; ++c) {
            const dtOffMeshConnection& connection = tile->offMeshCons[c];
            const dtPolyRef here = detour.getPolyRefBase(tile) | static_cast<dtPolyRef>(connection.poly);
            bool begins = false;
            bool ends = false;
            const dtPoly& polygon = tile->polys[connection.poly];
            for (unsigned int at = polygon.firstLink; at != DT_NULL_LINK; at = tile->links[at].next) {
                ends = ends || tile->links[at].edge == 1;
                begins = begins || (tile->links[at].edge == 0 && leads_to(detour, tile->links[at].ref, here));
            }
            leads[connection.userId] = begins && ends;
        }
    }
    return leads;
}

}  // namespace
}  // namespace navigation

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
    ++state_->link_changes;
    state_->links = navigation::near_mesh(*this, links);
    for (;;) {
        touch();
        for (std::size_t i = 0; i < touched.size(); ++i)
            if (touched[i])
                if (auto done = navigation::put_anew(*state_, state_->tile_meshes[i]); !done)
                    return tl::unexpected(done.error());
        // Whatever Detour made nothing of is not there; the others get other numbers, so they are put in again.
        const std::vector<bool> leads = navigation::links_that_lead(*state_);
        if (std::find(leads.begin(), leads.end(), false) == leads.end()) break;
        std::vector<NavigationLink> kept;
        for (std::size_t i = 0; i < leads.size(); ++i)
            if (leads[i]) kept.push_back(std::move(state_->links[i]));
        state_->links = std::move(kept);
    }
    return links.size() - state_->links.size();
}

}  // namespace v0
}  // namespace surefoot
