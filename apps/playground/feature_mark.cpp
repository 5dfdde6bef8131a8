#include "playground/feature_mark.hpp"

#include <algorithm>
#include <glm/geometric.hpp>

namespace surefoot::playground {
namespace {

double away(const dvec3& from, const dvec3& to, const dvec3& point) {
    const dvec3 along = to - from;
    const double square = glm::dot(along, along);
    const double share = square > 0 ? std::clamp(glm::dot(point - from, along) / square, 0.0, 1.0) : 0;
    return glm::length(from + along * share - point);
}

}  // namespace

void draw_feature(view::Renderer& renderer, const Triangle& t, const Hit& hit) {
    const dvec3 corners[3] = {t.a, t.b, t.c};
    if (hit.feature == Feature::face) {
        renderer.triangle(t.a, t.b, t.c, view::with_opacity(view::paint::face, 0.45));
        renderer.polyline(corners, {.colour = view::paint::face, .width = 2}, true);
        return;
    }
    renderer.polyline(corners, {.colour = view::with_opacity(view::paint::edge, 0.5), .width = 1.5}, true);
    int nearest = 0;
    for (int i = 1; i < 3; ++i) {
        const bool nearer = hit.feature == Feature::edge
                                ? away(corners[i], corners[(i + 1) % 3], hit.point) <
                                      away(corners[nearest], corners[(nearest + 1) % 3], hit.point)
                                : glm::length(corners[i] - hit.point) < glm::length(corners[nearest] - hit.point);
        if (nearer) nearest = i;
    }
    if (hit.feature == Feature::edge) {
        renderer.line(corners[nearest], corners[(nearest + 1) % 3],
                      {.colour = view::paint::edge, .width = 4, .behind = 0.5});
    } else {
        renderer.point(corners[nearest], 13, view::paint::vertex, 0.6);
    }
}

}  // namespace surefoot::playground
