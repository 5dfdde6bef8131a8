#include <DetourCommon.h>
#include <DetourLocalBoundary.h>
#include <DetourObstacleAvoidance.h>
#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <new>
#include <vector>

#include <surefoot/navigation_crowd.hpp>

#include "crowd_grid.hpp"
#include "follow_line.hpp"
#include "follow_sight.hpp"
#include "query_state.hpp"

namespace surefoot {
namespace navigation {

struct AvoidanceFreed {
    void operator()(dtObstacleAvoidanceQuery* query) const { dtFreeObstacleAvoidanceQuery(query); }
};

constexpr int most_heeded = 6;
constexpr int most_borders = 8;

struct WorkerState {
    NavigationQuery query;
    std::unique_ptr<dtObstacleAvoidanceQuery, AvoidanceFreed> avoidance;
};

/// One of many.
struct Member {
    explicit Member(const NavigationFollowOptions& options) : follower(options) {}

    NavigationFollower follower;
    dtLocalBoundary borders;
    vec3 wanted{0, 0, 0};  ///< what it was told last, in the frame [m/s]
};

/// What others see of it.
struct Seen {
    vec3 velocity{0, 0, 0};
    vec3 wanted{0, 0, 0};
    dvec3 goal{0, 0, 0};
    bool is_there = false;
};

struct CrowdState {
    NavigationCrowdOptions options;
    const NavigationMesh* mesh = nullptr;
    std::vector<std::unique_ptr<Member>> members;
    std::vector<CharacterState> states;
    std::vector<vec3> places;  ///< of feet, in the frame
    std::vector<Seen> seen;
    CrowdGrid grid;
};

namespace {

struct Near {
    float squared = 0;
    std::uint32_t index = 0;
};

/// The nearest others, the nearest first, ties by their numbers.
struct Neighbours {
    std::array<Near, most_heeded> all{};
    std::size_t count = 0;

