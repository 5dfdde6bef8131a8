// How a follower comes to its line: goals, plans, and what to do when the mesh has changed.
#include <algorithm>
#include <cmath>
#include <limits>

#include <surefoot/navigation_follow.hpp>

#include "follow_line.hpp"
#include "follow_sight.hpp"

namespace surefoot {
inline namespace v0 {

using navigation::dot;
using navigation::length;
using navigation::level;
using Status = NavigationFollowStatus;
using Reason = NavigationFollowReason;

void NavigationFollower::go(const NavigationQuery& query, const dvec3& goal) {
    const std::optional<NavigationPoint> found = near_goal(query, goal);
    if (!found) {
        goal_ = {goal, {}};
        return give_up(Reason::goal_off_mesh);
    }
    const double moved = length(found->position - goal_.position);
    if (status_ == Status::following && field_ == nullptr) return move_goal(query, *found);
    if (status_ == Status::arrived && moved <= options_.arrival) return;
    if (status_ == Status::gave_up && reason_ != Reason::goal_off_mesh &&
        length(found->position - planned_goal_) <= options_.goal_moved)
        return;
    field_ = nullptr;
    begin(*found);
}

void NavigationFollower::go(const NavigationQuery&, const NavigationField& field,
                            const NavigationDescendOptions& options) {
    if (field_ == &field && status_ == Status::following) return;
    field_ = &field;
    descend_ = options;
    path_ = {};
    begin(field.goal());
}

void NavigationFollower::begin(const NavigationPoint& goal) {
    status_ = Status::following;
    reason_ = Reason::none;
    goal_ = goal;
    wants_plan_ = true;
    least_left_ = std::numeric_limits<double>::infinity();
    without_ = lost_ = since_check_ = 0;
    tried_ = 0;
    plans_ = links_ = 0;
    careful_.clear();
    failed_.clear();
    avoided_.clear();
    line_.points.clear();
    along_ = begin_ = best_along_ = 0;
}

void NavigationFollower::move_goal(const NavigationQuery& query, const NavigationPoint& goal) {
    const dvec3 moved = goal.position - goal_.position;
    if (dot(moved, moved) == 0) return;
    const bool is_far = length(goal.position - planned_goal_) > std::max(options_.goal_moved, left() / 10);
    const NavigationPoint before = goal_;
    goal_ = goal;
    if (wants_plan_ || line_.points.empty()) return;
    if (is_far || path_.partial || !navigation::sees(query.state(), before, goal.position)) {
        wants_plan_ = true;
        least_left_ = std::numeric_limits<double>::infinity();
        return;
    }
    // The end of the line follows: straight from the last bend where that can be seen, else from the old end.
    std::vector<NavigationLine::Point>& points = line_.points;
    const std::size_t last = points.size() - 1;
    if (last > 0 && !points[last - 1].link && navigation::sees(query.state(), goal, points[last - 1].position))
        points.pop_back();
    points.push_back({.position = goal.position,
                      .along = points.back().along + length(goal.position - points.back().position),
                      .link = {}});
    along_ = std::min(along_, points.back().along);
    best_along_ = std::min(best_along_, along_);
}

std::optional<NavigationPoint> NavigationFollower::step_aside(const NavigationQuery& query) const {
    const dvec3& up = query.mesh().up();
    const dvec3 ahead = level(aim_ - place_.position, up);
    const double size = length(ahead);
    if (!(size > 0)) return std::nullopt;
    // Back and to the left, the next time to the right.
    const dvec3 left = navigation::cross(up, ahead / size);
    const double turn = tried_ % 4 == 2 ? 1 : -1;
    const double reach = 2 * query.mesh().agent().radius;
    const dvec3 to = place_.position + left * (turn * reach) - ahead / size * reach;
    return navigation::moved_along(query.state(), place_, to);
}

bool NavigationFollower::plan(const NavigationQuery& query) {
    wants_plan_ = false;
    ++plans_;
    planned_goal_ = goal_.position;
    const std::optional<NavigationPoint> beside = tried_ > 0 && tried_ % 2 == 0 ? step_aside(query) : std::nullopt;
    along_ = begin_ = best_along_ = 0;
    without_ = since_check_ = 0;
    if (field_ != nullptr) return plan_down(query, beside);
    std::optional<NavigationPath> path = find_path(query, beside.value_or(place_));
    if (!path || (path->partial && !options_.go_near)) {
        give_up(Reason::no_path);
        return false;
    }
    path_ = std::move(*path);
    // A line that keeps away from walls gets past what the shortest one snags on.
    line_ = tried_ % 2 == 1 ? navigation::middle_line(path_) : navigation::pulled_line(path_);
    if (beside) line_ = navigation::line_from(place_.position, line_);
    return true;
}

bool NavigationFollower::refresh(const NavigationQuery& query) {
    const navigation::MeshState& mesh = query.state().ground();
    if (mesh.link_changes != link_changes_) {
        // Links have other numbers, and what was said of the old ones holds no more.
        if (link_changes_ != 0) wants_plan_ = true;
        link_changes_ = mesh.link_changes;
        careful_.clear();
        failed_.clear();
        avoided_.clear();
    }
    if (field_ != nullptr || mesh.detour->isValidPolyRef(goal_.polygon.id)) return true;
    // The tile of the goal was put in anew: the ground is the same, or another is near.
    const std::optional<NavigationPoint> found = near_goal(query, goal_.position);
    if (!found) {
        give_up(Reason::goal_off_mesh);
        return false;
    }
    goal_ = *found;
    wants_plan_ = true;
    return true;
}

std::optional<NavigationPoint> NavigationFollower::near_goal(const NavigationQuery& query, const dvec3& goal) const {
    return query.nearest(goal, options_.beside_mesh, std::max(options_.beside_mesh, query.mesh().agent().height));
}

std::optional<NavigationPath> NavigationFollower::find_path(const NavigationQuery& query, const NavigationPoint& from) {
    std::optional<NavigationPath> path = query.path(from, goal_, avoided_);
    // Rather a link that failed than no way at all.
    if ((!path || path->partial) && !avoided_.empty()) return query.path(from, goal_);
    return path;
}

bool NavigationFollower::plan_down(const NavigationQuery& query, const std::optional<NavigationPoint>& beside) {
    NavigationDescent descent = field_->descend(query, beside.value_or(place_), descend_);
    if (field_->potential() == NavigationPotential::straight)
        descent.line = navigation::without_loops(descent.line, query.mesh().agent().radius);
    line_ = beside ? navigation::line_from(place_.position, descent.line) : std::move(descent.line);
    if (descent.arrived || (options_.go_near && !line_.points.empty())) return true;
    give_up(descent.minima.empty() ? Reason::no_path : Reason::local_minimum);
    return false;
}

}  // namespace v0
}  // namespace surefoot
