#include "playground/navigation/runners.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace surefoot::playground {
namespace {

CharacterState standing_at(const NavigationScene& scene, const dvec3& feet) {
    constexpr int settle = 60;  // [ticks]
    CharacterState state;
    state.position = scene.above(feet);
    const CharacterInput input{.up = scene.up()};
    for (int i = 0; i < settle && (i == 0 || state.footing != Footing::ground); ++i)
        state = step(scene.world, scene.settings, input, NavigationRunners::tick, state).state;
    return state;
}

}  // namespace

dvec3 NavigationRunners::Runner::drawn_position(double waiting) const {
    const double share = std::clamp(waiting / tick, 0.0, 1.0);
    return before.position + (state.position - before.position) * share;
}

void NavigationRunners::be(std::size_t count, const NavigationScene& scene, const NavigationQuery& query,
                           const dvec3& start) {
    if (count < runners_.size()) runners_.resize(count);
    const NavigationAgent& agent = scene.mesh.agent();
    const auto begin = query.nearest(start, 2 * agent.radius, agent.height);
    if (!begin) return;
    while (runners_.size() < count) {
        const auto place = runners_.empty() ? begin : query.random_reachable(*begin, seed_++);
        if (!place) return;
        Runner runner;
        runner.before = runner.state = standing_at(scene, place->position);
        runners_.push_back(runner);
    }
}

void NavigationRunners::scatter(const NavigationScene& scene, const NavigationQuery& query, const dvec3& start) {
    const std::size_t count = runners_.size();
    runners_.clear();
    be(count, scene, query, start);
}

bool NavigationRunners::run(const NavigationScene& scene, const NavigationQuery& query, const dvec3& goal) {
    bool moves = false;
    for (Runner& runner : runners_) {
        runner.before = runner.state;
        runner.follower.go(query, goal);
        const CharacterInput input = runner.follower.input(query, runner.state, scene.settings, tick);
        runner.state = step(scene.world, scene.settings, input, tick, runner.state).state;
        moves = moves || runner.state.position != runner.before.position ||
                runner.follower.status() == NavigationFollowStatus::following;
    }
    return moves;
}

std::string NavigationRunners::words() const {
    std::size_t counts[4] = {};
    std::string_view why;
    for (const Runner& runner : runners_) {
        ++counts[static_cast<std::size_t>(runner.follower.status())];
        if (runner.follower.status() == NavigationFollowStatus::gave_up && why.empty())
            why = sentence(runner.follower.reason());
    }
    const auto count = [&](NavigationFollowStatus status) { return counts[static_cast<std::size_t>(status)]; };
    std::string text = fmt::format("{} on the way, {} arrived", count(NavigationFollowStatus::following),
                                   count(NavigationFollowStatus::arrived));
    if (const std::size_t gave_up = count(NavigationFollowStatus::gave_up); gave_up > 0)
        text += fmt::format(", {} gave up: {}", gave_up, why);
    return text;
}

}  // namespace surefoot::playground
