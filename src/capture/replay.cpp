#include <bit>

#include <surefoot/capture.hpp>
#include <surefoot/visited_source.hpp>

#include "capture/captured_world.hpp"
#include "query/answers.hpp"
#include "sweep/sweep.hpp"

namespace surefoot {
inline namespace v0 {

using namespace internal;

namespace {

std::optional<Hit> ask_triangles(const Capture& capture, Trace* trace) noexcept {
    const CapturedTriangles triangles(capture.triangles, {});
    const VisitedSource source(triangles);
    const CapturedQuestion& q = capture.question;
    const QueryOptions options{.one_sided = q.one_sided, .search = Search::brute_force, .trace = trace};
    return q.kind == CaptureKind::ray ? source.ray(q.motion, options) : source.sweep(q.volume, q.motion, options);
}

std::optional<Hit> ask_world(const Capture& capture, Trace* trace) {
    const CapturedWorld captured(capture.triangles, capture.bodies);
    if (!captured.is_whole()) return blocked(HitStatus::invalid);
    const World& world = captured.get();
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