    void offer(const Near& near) {
        std::size_t at = count;
        while (at > 0 && (near.squared < all[at - 1].squared ||
                          (near.squared == all[at - 1].squared && near.index < all[at - 1].index)))
            --at;
        if (at >= all.size()) return;
        count = std::min(count + 1, all.size());
        for (std::size_t i = count - 1; i > at; --i) all[i] = all[i - 1];
        all[at] = near;
    }
};

Neighbours neighbours_of(const CrowdState& crowd, std::size_t index) {
    Neighbours found;
    const vec3& place = crowd.places[index];
    const auto range = static_cast<float>(crowd.options.range);
    const auto height = static_cast<float>(crowd.mesh->agent().height);
    crowd.grid.around(place, [&](std::uint32_t other) {
        if (other == index) return;
        const vec3 off = crowd.places[other] - place;
        const float squared = off.x * off.x + off.z * off.z;
        if (squared < range * range && std::abs(off.y) < height) found.offer({squared, other});
    });
    return found;
}

dtObstacleAvoidanceParams parameters(const NavigationCrowdOptions& options) {
    dtObstacleAvoidanceParams params{};
    params.velBias = 0.5F;
    params.weightDesVel = 2;
    params.weightCurVel = 0.75F;
    params.weightSide = 0.75F;
    params.weightToi = 2.5F;
    params.horizTime = static_cast<float>(options.horizon);
    const bool few = options.avoidance == NavigationAvoidance::few;
    params.adaptiveDivs = few ? 5 : 7;
    params.adaptiveRings = 2;
    params.adaptiveDepth = few ? 1 : options.avoidance == NavigationAvoidance::medium ? 2 : 3;
    return params;
}

/// Away from those who are nearer than elbow room.
vec3 pushed_apart(const CrowdState& crowd, std::size_t index, const Neighbours& near) {
    const auto room = static_cast<float>(2.5 * crowd.mesh->agent().radius);
    vec3 push{0, 0, 0};
    for (std::size_t i = 0; i < near.count; ++i) {
        const float distance = std::sqrt(near.all[i].squared);
        if (distance >= room) break;
        const vec3 off = crowd.places[index] - crowd.places[near.all[i].index];
        const float share = (1 - distance / room) / std::max(distance, 1e-3F);
        push += vec3{off.x * share, 0, off.z * share};
    }
    return push;
}

/// What it wants, bent by those who are near and by borders.
vec3 bent(const CrowdState& crowd, WorkerState& worker, Member& member, std::size_t index, const Neighbours& near,
          const vec3& wish) {
    const NavigationAgent& agent = crowd.mesh->agent();
    const QueryState& query = worker.query.state();
    const NavigationPoint& place = member.follower.place();
    const vec3 at = query.frame().in(place.position);
    const auto range = static_cast<float>(crowd.options.range);
    const vec3 moved =
        at - vec3{member.borders.getCenter()[0], member.borders.getCenter()[1], member.borders.getCenter()[2]};
    const float stale = range / 4;
    if (moved.x * moved.x + moved.z * moved.z > stale * stale ||
        !member.borders.isValid(query.detour.get(), &query.filter))
        member.borders.update(place.polygon.id, &at.x, range, query.detour.get(), &query.filter);

    dtObstacleAvoidanceQuery& avoidance = *worker.avoidance;
    avoidance.reset();
    const auto radius = static_cast<float>(agent.radius);
    for (std::size_t i = 0; i < near.count; ++i) {
        const std::uint32_t other = near.all[i].index;
        avoidance.addCircle(&crowd.places[other].x, radius, &crowd.seen[other].velocity.x, &crowd.seen[other].wanted.x);
    }
    for (int i = 0; i < member.borders.getSegmentCount(); ++i) {
        const float* s = member.borders.getSegment(i);
        // Only those whose inner side is seen.
        if (dtTriArea2D(&at.x, s, s + 3) >= 0) avoidance.addSegment(s, s + 3);
    }
    const auto most = static_cast<float>(member.follower.options().speed);
    vec3 wanted = wish + pushed_apart(crowd, index, near) * most;
    const float size = std::sqrt(wanted.x * wanted.x + wanted.z * wanted.z);
    const float limit = std::max(std::sqrt(wish.x * wish.x + wish.z * wish.z), 0.25F * most);
    if (size > limit) wanted *= limit / size;
    vec3 result = wanted;
    const dtObstacleAvoidanceParams params = parameters(crowd.options);
    avoidance.sampleVelocityAdaptive(&crowd.places[index].x, radius, limit, &crowd.seen[index].velocity.x, &wanted.x,
                                     &result.x, &params);
    return {result.x, 0, result.z};
}

/// As much of a velocity as keeps to the mesh for the next moment.
dvec3 kept_on_mesh(const QueryState& query, const Member& member, const dvec3& velocity) {
    constexpr double moment = 0.15;  // [s]
    if (member.borders.getSegmentCount() == 0) return velocity;
    const NavigationPoint& place = member.follower.place();
    const auto end = moved_along(query, place, place.position + velocity * moment);
    return end ? level(end->position - place.position, query.mesh->up()) / moment : velocity;
}

/// Is the goal taken by others who have the same, and did it come up to one of them?
bool is_beside_goal(const CrowdState& crowd, std::size_t index, const Neighbours& near) {
    const NavigationFollower& follower = crowd.members[index]->follower;
    const double radius = crowd.mesh->agent().radius;
    // So far out all of them would stand if they stood in a disc.
    const double disc = 2.5 * radius * std::sqrt(static_cast<double>(crowd.members.size()));
    if (!crowd.options.arrive_beside || follower.line().points.empty() || follower.left() > disc) return false;
    const double touching = 2.5 * radius;
    for (std::size_t i = 0; i < near.count; ++i) {
        const Seen& other = crowd.seen[near.all[i].index];
        if (near.all[i].squared > static_cast<float>(touching * touching)) return false;
        const dvec3 apart = other.goal - follower.goal().position;
        if (other.is_there && dot(apart, apart) <= radius * radius) return true;
    }
    return false;
}

}  // namespace
}  // namespace navigation

inline namespace v0 {

using navigation::CrowdState;
using navigation::Member;
using navigation::WorkerState;

NavigationCrowdWorker::NavigationCrowdWorker(const NavigationMesh& mesh)
    : state_(new WorkerState{.query = NavigationQuery(mesh), .avoidance = {}}) {
    state_->avoidance.reset(dtAllocObstacleAvoidanceQuery());
    if (!state_->avoidance || !state_->avoidance->init(navigation::most_heeded, navigation::most_borders))
        throw std::bad_alloc();
}
NavigationCrowdWorker::NavigationCrowdWorker(NavigationCrowdWorker&& other) noexcept = default;
NavigationCrowdWorker& NavigationCrowdWorker::operator=(NavigationCrowdWorker&& other) noexcept = default;
NavigationCrowdWorker::~NavigationCrowdWorker() = default;

const NavigationQuery& NavigationCrowdWorker::query() const noexcept {
    return state_->query;
}

NavigationCrowd::NavigationCrowd(const NavigationMesh& mesh, std::size_t count, const NavigationCrowdOptions& options)
    : state_(std::make_unique<CrowdState>()) {
    state_->options = options;
    state_->mesh = &mesh;
    resize(count);
}
NavigationCrowd::NavigationCrowd(NavigationCrowd&& other) noexcept = default;
NavigationCrowd& NavigationCrowd::operator=(NavigationCrowd&& other) noexcept = default;
NavigationCrowd::~NavigationCrowd() = default;

std::size_t NavigationCrowd::size() const noexcept {
    return state_->members.size();
}

void NavigationCrowd::resize(std::size_t count) {
    const std::size_t before = state_->members.size();
    state_->members.resize(count);
    for (std::size_t i = before; i < count; ++i) {
        NavigationFollowOptions options = state_->options.follow;
        // Two who block each other do not lose patience at once.
        options.patience *= 1 + static_cast<double>(i * 5 % 8) / 8;
        state_->members[i] = std::make_unique<Member>(options);
    }
    state_->states.clear();
}

void NavigationCrowd::go(const NavigationQuery& query, std::size_t index, const dvec3& goal) {
    assert(index < size() && "navigation: there is no such character in the crowd");
    if (index < size()) state_->members[index]->follower.go(query, goal);
}

void NavigationCrowd::stop(std::size_t index) noexcept {
    assert(index < size() && "navigation: there is no such character in the crowd");
    if (index < size()) state_->members[index]->follower.stop();
}

const NavigationFollower& NavigationCrowd::follower(std::size_t index) const noexcept {
    assert(index < size() && "navigation: there is no such character in the crowd");
    return state_->members[index]->follower;
}

bool NavigationCrowd::gather(std::span<const CharacterState> states) {
    CrowdState& crowd = *state_;
    if (states.size() != crowd.members.size()) return false;
    const navigation::Frame& frame = crowd.mesh->state().plan.frame;
    const dvec3 feet = crowd.mesh->up() * crowd.mesh->agent().feet;
    crowd.states.assign(states.begin(), states.end());
    crowd.places.resize(states.size());
    crowd.seen.resize(states.size());
    for (std::size_t i = 0; i < states.size(); ++i) {
        const Member& member = *crowd.members[i];
        crowd.places[i] = frame.in(states[i].position - feet);
        const dvec3 velocity = frame.turned_in(states[i].velocity + states[i].ground_velocity);
        crowd.seen[i] = {.velocity = {static_cast<float>(velocity.x), 0, static_cast<float>(velocity.z)},
                         .wanted = member.wanted,
                         .goal = member.follower.goal().position,
                         .is_there = member.follower.status() == NavigationFollowStatus::arrived};
    }
    crowd.grid.fill(crowd.places, static_cast<float>(crowd.options.range));
    return true;
}

void NavigationCrowd::steer(NavigationCrowdWorker& worker, const CharacterSettings& settings, double dt,
                            std::span<CharacterInput> inputs, StepRange range) {
    CrowdState& crowd = *state_;
    if (crowd.states.size() != crowd.members.size() || inputs.size() != crowd.members.size()) return;
    const NavigationQuery& query = worker.query();
    const navigation::Frame& frame = query.state().frame();
    for (std::size_t i = range.begin; i < std::min(range.end, inputs.size()); ++i) {
        Member& member = *crowd.members[i];
        CharacterInput& input = inputs[i];
        input = member.follower.input(query, crowd.states[i], settings, dt);
        if (member.follower.status() == NavigationFollowStatus::following && !member.follower.on_link() &&
            crowd.options.avoidance != NavigationAvoidance::none) {
            const navigation::Neighbours near = navigation::neighbours_of(crowd, i);
            if (navigation::is_beside_goal(crowd, i, near)) {
                member.follower.arrive();
                input = {.up = input.up};
            } else if (near.count > 0) {
                const vec3 wish(frame.turned_in(input.wish));
                const vec3 result = navigation::bent(crowd, worker.state(), member, i, near, wish);
                input.wish = navigation::kept_on_mesh(query.state(), member, frame.turned_out(dvec3(result)));
            }
        }
        member.wanted = vec3(frame.turned_in(input.wish));
    }
}

}  // namespace v0
}  // namespace surefoot
