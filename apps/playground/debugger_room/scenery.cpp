#include "playground/debugger_room/scenery.hpp"

namespace surefoot::playground {

void Scenery::quad(const Profile& profile, const dvec3& a, const dvec3& b, const dvec3& c, const dvec3& d,
                   view::Colour colour) {
    const auto first = static_cast<std::uint32_t>(vertices_.size());
    for (const dvec3& corner : {a, b, c, d})
        vertices_.push_back(vec3((profile.turned ? half_turned(corner) : corner) + profile.offset));
    for (const std::uint32_t corner : {0U, 1U, 2U, 0U, 2U, 3U}) indices_.push_back(first + corner);
    colours_.insert(colours_.end(), 2, colour);
}

void Scenery::add(const Profile& profile) {
    const dvec3 near(0, 0, profile.half);
    const auto at_base = [&](const dvec3& p) { return dvec3(p.x, profile.base, 0); };
    const auto flat = [](const dvec3& p) { return dvec3(p.x, p.y, 0); };
    for (std::size_t i = 0; i + 1 < profile.top.size(); ++i) {
        const dvec3 a = flat(profile.top[i]);
        const dvec3 b = flat(profile.top[i + 1]);
        quad(profile, a + near, b + near, b - near, a - near, profile.colour);
        if (a.x == b.x) continue;
        quad(profile, at_base(a) + near, at_base(b) + near, b + near, a + near, profile.side);
        quad(profile, at_base(b) - near, at_base(a) - near, a - near, b - near, profile.side);
    }
    const dvec3 first = flat(profile.top.front());
    const dvec3 last = flat(profile.top.back());
    quad(profile, at_base(first) - near, at_base(first) + near, first + near, first - near, profile.side);
    quad(profile, at_base(last) + near, at_base(last) - near, last - near, last + near, profile.side);
}

std::shared_ptr<const view::Model> Scenery::model() const {
    const auto mesh = Mesh::build({.vertices = vertices_, .indices = indices_});
    if (!mesh) return nullptr;
    return view::Model::make(*mesh, [this](const SourceTriangle& t) { return colours_[t.id]; });
}

}  // namespace surefoot::playground
