/// The way from a start to a target on a navigation mesh, and the search that found it, round by round.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <surefoot/navigation_query.hpp>

#include "playground/navigation/scene.hpp"

namespace surefoot::playground {

class NavigationWay {
public:
    explicit NavigationWay(const NavigationScene& scene);

    /// The nearest place of the mesh, as far aside as a step and as far down as a person is high.
    [[nodiscard]] std::optional<NavigationPoint> place_near(const dvec3& feet) const;

    /// Looks for the way between these places of feet.
    void plan(const dvec3& from, const dvec3& to);

    /// Null if there is none; then `words` says why.
    [[nodiscard]] const NavigationPath* path() const { return path_ ? &*path_ : nullptr; }
    [[nodiscard]] const std::string& words() const { return words_; }

    /// The raw and the pulled path, laid on the ground, and over links as the feet go.
    [[nodiscard]] const std::vector<dvec3>& raw_line() const { return raw_line_; }
    [[nodiscard]] const std::vector<dvec3>& pulled_line() const { return pulled_line_; }

    // The search: in round r the r-th polygon is looked at. Nothing of it is worked out until it is asked for.
    [[nodiscard]] std::size_t rounds();
    /// What it has come upon after so many rounds.
    [[nodiscard]] const std::vector<NavigationSearchNode>& nodes_after(std::size_t rounds);
    /// The one that was looked at in the round that was asked for last; null for round 0.
    [[nodiscard]] const NavigationSearchNode* looked_at() const { return looked_at_ ? &nodes_[*looked_at_] : nullptr; }

    [[nodiscard]] const NavigationQuery& query() const { return query_; }

private:
    bool begin_search();
    void lay(std::vector<dvec3>& line, const dvec3& to) const;
    void read_nodes(std::vector<NavigationSearchNode>& nodes) const;

    const NavigationScene* scene_;
    NavigationQuery query_;
    NavigationQuery search_;  // a search that is under way ends when something else is asked
    std::optional<NavigationPoint> from_;
    std::optional<NavigationPoint> to_;
    std::optional<NavigationPath> path_;
    std::string words_;
    std::vector<dvec3> raw_line_;
    std::vector<dvec3> pulled_line_;
    std::optional<std::size_t> rounds_;
    std::optional<std::size_t> shown_;
    std::vector<NavigationSearchNode> nodes_;
    std::optional<std::size_t> looked_at_;
};

}  // namespace surefoot::playground
