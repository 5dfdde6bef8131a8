#include "debugger/strategies.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "debugger/equation.hpp"

namespace surefoot::debugger {

namespace {

double length_of(const Motion& motion) {
    return glm::length(motion.to - motion.from);
}

/// How late a strategy is that has found a touch at this distance from START, or none.
void compare(Finding& finding, double at, const std::optional<Hit>& truth, double length) {
    if (!truth) return;
    finding.missed = !finding.hit;
    if (finding.hit) finding.late = at - truth->t * length;
}

std::string words_for(const Finding& finding, const char* where) {
    if (finding.missed) return fmt::format("No hit {}: it has tunnelled.", where);
    if (!finding.hit) return fmt::format("No hit {}, and there is none.", where);
    if (!finding.late) return fmt::format("In touch {}, though the motion goes no deeper anywhere.", where);
    return fmt::format("In touch {}, {} m late.", where, short_text(*finding.late));
}

}  // namespace

Finding look_at_end(const Arena& arena, const Volume& volume, const Motion& motion, bool one_sided) {
    Finding finding{.position = motion.to, .looks = 1};
    finding.hit = arena.touches(volume, motion.to, one_sided);
    compare(finding, length_of(motion), arena.sweep(volume, motion, one_sided), length_of(motion));
    finding.text = words_for(finding, "at END");
    return finding;
}

Finding look_at_samples(const Arena& arena, const Volume& volume, const Motion& motion, double step, bool one_sided) {
    Finding finding{.position = motion.to};
    const double length = length_of(motion);
    const dvec3 direction = length > 0 ? (motion.to - motion.from) / length : dvec3(0, 0, 0);
    double at = 0;
    while (!finding.hit && finding.looks < most_looks && (at < length || finding.looks == 0)) {
        ++finding.looks;
        at = std::min(length, static_cast<double>(finding.looks) * step);
        const dvec3 position = at < length ? motion.from + direction * at : motion.to;
        finding.hit = arena.touches(volume, position, one_sided);
        if (finding.hit) finding.position = position;
    }
    compare(finding, at, arena.sweep(volume, motion, one_sided), length);
    if (!finding.hit && at < length) {
        finding.missed = false;
        finding.text = fmt::format("Gave up after {} samples: the step is too small for this motion.", finding.looks);
        return finding;
    }
    finding.text = words_for(finding, finding.hit ? "at a sample" : "at any sample");
    return finding;
}

Finding solve(const Arena& arena, const Volume& volume, const Motion& motion, bool one_sided) {
    Finding finding{.position = motion.to, .looks = 1};
    const auto hit = arena.sweep(volume, motion, one_sided);
    finding.hit = hit.has_value();
    if (hit) {
        finding.position = motion.from + (motion.to - motion.from) * hit->t;
        finding.late = 0;
    }
    finding.text =
        hit ? fmt::format("Touches at t = {}, after {} m.", short_text(hit->t), short_text(hit->t * length_of(motion)))
            : "The whole way is free.";
    return finding;
}

}  // namespace surefoot::debugger
