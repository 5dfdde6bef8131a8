#include "playground/navigation/way.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <glm/geometric.hpp>

namespace surefoot::playground {

NavigationWay::NavigationWay(const NavigationScene& scene) : scene_(&scene), query_(scene.mesh), search_(scene.mesh) {}

std::optional<NavigationPoint> NavigationWay::place_near(const dvec3& feet) const {
    const NavigationAgent& agent = scene_->mesh.agent();
    if (const auto under = query_.under(feet, agent.height, agent.climb)) return under;
    return query_.nearest(feet, 2 * agent.radius, agent.height);
}

void NavigationWay::plan(const dvec3& from, const dvec3& to) {
    rounds_.reset();
    shown_.reset();
    path_.reset();
    words_.clear();
    raw_line_.clear();
    pulled_line_.clear();
    from_ = place_near(from);
    to_ = place_near(to);
    if (!from_ || !to_) {
        words_ = !from_ ? "The start is not on the mesh." : "The target is not on the mesh.";
        return;
    }
    path_ = query_.path(*from_, *to_);
    if (path_) {
        for (const dvec3& middle : path_->midpoints) lay(raw_line_, middle);
        std::optional<std::uint32_t> link;
        for (const NavigationCorner& corner : path_->corners) {
            if (link && *link < scene_->arcs.size()) {
                const std::vector<dvec3>& arc = scene_->arcs[*link].places;
                pulled_line_.insert(pulled_line_.end(), arc.begin(), arc.end());
                pulled_line_.push_back(corner.position);
            } else {
                lay(pulled_line_, corner.position);
            }
            link = corner.link;
        }
    }
    if (!path_) {
        words_ = "There is no way.";
    } else if (path_->partial) {
        words_ = fmt::format("No way leads there; this is as near as it gets, {:.1f} m of way.", path_->length);
    } else {
        words_ = fmt::format("{:.1f} m over {} polygons, {} bends.", path_->length, path_->polygons.size(),
                             path_->corners.size() > 2 ? path_->corners.size() - 2 : 0);
    }
}

/// Goes on straight to a place, as seen from above, with the ground's ups and downs.
void NavigationWay::lay(std::vector<dvec3>& line, const dvec3& to) const {
    if (!line.empty()) {
        constexpr double stride = 0.4;  // [m]
        const dvec3 from = line.back();
        const int pieces = static_cast<int>(std::min(glm::length(to - from) / stride, 1000.0));
        for (int i = 1; i < pieces; ++i) {
            const dvec3 place = from + (to - from) * (static_cast<double>(i) / pieces);
            const auto ground = query_.nearest(place, 0.1, 2 * scene_->mesh.agent().height);
            line.push_back(ground ? ground->position : place);
        }
    }
    line.push_back(to);
}

bool NavigationWay::begin_search() {
    return from_ && to_ && search_.begin_search(*from_, *to_);
}

std::size_t NavigationWay::rounds() {
    if (rounds_) return *rounds_;
    rounds_ = 0;
    if (!begin_search()) return 0;
    while (search_.advance_search(1)) ++*rounds_;
    return ++*rounds_;
}

void NavigationWay::read_nodes(std::vector<NavigationSearchNode>& nodes) const {
    nodes.resize(search_.search_nodes({}));
    nodes.resize(std::min(search_.search_nodes(nodes), nodes.size()));
}

const std::vector<NavigationSearchNode>& NavigationWay::nodes_after(std::size_t rounds) {
    if (shown_ == rounds) return nodes_;
    shown_ = rounds;
    nodes_.clear();
    looked_at_.reset();
    if (!begin_search()) return nodes_;
    std::vector<NavigationSearchNode> before;
    if (rounds > 1) search_.advance_search(rounds - 1);
    read_nodes(before);
    if (rounds > 0) search_.advance_search(1);
    read_nodes(nodes_);
    for (std::size_t i = 0; i < nodes_.size() && rounds > 0; ++i) {
        if (nodes_[i].open) continue;
        const auto same = std::find_if(before.begin(), before.end(), [&](const NavigationSearchNode& node) {
            return node.polygon == nodes_[i].polygon;
        });
        if (same == before.end() || same->open) looked_at_ = i;
    }
    return nodes_;
}

}  // namespace surefoot::playground
