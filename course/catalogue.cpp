#include "course/catalogue.hpp"

#include "course/catches.hpp"

namespace surefoot::course {
namespace {

// The body is put as far from what it rests on as the capsule was.
void give(Run& run, BodyShape shape) {
    const double before = reach(run.settings, -run.rests_on);
    run.settings.volume = volume_as(shape, capsule_of(run.settings));
    run.start.y += (reach(run.settings, -run.rests_on) - before) / run.rests_on.y;
    run.start.y += gap_below(run.settings) - run.settings.skin;
}

struct Exception {
    std::string_view scene;
    BodyShape shape;
    std::string_view reason;
};

// Where geometry leaves nothing to ask of a shape.
constexpr Exception exceptions[] = {
    {"lintel", BodyShape::sphere,
     "the lintel leaves 1.3 m and more above its step, and the ball is 0.8 m high: it goes under"},
};

std::string why_not(std::string_view scene, BodyShape shape) {
    for (const Exception& exception : exceptions) {
        if (exception.scene == scene && exception.shape == shape) return std::string(exception.reason);
    }
    return {};
}

}  // namespace

Scenes all_scenes(BodyShape shape) {
    Scenes scenes;
    for (const auto add :
         {add_floors, add_walls, add_stairs, add_slopes, add_tight, add_fast, add_scale, add_moving, add_inside})
        add(scenes);
    for (Scene& scene : scenes) {
        scene.catches = broken_movers_caught_by(scene.name, shape);
        scene.not_for_shape = why_not(scene.name, shape);
        if (shape == BodyShape::capsule) continue;
        for (Run& run : scene.runs) give(run, shape);
    }
    return scenes;
}

}  // namespace surefoot::course
