// Gathering a moment. A source shows the triangles that a question can meet through the filter, and is told that none
// of them exists: so no hit ends the search early, and all of the way is seen. The tree is walked one box at a time,
// without the float filter, so that a fault in what is fast does not hide the triangle that it passed over.
#include <algorithm>
#include <utility>

#include <surefoot/capture.hpp>

#include "ieee_guard.hpp"
#include "limits.hpp"
#include "query/moving_reach.hpp"
#include "query/reach.hpp"

namespace surefoot {
inline namespace v0 {

using namespace internal;

namespace {

/// Takes what comes as long as there is room, and counts the rest: nothing is allocated while a query runs.
template <typename T>
class Found {
public:
    void take(const T& one) const noexcept {
        if (count_ < list_.capacity()) list_.push_back(one);
        ++count_;
    }

    /// Calls `ask`, which takes, until all found room; then the list is in order, each once.
    template <typename Ask>
    std::vector<T> all(const Ask& ask) {
        for (ask(); count_ > list_.capacity(); ask()) {
            list_.reserve(std::exchange(count_, 0));
            list_.clear();
        }
        std::sort(list_.begin(), list_.end());
        list_.erase(std::unique(list_.begin(), list_.end()), list_.end());
        return std::move(list_);
    }

private:
    // A filter is handed around as a constant, but what it is asked is all that can be learned from it.
    mutable std::vector<T> list_;
    mutable std::size_t count_ = 0;
};

using BodyAndId = std::pair<std::uint32_t, std::uint32_t>;

template <typename T>
void add_if_missing(std::vector<T>& sorted, const T& one) {
    const auto place = std::lower_bound(sorted.begin(), sorted.end(), one);
    if (place == sorted.end() || *place != one) sorted.insert(place, one);
}

Capture with_origin(const CapturedQuestion& question) {
    Capture capture;
    capture.question = question;
    capture.origin = {.library = library_version(), .abi = abi_name};
    return capture;
}

std::optional<Hit> ask(const SourceView& source, const CapturedQuestion& question,
                       const QueryOptions& options) noexcept {
    return question.kind == CaptureKind::ray ? source.ray(question.motion, options)
                                             : source.sweep(question.volume, question.motion, options);
}

std::optional<Hit> ask(const World& world, const CapturedQuestion& question, const WorldQuery& query) noexcept {
    return question.kind == CaptureKind::ray ? world.ray(question.motion, query)
                                             : world.sweep(question.volume, question.motion, query);
}

/// Which triangles of a source the question comes by, asked in the source's own frame.
class ComesBy {
public:
    /// Requires: a question within the limits.
    ComesBy(const CapturedQuestion& question, const Bounds& bounds) noexcept
        : reach_(question.motion, extent(question, bounds)) {}

    [[nodiscard]] bool operator()(const Triangle& triangle) const noexcept {
        return !is_valid_triangle(triangle) || reach_.key(box_of(triangle)) != never;
    }

private:
    static Box3 extent(const CapturedQuestion& question, const Bounds& bounds) noexcept {
        const double magnitude =
            larger(magnitude_of(question.motion), magnitude_of(Box3{to_vec(bounds.min), to_vec(bounds.max)}));
        return question.kind == CaptureKind::ray ? extent_of_point(magnitude) : extent_of(question.volume, magnitude);
    }

    MovingReach reach_;
};

/// Adds the triangles with these ids; those beside the way only if `all`, or if they are the one that was hit.
/// Requires: no ids if the question is beyond the limits.
void add_triangles(Capture& capture, const SourceView& source, std::uint32_t body, std::span<const std::uint32_t> ids,
                   bool all) {
    if (ids.empty()) return;
    const IeeeGuard guard;
    const ComesBy comes_by(capture.question, source.bounds());
    for (const std::uint32_t id : ids) {
        const Triangle triangle = source.triangle(id);
        const bool was_hit = capture.answer && capture.answer->body == body && capture.answer->triangle == id;
        if (!all && !was_hit && !comes_by(triangle)) continue;
        capture.triangles.push_back({.triangle = triangle, .id = id, .surface = source.surface(id), .body = body});
    }
}

bool stands_at_origin(const BodyPose& poses) noexcept {
    const auto is_origin = [](const Pose& pose) {
        const dquat& q = pose.orientation;
        return pose.position == dvec3(0, 0, 0) && q.x == 0 && q.y == 0 && q.z == 0;
    };
    return is_origin(poses.start) && is_origin(poses.end);
}

Capture captured(const SourceView& source, const CapturedQuestion& question, const QueryOptions& options) {
    Capture capture = with_origin(question);
    capture.answer = ask(source, question, options);
    Found<std::uint32_t> found;
    const auto look = [&](std::uint32_t id, std::uint32_t surface) {
        if (options.filter(id, surface)) found.take(id);
        return false;
    };
    const QueryOptions looking{.one_sided = options.one_sided, .search = Search::scalar_tree, .filter = look};
    std::vector<std::uint32_t> ids = found.all([&] { static_cast<void>(ask(source, question, looking)); });
    if (capture.answer && capture.answer->status == HitStatus::ok) add_if_missing(ids, capture.answer->triangle);
    add_triangles(capture, source, 0, ids, false);
    return capture;
}

Capture captured(const World& world, const CapturedQuestion& question, const WorldQuery& query) {
    Capture capture = with_origin(question);
    capture.answer = ask(world, question, query);
    Found<BodyAndId> found;
    Found<std::uint32_t> found_bodies;
    const auto look_at_body = [&](std::uint32_t body) {
        const bool exists = query.bodies(body);
        if (exists) found_bodies.take(body);
        return exists;
    };
    const auto look = [&](std::uint32_t body, std::uint32_t id, std::uint32_t surface) {
        if (query.triangles(body, id, surface)) found.take({body, id});
        return false;
    };
    WorldQuery looking = query;
    looking.search = Search::scalar_tree;
    looking.trace = nullptr;
    looking.work = nullptr;
    looking.bodies = look_at_body;
    looking.triangles = look;
    const auto look_again = [&] { static_cast<void>(ask(world, question, looking)); };
    std::vector<std::uint32_t> bodies = found_bodies.all(look_again);
    std::vector<BodyAndId> triangles = found.all(look_again);
    if (capture.answer && capture.answer->status == HitStatus::ok) {
        add_if_missing(bodies, capture.answer->body);
        add_if_missing(triangles, {capture.answer->body, capture.answer->triangle});
    }
    for (const std::uint32_t number : bodies) {
        const BodyHandle handle = world.find(number);
        const std::optional<SourceView> source = world.source(handle);
        if (!source) continue;
        const BodyPose poses = world.poses(handle);
        capture.bodies.push_back({.body = number, .start = poses.start, .end = poses.end, .bounds = source->bounds()});
        std::vector<std::uint32_t> ids;
        const auto first = std::lower_bound(triangles.begin(), triangles.end(), BodyAndId{number, 0});
        for (auto at = first; at != triangles.end() && at->first == number; ++at) ids.push_back(at->second);
        add_triangles(capture, *source, number, ids, !stands_at_origin(poses));
    }
    return capture;
}

CapturedQuestion question_of(CaptureKind kind, const Volume& volume, const Motion& motion,
                             const QueryOptions& options) noexcept {
    return {.kind = kind, .volume = volume, .motion = motion, .one_sided = options.one_sided};
}

CapturedQuestion question_of(CaptureKind kind, const Volume& volume, const Motion& motion,
                             const WorldQuery& query) noexcept {
    return {.kind = kind,
            .volume = volume,
            .motion = motion,
            .one_sided = query.one_sided,
            .begin = query.begin,
            .end = query.end,
            .turn_gap = query.turn_gap};
}

}  // namespace

Capture capture_sweep(const SourceView& source, const Volume& volume, const Motion& motion,
                      const QueryOptions& options) {
    return captured(source, question_of(CaptureKind::sweep, volume, motion, options), options);
}

Capture capture_sweep(const World& world, const Volume& volume, const Motion& motion, const WorldQuery& query) {
    return captured(world, question_of(CaptureKind::sweep, volume, motion, query), query);
}

Capture capture_sweep(const Triangle& triangle, const Volume& volume, const Motion& motion,
                      const SweepOptions& options) {
    Capture capture =
        with_origin({.kind = CaptureKind::sweep, .volume = volume, .motion = motion, .one_sided = options.one_sided});
    capture.triangles.push_back({.triangle = triangle});
    capture.answer = sweep(volume, motion, triangle, options);
    return capture;
}

Capture capture_ray(const SourceView& source, const Motion& motion, const QueryOptions& options) {
    return captured(source, question_of(CaptureKind::ray, {}, motion, options), options);
}

Capture capture_ray(const World& world, const Motion& motion, const WorldQuery& query) {
    return captured(world, question_of(CaptureKind::ray, {}, motion, query), query);
}

}  // namespace v0
}  // namespace surefoot
