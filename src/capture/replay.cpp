#include <algorithm>
#include <bit>
#include <cmath>
#include <span>

#include <surefoot/capture.hpp>
#include <surefoot/visited_source.hpp>

#include "query/answers.hpp"
#include "sweep/sweep.hpp"

namespace surefoot {
inline namespace v0 {

using namespace internal;

namespace {

/// The captured triangles of one body. Every question goes to all of them, so none can be passed over.
class CapturedTriangles {
public:
    CapturedTriangles(std::span<const CapturedTriangle> triangles, const Bounds& bounds) noexcept
        : triangles_(triangles), bounds_(bounds) {}

    [[nodiscard]] Bounds bounds() const noexcept { return bounds_; }
    void visit(const Bounds&, const TriangleSink& sink) const noexcept {
        for (const CapturedTriangle& one : triangles_) sink(one.triangle, one.id, one.surface);
    }
    [[nodiscard]] Triangle triangle(std::uint32_t id) const noexcept {
        const CapturedTriangle* const one = find(id);
        return one != nullptr ? one->triangle : Triangle{};
    }
    [[nodiscard]] std::uint32_t surface(std::uint32_t id) const noexcept {
        const CapturedTriangle* const one = find(id);
        return one != nullptr ? one->surface : 0;
    }

private:
    [[nodiscard]] const CapturedTriangle* find(std::uint32_t id) const noexcept {
        const auto place = std::lower_bound(triangles_.begin(), triangles_.end(), id,
                                            [](const CapturedTriangle& a, std::uint32_t b) { return a.id < b; });
        return place != triangles_.end() && place->id == id ? &*place : nullptr;
    }

    std::span<const CapturedTriangle> triangles_;
    Bounds bounds_;
};

bool is_box(const Bounds& bounds) noexcept {
    const auto in_order = [](double low, double high) {
        return std::isfinite(low) && std::isfinite(high) && low <= high;
    };
    return in_order(bounds.min.x, bounds.max.x) && in_order(bounds.min.y, bounds.max.y) &&
           in_order(bounds.min.z, bounds.max.z);
}

std::optional<Hit> ask_triangles(const Capture& capture, Trace* trace) noexcept {
    const CapturedTriangles triangles(capture.triangles, {});
    const VisitedSource source(triangles);
    const CapturedQuestion& q = capture.question;
    const QueryOptions options{.one_sided = q.one_sided, .search = Search::brute_force, .trace = trace};
    return q.kind == CaptureKind::ray ? source.ray(q.motion, options) : source.sweep(q.volume, q.motion, options);
}

std::optional<Hit> ask_world(const Capture& capture, Trace* trace) {
    std::vector<CapturedTriangles> triangles;
    std::vector<VisitedSource> sources;
    triangles.reserve(capture.bodies.size());
    sources.reserve(capture.bodies.size());  // the world refers to them
    World world;
    for (const CapturedBody& body : capture.bodies) {
        const auto [begin, end] =
            std::equal_range(capture.triangles.begin(), capture.triangles.end(), CapturedTriangle{.body = body.body},
                             [](const CapturedTriangle& a, const CapturedTriangle& b) { return a.body < b.body; });
        sources.emplace_back(triangles.emplace_back(std::span(begin, end), body.bounds));
        if (body.body == lowest_free_body || !is_box(body.bounds)) return blocked(HitStatus::invalid);
        const auto handle = world.add(sources.back(), {.pose = body.start, .body = body.body});
        if (!handle || !world.move(*handle, body.start, body.end)) return blocked(HitStatus::invalid);
    }
    const CapturedQuestion& q = capture.question;
    const WorldQuery query{.one_sided = q.one_sided,
                           .search = Search::brute_force,
                           .trace = trace,
                           .begin = q.begin,
                           .end = q.end,
                           .turn_gap = q.turn_gap};
    return q.kind == CaptureKind::ray ? world.ray(q.motion, query) : world.sweep(q.volume, q.motion, query);
}

bool differ(double a, double b) noexcept {
    return std::bit_cast<std::uint64_t>(a) != std::bit_cast<std::uint64_t>(b);
}
bool differ(const dvec3& a, const dvec3& b) noexcept {
    return differ(a.x, b.x) || differ(a.y, b.y) || differ(a.z, b.z);
}

}  // namespace

AnswerDifference difference_of(const std::optional<Hit>& a, const std::optional<Hit>& b) noexcept {
    if (a.has_value() != b.has_value()) return {.hit = true};
    if (!a) return {};
    return {.t = differ(a->t, b->t),
            .point = differ(a->point, b->point),
            .normal = differ(a->normal, b->normal),
            .feature = a->feature != b->feature,
            .triangle = a->triangle != b->triangle,
            .surface = a->surface != b->surface,
            .body = a->body != b->body,
            .status = a->status != b->status,
            .started_inside = a->started_inside != b->started_inside};
}

Replay replay(const Capture& capture, Trace* trace) {
    const CapturedQuestion& q = capture.question;
    Replay again;
    const bool is_valid_time = q.begin >= 0 && q.begin <= q.end && q.end <= 1;
    if (!is_valid_time) {
        again.answer = blocked(HitStatus::invalid);  // as a world says, whatever is in it
    } else {
        again.answer = capture.bodies.empty() ? ask_triangles(capture, trace) : ask_world(capture, trace);
    }
    again.differs = difference_of(capture.answer, again.answer);
    return again;
}

}  // namespace v0
}  // namespace surefoot
