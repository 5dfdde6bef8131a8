#include <algorithm>
#include <cassert>
#include <string>
#include <utility>

#include "ieee_guard.hpp"
#include "world/state.hpp"

namespace surefoot {
inline namespace v0 {

using namespace internal;

std::size_t World::State::place_of(std::uint32_t id) const noexcept {
    const auto place = std::lower_bound(by_id.begin(), by_id.end(), id,
                                        [](const WorldBody* body, std::uint32_t number) { return body->id < number; });
    return static_cast<std::size_t>(place - by_id.begin());
}

WorldBody* World::State::with_id(std::uint32_t id) const noexcept {
    const std::size_t place = place_of(id);
    return place < by_id.size() && by_id[place]->id == id ? by_id[place] : nullptr;
}

std::uint32_t World::State::free_id() const noexcept {
    // As long as none is missing, each body stands at its own number: halve to the first that does not.
    std::size_t low = 0;
    std::size_t high = by_id.size();
    while (low < high) {
        const std::size_t middle = (low + high) / 2;
        if (by_id[middle]->id == middle) {
            low = middle + 1;
        } else {
            high = middle;
        }
    }
    return static_cast<std::uint32_t>(low);
}

void World::State::place(WorldBody& body, const Pose& start, const Pose& end) noexcept {
    body.place(start, end);
    tree.move(body.leaf, body.box());
}

template <typename Source>
Expected<BodyHandle> World::State::add(const Source& source, Placement placement) {
    const IeeeGuard guard;
    const auto fail = [](ErrorCode code, std::string text) {
        return tl::unexpected(Error{code, std::move(text), {}, 0});
    };
    if (placement.body == lowest_free_body) placement.body = free_id();
    const std::string name = "body " + std::to_string(placement.body);
    if (!is_valid(placement.pose)) {
        return fail(ErrorCode::invalid, name +
                                            " has a pose that is not finite, lies beyond 1e9 m or has a quaternion "
                                            "of zero: repair it before the body is added");
    }
    if (with_id(placement.body) != nullptr) {
        return fail(ErrorCode::invalid, "there is a " + name +
                                            " in this world already: give each body a number of "
                                            "its own, or none and take the lowest that is free");
    }
    if (!bodies.reserve(bodies.size() < 16 ? 16 : bodies.size() + 1)) {
        return fail(ErrorCode::out_of_memory, "there is no memory for " + name + ": remove bodies that are not needed");
    }
    const BodyHandle handle = bodies.insert(source, placement);
    if (!handle) {
        return fail(ErrorCode::out_of_memory, "there is no room for " + name + ": remove bodies that are not needed");
    }
    WorldBody& body = bodies[handle];
    body.handle = handle;
    body.place(placement.pose, placement.pose);
    body.measure();
    body.leaf = tree.insert(body.box(), &body);
    by_id.insert(by_id.begin() + static_cast<std::ptrdiff_t>(place_of(body.id)), &body);
    return handle;
}

World::World() : state_(new State) {}

World::World(World&& other) noexcept : state_(std::exchange(other.state_, nullptr)) {}

World& World::operator=(World&& other) noexcept {
    if (this != &other) {
        delete state_;
        state_ = std::exchange(other.state_, nullptr);
    }
    return *this;
}

World::~World() {
    delete state_;
}

Expected<BodyHandle> World::add(const Mesh& mesh, const Placement& placement) {
    return state_->add(mesh, placement);
}

Expected<BodyHandle> World::add(const SourceView& source, const Placement& placement) {
    return state_->add(source, placement);
}

bool World::remove(BodyHandle handle) noexcept {
    const WorldBody* const body = state_->bodies.get(handle);
    assert(body != nullptr && "World::remove: this body is dead or was never in this world; ask contains() first");
    if (body == nullptr) return false;
    state_->tree.remove(body->leaf);
    state_->by_id.erase(state_->by_id.begin() + static_cast<std::ptrdiff_t>(state_->place_of(body->id)));
    return state_->bodies.erase(handle);
}

void World::begin_tick() noexcept {
    const IeeeGuard guard;
    for (WorldBody* body : state_->by_id) {
        if (body->moves()) {
            state_->place(*body, body->end, body->end);
        } else {
            body->start = body->end;  // the same place, but perhaps in other words
        }
    }
}

bool World::move(BodyHandle handle, const Pose& end) noexcept {
    const WorldBody* const body = state_->bodies.get(handle);
    assert(body != nullptr && "World::move: this body is dead or was never in this world; ask contains() first");
    return body != nullptr && move(handle, body->start, end);
}

bool World::move(BodyHandle handle, const Pose& start, const Pose& end) noexcept {
    const IeeeGuard guard;
    WorldBody* const body = state_->bodies.get(handle);
    assert(body != nullptr && "World::move: this body is dead or was never in this world; ask contains() first");
    if (body == nullptr || !is_valid(start) || !is_valid(end)) return false;
    state_->place(*body, start, end);
    return true;
}

bool World::set_layers(BodyHandle handle, std::uint64_t layers) noexcept {
    WorldBody* const body = state_->bodies.get(handle);
    assert(body != nullptr && "World::set_layers: this body is dead or was never in this world; ask contains() first");
    if (body == nullptr) return false;
    body->layers = layers;
    return true;
}

bool World::refit(BodyHandle handle) noexcept {
    const IeeeGuard guard;
    WorldBody* const body = state_->bodies.get(handle);
    assert(body != nullptr && "World::refit: this body is dead or was never in this world; ask contains() first");
    if (body == nullptr) return false;
    body->measure();
    state_->tree.move(body->leaf, body->box());
    return true;
}

BodyHandle World::find(std::uint32_t body) const noexcept {
    const WorldBody* const found = state_->with_id(body);
    return found != nullptr ? found->handle : BodyHandle{};
}

bool World::contains(BodyHandle handle) const noexcept {
    return state_->bodies.contains(handle);
}

std::size_t World::body_count() const noexcept {
    return state_->by_id.size();
}

std::optional<SourceView> World::source(BodyHandle handle) const noexcept {
    const WorldBody* const body = state_->bodies.get(handle);
    assert(body != nullptr && "World::source: this body is dead or was never in this world; ask contains() first");
    return body != nullptr ? std::optional(body->source) : std::nullopt;
}

BodyPose World::poses(BodyHandle handle) const noexcept {
    const WorldBody* const body = state_->bodies.get(handle);
    assert(body != nullptr && "World::poses: this body is dead or was never in this world; ask contains() first");
    return body != nullptr ? BodyPose{.body = body->id, .start = body->start, .end = body->end} : BodyPose{};
}

dvec3 World::carried(BodyHandle handle, const dvec3& place, double begin, double end) const noexcept {
    const IeeeGuard guard;
    const WorldBody* const body = state_->bodies.get(handle);
    assert(body != nullptr && "World::carried: this body is dead or was never in this world; ask contains() first");
    if (body == nullptr || !body->moves()) return place;
    const Vec here = to_vec(place);
    if (!body->turns()) return to_dvec3(here + (body->position_at(end) - body->position_at(begin)));
    return to_dvec3(body->stance_at(end).to_world(body->stance_at(begin).to_body(here).point));
}

dvec3 World::velocity_at(BodyHandle handle, const dvec3& place, double seconds) const noexcept {
    if (!(seconds > 0)) return dvec3(0, 0, 0);
    const dvec3 there = carried(handle, place);
    const IeeeGuard guard;
    return to_dvec3((to_vec(there) - to_vec(place)) / seconds);
}

std::optional<Triangle> World::triangle(std::uint32_t body, std::uint32_t triangle, double at) const noexcept {
    const IeeeGuard guard;
    const WorldBody* const found = state_->with_id(body);
    if (found == nullptr) return std::nullopt;
    const Stance stance = found->stance_at(at);
    const Triangle own = found->source.triangle(triangle);
    const auto placed = [&](const dvec3& corner) { return to_dvec3(stance.to_world(to_vec(corner))); };
    return Triangle{placed(own.a), placed(own.b), placed(own.c)};
}

std::size_t World::save_poses(std::span<BodyPose> room, std::uint64_t layers) const noexcept {
    std::size_t count = 0;
    for (const WorldBody* body : state_->by_id) {
        if ((body->layers & layers) == 0) continue;
        if (count < room.size()) room[count] = {.body = body->id, .start = body->start, .end = body->end};
        ++count;
    }
    return count;
}

bool World::restore_poses(std::span<const BodyPose> saved) noexcept {
    const IeeeGuard guard;
    for (const BodyPose& pose : saved) {
        const bool fits = state_->with_id(pose.body) != nullptr && is_valid(pose.start) && is_valid(pose.end);
        assert(fits &&
               "World::restore_poses: a body of the snapshot is not in this world, or its pose is not finite; "
               "add and remove the same bodies before you restore");
        if (!fits) return false;
    }
    for (const BodyPose& pose : saved) state_->place(*state_->with_id(pose.body), pose.start, pose.end);
    return true;
}

}  // namespace v0
}  // namespace surefoot
