/// Looks for the links of a scene beside the drawing: simulating thousands of jumps takes seconds.
#pragma once

#include <atomic>
#include <future>
#include <memory>
#include <optional>
#include <vector>

#include "playground/navigation/scene.hpp"

namespace surefoot::playground {

class LinkSearch {
public:
    struct Found {
        std::vector<NavigationLink> links;
        std::vector<LinkArc> arcs;  ///< one each
    };

    LinkSearch() = default;
    LinkSearch(const LinkSearch&) = delete;
    LinkSearch& operator=(const LinkSearch&) = delete;
    /// Gives up what is under way.
    ~LinkSearch();

    /// Until it is done the scene may be asked, but not changed.
    void begin(const NavigationScene& scene, bool at_once);

    [[nodiscard]] bool is_busy() const { return result_.valid(); }

    /// How much of the mesh's borders was gone along [0 to 1].
    [[nodiscard]] double share() const;

    /// What was found, once.
    [[nodiscard]] std::optional<Found> take();

private:
    std::atomic<bool> stop_{false};
    std::atomic<std::size_t> done_{0};
    std::atomic<std::size_t> all_{0};
    std::future<Found> result_;
};

/// Puts links into the scene's mesh and shows their arcs. Fails as `NavigationMesh::set_links` does.
[[nodiscard]] Expected<void> put_links(NavigationScene& scene, LinkSearch::Found found);

}  // namespace surefoot::playground
