#include "playground/navigation/link_search.hpp"

#include <surefoot/navigation_links.hpp>

namespace surefoot::playground {

LinkSearch::~LinkSearch() {
    stop_ = true;
    if (result_.valid()) result_.wait();
}

void LinkSearch::begin(const NavigationScene& scene, bool at_once) {
    if (is_busy()) return;
    done_ = 0;
    all_ = 0;
    result_ = std::async(at_once ? std::launch::deferred : std::launch::async, [this, &scene] {
        const auto tell = [this](std::size_t done, std::size_t all) {
            all_ = all;
            done_ = done;
        };
        Found found;
        found.links = find_links(scene.world, scene.settings, scene.mesh, {.progress = tell, .stop = &stop_});
        for (const NavigationLink& link : found.links)
            found.arcs.push_back(arc_of(scene.world, scene.settings, scene.mesh, link));
        return found;
    });
}

double LinkSearch::share() const {
    const std::size_t all = all_;
    return all == 0 ? 0 : static_cast<double>(done_.load()) / static_cast<double>(all);
}

std::optional<LinkSearch::Found> LinkSearch::take() {
    if (!is_busy() || result_.wait_for(std::chrono::seconds(0)) == std::future_status::timeout) return std::nullopt;
    return result_.get();
}

Expected<void> put_links(NavigationScene& scene, LinkSearch::Found found) {
    const auto left_out = scene.mesh.set_links(found.links);
    if (!left_out) return tl::unexpected(left_out.error());
    scene.arcs = std::move(found.arcs);
    if (*left_out > 0) {
        scene.arcs.clear();
        for (const NavigationLink& link : scene.mesh.links())
            scene.arcs.push_back(arc_of(scene.world, scene.settings, scene.mesh, link));
    }
    scene.read_outlines();
    return {};
}

}  // namespace surefoot::playground
