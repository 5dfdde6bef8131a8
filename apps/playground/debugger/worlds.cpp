#include "debugger/worlds.hpp"

#include <algorithm>

namespace surefoot::debugger {

std::vector<Triangle> triangles_of(WorldKind world) {
    switch (world) {
        case WorldKind::triangle:
            return {{{0, 0, 0}, {0, 0, 10}, {10, 0, 10}}};
        case WorldKind::fold:
            return {{{0, 0, 0}, {-4, 3, 5}, {0, 0, 10}}, {{0, 0, 0}, {-4, 0, 0}, {-4, 3, 5}}};
        case WorldKind::wedge:
            return {{{0, 0, 0}, {0, 0, 10}, {10, 0, 10}}, {{10, 0, 10}, {0, 0, 10}, {5, 3, 8}}};
        case WorldKind::own:
        case WorldKind::level:
            break;
    }
    return {};
}

std::string title_of(WorldKind world) {
    switch (world) {
        case WorldKind::triangle:
            return "one triangle";
        case WorldKind::fold:
            return "a fold";
        case WorldKind::wedge:
            return "an acute wedge";
        case WorldKind::own:
            return "triangles of a pasted question";
        case WorldKind::level:
            break;
    }
    return "a level";
}

Question default_question(WorldKind world) {
    Question question;
    question.world = world;
    question.triangles = triangles_of(world);
    if (world == WorldKind::triangle) question.motion = {{7.5, 4, 4.5}, {4.5, -4, 5.5}};
    if (world == WorldKind::fold) question.motion = {{-0.8, 5.2, 1.4}, {-3.2, -2, 3.6}};
    if (world == WorldKind::wedge) {
        question.shape = ShapeName::sphere;
        question.motion = {{3, 1.2, 2}, {5.5, 1.2, 12}};
    }
    return question;
}

Question question_in_level(const std::string& file, const Bounds& bounds) {
    Question question;
    question.world = WorldKind::level;
    question.level = file;
    const dvec3 middle = (bounds.min + bounds.max) * 0.5;
    const dvec3 size = bounds.max - bounds.min;
    question.sizes.ellipsoid = {.radii = {0.4, 0.9, 0.4}};
    const double above = std::max(1.0, 0.1 * size.y) + question.sizes.ellipsoid.radii.y;
    question.motion = {{middle.x, bounds.max.y + above, middle.z},
                       {middle.x + 0.1 * size.x, bounds.min.y - above, middle.z + 0.1 * size.z}};
    return question;
}

}  // namespace surefoot::debugger
