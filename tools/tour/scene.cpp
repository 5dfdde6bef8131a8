#include "tour/scene.hpp"

#include <algorithm>
#include <glm/geometric.hpp>

namespace surefoot::tools {
namespace {

void add(std::vector<Figure>& figures, Figure figure) {
    std::visit(
        [&](const auto& solid) {
            figure.centre = solid.centre();
            figure.reach = solid.reach();
        },
        figure.solid);
    figures.push_back(figure);
}

dvec3 stop_of(const Leg& leg) {
    return leg.motion.from + (leg.hit ? leg.hit->t : 1.0) * (leg.motion.to - leg.motion.from);
}

SweptEllipsoid body(const Walker& walker, const dvec3& from, const dvec3& to) {
    return {
        .from = from, .to = to, .radii = walker.half_size, .orientation = glm::normalize(walker.volume.orientation)};
}

/// The volume that the body sweeps, a little slimmer than the body itself, so that the two do not flicker where they
/// meet.
SweptEllipsoid sweep_volume(const Walker& walker, const dvec3& from, const dvec3& to) {
    SweptEllipsoid volume = body(walker, from, to);
    volume.radii *= 0.99;
    return volume;
}

SweptEllipsoid rod(const dvec3& from, const dvec3& to, double radius) {
    return {.from = from, .to = to, .radii = dvec3(radius), .orientation = dquat(1, 0, 0, 0)};
}

/// A ball at the contact and an arrow along the normal; `size` is about that of the body.
void add_contact(std::vector<Figure>& figures, const Hit& hit, double size) {
    const Colour colour = colour_of(hit.feature) * 0.82;
    const dvec3 neck = hit.point + hit.normal * (0.85 * size);
    add(figures, {.solid = rod(hit.point, hit.point, 0.10 * size), .colour = colour, .marker = true});
    add(figures, {.solid = rod(hit.point, neck, 0.028 * size), .colour = colour, .marker = true});
    add(figures,
        {.solid = ArrowHead{neck, neck + hit.normal * (0.28 * size), 0.085 * size}, .colour = colour, .marker = true});
}

}  // namespace

Colour colour_of(Feature feature) {
    switch (feature) {
        case Feature::face:
            return {0.16, 0.47, 0.72};
        case Feature::edge:
            return {0.93, 0.58, 0.13};
        case Feature::vertex:
            break;
    }
    return {0.80, 0.20, 0.27};
}

std::vector<Figure> figures_of(const Route& route, const Walker& walker) {
    std::vector<Figure> figures;
    const double size = walker.half_size.y;
    const Colour sweep_colour(0.98, 0.97, 0.93);
    std::vector<dvec3> shown;
    for (const Leg& leg : route.legs) {
        const dvec3 stop = stop_of(leg);
        // The way of the reference point, and on the longer ways the volume that the body sweeps.
        add(figures, {.solid = rod(leg.motion.from, stop, 0.03 * size), .colour = sweep_colour, .marker = true});
        if (leg.step == Step::walk && glm::length(stop - leg.motion.from) > 0.2 * size)
            add(figures, {.solid = sweep_volume(walker, leg.motion.from, stop),
                          .colour = sweep_colour,
                          .alpha = 0.15,
                          .glass = true});
        if (!leg.hit) continue;
        add_contact(figures, *leg.hit, size);
        // Where a walk ends and the drop after it begins, two bodies would stand in one place: one is enough.
        const bool crowded = std::any_of(shown.begin(), shown.end(), [&](const dvec3& other) {
            return glm::length((other - stop) / walker.half_size) < 0.9;
        });
        if (crowded) continue;
        shown.push_back(stop);
        add(figures,
            {.solid = body(walker, stop, stop), .colour = colour_of(leg.hit->feature), .alpha = 0.86, .shadow = true});
    }
    return figures;
}

std::vector<Figure> figures_of(const Leg& leg, const Walker& walker) {
    std::vector<Figure> figures;
    const double size = walker.half_size.y;
    const dvec3 stop = stop_of(leg);
    const Colour sweep_colour(0.98, 0.97, 0.93);
    add(figures, {.solid = rod(leg.motion.from, stop, 0.02 * size), .colour = sweep_colour, .marker = true});
    add(figures,
        {.solid = sweep_volume(walker, leg.motion.from, stop), .colour = sweep_colour, .alpha = 0.22, .glass = true});
    add(figures, {.solid = body(walker, leg.motion.from, leg.motion.from),
                  .colour = sweep_colour,
                  .alpha = 0.35,
                  .glass = true});
    if (!leg.hit) return figures;
    add(figures,
        {.solid = body(walker, stop, stop), .colour = colour_of(leg.hit->feature), .alpha = 0.72, .shadow = true});
    add_contact(figures, *leg.hit, 0.6 * size);
    return figures;
}

}  // namespace surefoot::tools
