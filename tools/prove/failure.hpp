/// A query that the judge refused, as a moment that `surefoot replay` reads.
#pragma once

#include <fmt/format.h>

#include <surefoot/capture.hpp>

#include "bridge.hpp"
#include "judge/judge.hpp"
#include "judge/runner.hpp"

namespace surefoot::tools {

[[nodiscard]] inline std::optional<Hit> hit_from(const judge::Answer& answer) {
    if (!answer.hit) return std::nullopt;
    return Hit{.t = answer.t,
               .point = position_from(answer.point),
               .normal = position_from(answer.normal),
               .feature = static_cast<Feature>(answer.feature),
               .status = static_cast<HitStatus>(answer.status),
               .started_inside = answer.started_inside};
}

/// The answer in it is the one that was judged.
[[nodiscard]] inline Capture capture_from(const judge::Record& record) {
    const judge::Query& q = record.query;
    Capture capture = capture_sweep(Triangle{position_from(q.a), position_from(q.b), position_from(q.c)},
                                    Volume(shape_from(q), dquat(q.qw, q.qx, q.qy, q.qz)),
                                    {position_from(q.from), position_from(q.to)}, {.one_sided = q.one_sided});
    capture.answer = hit_from(record.answer);
    capture.note = fmt::format("{}: {} (family {})", judge::name_of(record.judgement.verdict), record.judgement.why,
                               record.family.name);
    return capture;
}

}  // namespace surefoot::tools
