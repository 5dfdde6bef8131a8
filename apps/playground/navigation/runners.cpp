#include "playground/navigation/runners.hpp"

#include <algorithm>
#include <fmt/format.h>

#include <surefoot/navigation_links.hpp>

namespace surefoot::playground {

NavigationRunners::NavigationRunners(const NavigationScene& scene)
    : scene_(&scene), worker_(scene.mesh), crowd_(scene.mesh, 0) {}

void NavigationRunners::be(std::size_t count, const dvec3& start) {
    if (count < states_.size()) states_.resize(count);
    const NavigationAgent& agent = scene_->mesh.agent();
    const NavigationQuery& query = worker_.query();
    const auto begin = query.nearest(start, 2 * agent.radius, agent.height);
    while (begin && states_.size() < count) {
        const auto place = states_.empty() ? begin : query.random_reachable(*begin, seed_++);
        if (!place) break;
        states_.push_back(stand_at(scene_->world, scene_->settings, place->position, scene_->up(), tick));
    }
    before_ = states_;
    inputs_.resize(states_.size());
    crowd_.resize(states_.size());
}

void NavigationRunners::scatter(const dvec3& start) {
    const std::size_t count = states_.size();
    states_.clear();
    crowd_.resize(0);
    be(count, start);
}

void NavigationRunners::look_again() {
    for (std::size_t i = 0; i < states_.size(); ++i) crowd_.stop(i);
}

bool NavigationRunners::run(const dvec3& goal) {
    before_ = states_;
    for (std::size_t i = 0; i < states_.size(); ++i) crowd_.go(worker_.query(), i, goal);
    if (!crowd_.gather(states_)) return false;
    crowd_.steer(worker_, scene_->settings, tick, inputs_);
    const Characters all{.settings = {&scene_->settings, 1}, .inputs = inputs_, .before = states_, .after = states_};
    if (!feet_.gather(all, tick)) return false;
    step_all(scene_->world, feet_, all, tick);
    bool moves = false;
    for (std::size_t i = 0; i < states_.size(); ++i)
        moves = moves || states_[i].position != before_[i].position ||
                follower(i).status() == NavigationFollowStatus::following;
    return moves;
}

dvec3 NavigationRunners::drawn_position(std::size_t i, double waiting) const {
    const double share = std::clamp(waiting / tick, 0.0, 1.0);
    return before_[i].position + (states_[i].position - before_[i].position) * share;
}

std::string NavigationRunners::words() const {
    std::size_t counts[4] = {};
    std::string_view why;
    for (std::size_t i = 0; i < states_.size(); ++i) {
        ++counts[static_cast<std::size_t>(follower(i).status())];
        if (follower(i).status() == NavigationFollowStatus::gave_up && why.empty())
            why = sentence(follower(i).reason());
    }
    const auto count = [&](NavigationFollowStatus status) { return counts[static_cast<std::size_t>(status)]; };
    std::string text = fmt::format("{} on the way, {} arrived", count(NavigationFollowStatus::following),
                                   count(NavigationFollowStatus::arrived));
    if (const std::size_t gave_up = count(NavigationFollowStatus::gave_up); gave_up > 0)
        text += fmt::format(", {} gave up: {}", gave_up, why);
    return text;
}

}  // namespace surefoot::playground
