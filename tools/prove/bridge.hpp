/// Where kernel and judge meet: the judge's query asked of the library, and its answer in the judge's words. The judge
/// has types of its own on purpose; nothing is shared but numbers.
#pragma once

#include <optional>

#include <surefoot/sweep.hpp>

#include "judge/query.hpp"

namespace surefoot::tools {

[[nodiscard]] inline dvec3 position_from(const judge::Vec& v) {
    return {v.x, v.y, v.z};
}
[[nodiscard]] inline judge::Vec vec_from(const dvec3& v) {
    return {v.x, v.y, v.z};
}

[[nodiscard]] inline Shape shape_from(const judge::Query& query) {
    const judge::Vec& s = query.size;
    switch (query.kind) {
        case judge::Kind::sphere:
            return Sphere{s.x};
        case judge::Kind::ellipsoid:
            return Ellipsoid{{s.x, s.y, s.z}};
        case judge::Kind::capsule:
            return Capsule{s.x, s.y};
        case judge::Kind::box:
            return Box{{s.x, s.y, s.z}};
        case judge::Kind::cylinder:
            return Cylinder{s.x, s.y};
        case judge::Kind::cone:
            break;
    }
    return Cone{s.x, s.y};
}

[[nodiscard]] inline judge::Answer answer_from(const std::optional<Hit>& hit) {
    judge::Answer answer;
    if (!hit) return answer;
    answer.hit = true;
    answer.t = hit->t;
    answer.normal = vec_from(hit->normal);
    answer.point = vec_from(hit->point);
    answer.feature = static_cast<judge::Feature>(hit->feature);
    answer.status = static_cast<judge::Status>(hit->status);
    answer.started_inside = hit->started_inside;
    return answer;
}

static_assert(static_cast<int>(Feature::vertex) == static_cast<int>(judge::Feature::vertex) &&
              static_cast<int>(HitStatus::overflow) == static_cast<int>(judge::Status::overflow));

/// The sweep of the library.
[[nodiscard]] inline judge::Answer ask(const judge::Query& query) {
    const Volume volume(shape_from(query), dquat(query.qw, query.qx, query.qy, query.qz));
    return answer_from(sweep(volume, {position_from(query.from), position_from(query.to)},
                             {position_from(query.a), position_from(query.b), position_from(query.c)},
                             {.one_sided = query.one_sided}));
}

}  // namespace surefoot::tools
