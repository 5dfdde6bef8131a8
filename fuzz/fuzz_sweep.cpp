// Any bytes, as the doubles of a sweep, a ray, an overlap and a march against one triangle, and of a pair of shapes.
#include <array>

#include "bytes.hpp"

namespace {

using namespace fuzz;

bool equal(const surefoot::Hit& a, const surefoot::Hit& b) {
    return a.t == b.t && a.point == b.point && a.normal == b.normal && a.feature == b.feature && a.status == b.status;
}

void check_sweep(const surefoot::Volume& volume, const surefoot::Motion& motion, const surefoot::Triangle& triangle,
                 bool one_sided) {
    const auto capture = [&] {
        return surefoot::capture_sweep(triangle, volume, motion, surefoot::SweepOptions{.one_sided = one_sided});
    };
    const auto bare = [&] { return unasked(triangle, {.volume = volume, .motion = motion, .one_sided = one_sided}); };
    const Asking asking(capture, bare);
    const bool valid = surefoot::is_valid(volume) && is_within_limits(motion) && is_within_limits(triangle);
    const auto hit = surefoot::sweep(volume, motion, triangle, {.one_sided = one_sided});
    require(hit || valid, "data outside the limits are no free pass");
    if (hit) require_sound(*hit, valid);

    std::array<surefoot::TraceRecord, 64> room;
    surefoot::Trace trace(room);
    const auto traced = surefoot::sweep(volume, motion, triangle, {.one_sided = one_sided}, &trace);
    require(hit.has_value() == traced.has_value() && (!hit || equal(*hit, *traced)), "a trace changes no answer");

    const auto turned = surefoot::sweep(volume, motion, {triangle.b, triangle.c, triangle.a}, {.one_sided = one_sided});
    require(hit.has_value() == turned.has_value() && (!hit || hit->t == turned->t),
            "the order of the vertices changes no time");
}

void check_ray(const surefoot::Motion& motion, const surefoot::Triangle& triangle, bool one_sided) {
    const surefoot::CapturedQuestion question{
        .kind = surefoot::CaptureKind::ray, .motion = motion, .one_sided = one_sided};
    const auto capture = [&] {
        surefoot::Capture moment = unasked(triangle, question);
        moment.answer = surefoot::ray(motion, triangle, {.one_sided = one_sided});
        return moment;
    };
    const auto bare = [&] { return unasked(triangle, question); };
    const Asking asking(capture, bare);
    const bool valid = is_within_limits(motion) && is_within_limits(triangle);
    const auto hit = surefoot::ray(motion, triangle, {.one_sided = one_sided});
    require(hit || valid, "data outside the limits are no free pass");
    if (!hit) return;
    // A ray that stands still has no direction for its normal to face.
    if (motion.from != motion.to || !valid) require_sound(*hit, valid);
}

void check_overlap(const surefoot::Volume& volume, const surefoot::dvec3& position, const surefoot::Triangle& triangle,
                   bool one_sided) {
    const bool valid = surefoot::is_valid(volume) && is_within_limits(position) && is_within_limits(triangle);
    const auto found = surefoot::overlap(volume, position, triangle, {.one_sided = one_sided});
    require(found || valid, "data outside the limits are no free pass");
    if (!found) return;
    require(is_finite(found->point) && is_finite(found->normal) && std::isfinite(found->depth),
            "no NaN and no infinity in an answer");
    require(found->depth >= 0, "a depth is not negative");
    require((found->status == surefoot::HitStatus::ok) == valid, "the status tells whether the data were valid");
    if (valid) require(is_about_unit(found->normal), "a normal has unit length");
}

void check_march(const surefoot::Volume& volume, const surefoot::Motion& motion, const surefoot::Triangle& triangle,
                 bool guarded) {
    const surefoot::JumpArc arc{.from = motion.from, .velocity = motion.to};
    const auto met = surefoot::march(volume, arc, triangle, {.steps = 8, .guarded = guarded});
    if (!met) return;
    require(met->hit.t >= 0 && met->hit.t <= 1, "t is within [0, 1]");
    require(is_finite(met->hit.normal) && is_finite(met->hit.point), "no NaN and no infinity in an answer");
    require(is_finite(met->position) || met->hit.status == surefoot::HitStatus::invalid, "a position is a number");
}

void check_pair(const surefoot::Volume& a, const surefoot::Motion& motion_a, const surefoot::Volume& b,
                const surefoot::Motion& motion_b) {
    const bool valid =
        surefoot::is_valid(a) && surefoot::is_valid(b) && is_within_limits(motion_a) && is_within_limits(motion_b);
    const auto hit = surefoot::pair_sweep(a, motion_a, b, motion_b);
    require(hit || valid, "data outside the limits are no free pass");
    if (hit) {
        require(hit->t >= 0 && hit->t <= 1, "t is within [0, 1]");
        require(is_finite(hit->point) && is_finite(hit->normal), "no NaN and no infinity in an answer");
        require((hit->status != surefoot::HitStatus::invalid) == valid, "the status tells whether the data were valid");
        require(hit->status != surefoot::HitStatus::ok || is_about_unit(hit->normal), "a normal has unit length");
    }
    const auto found = surefoot::pair_overlap(a, motion_a.from, b, motion_b.from);
    if (!found) return;
    require(is_finite(found->point) && is_finite(found->normal) && std::isfinite(found->depth) && found->depth >= 0,
            "no NaN and no infinity in an answer");
    const auto swapped = surefoot::pair_overlap(b, motion_b.from, a, motion_a.from);
    require(swapped && swapped->depth == found->depth, "swapping the two gives the same depth");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    Bytes bytes({data, size});
    const auto kind = bytes.take<std::uint8_t>();
    const bool raw = (kind & 1) != 0;
    const surefoot::Volume volume = bytes.volume(raw);
    const surefoot::Motion motion{bytes.vector(raw), bytes.vector(raw)};
    const surefoot::Triangle triangle{bytes.vector(raw), bytes.vector(raw), bytes.vector(raw)};
    const bool one_sided = (kind & 2) != 0;
    check_sweep(volume, motion, triangle, one_sided);
    check_ray(motion, triangle, one_sided);
    check_overlap(volume, motion.from, triangle, one_sided);
    check_march(volume, motion, triangle, one_sided);
    check_pair(volume, motion, bytes.volume(raw), {triangle.a, triangle.b});
    return 0;
}
