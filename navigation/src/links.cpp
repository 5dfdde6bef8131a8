#include <algorithm>

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
    const std::size_t left_out = links.size() - kept.size();
    state_->links = std::move(kept);
    touch();
    for (std::size_t i = 0; i < touched.size(); ++i)
        if (touched[i])
            if (auto put = navigation::put_tile(*state_, state_->tile_meshes[i]); !put)
                return tl::unexpected(put.error());
    return left_out;
}

}  // namespace v0
}  // namespace surefoot
