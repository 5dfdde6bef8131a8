#include "debugger/made_step.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace surefoot::debugger {

namespace {

constexpr std::size_t usual_records = 256;

/// The least of a shape's dimensions, a quarter of which the skin may be.
struct Smallest {
    double operator()(const Sphere& s) const { return s.radius; }
    double operator()(const Ellipsoid& s) const { return std::min({s.radii.x, s.radii.y, s.radii.z}); }
    double operator()(const Capsule& s) const { return s.radius; }
    double operator()(const Box& s) const { return std::min({s.half_extents.x, s.half_extents.y, s.half_extents.z}); }
    double operator()(const Cylinder& s) const { return std::min(s.radius, s.half_height); }
    double operator()(const Cone& s) const { return std::min(s.radius, s.height); }
};

}  // namespace

StepStory MadeStep::story() const {
    return {.settings = order.settings,
            .input = order.input,
            .dt = order.dt,
            .before = order.before,
            .result = result,
            .records = records,
            .dropped = 0};
}

MadeStep make_step(const World& world, const StepOrder& order) {
    MadeStep made{order, {}, {}};
    for (std::size_t room = usual_records;;) {
        made.records.resize(room);
        StepTrace trace(made.records);
        made.result = step(world, order.settings, order.input, order.dt, order.before, {}, &trace);
        room = trace.records().size() + trace.dropped();
        made.records.resize(trace.records().size());
        if (trace.dropped() == 0) return made;
    }
}

MadeStep recorded_step(const StepCapture& capture) {
    return {{settings_of(capture), capture.input, capture.dt, capture.before},
            {capture.after, capture.events},
            capture.records};
}

dvec3 up_of(const CharacterInput& input) {
    const double size = glm::length(input.up);
    return size > 0 && std::isfinite(size) ? input.up / size : dvec3(0, 1, 0);
}

double skin_of(const Shape& shape) {
    return std::min(CharacterSettings{}.skin, std::visit(Smallest{}, shape) / 16);
}

StepOrder order_of(const Question& question) {
    StepOrder order;
    order.settings.volume = question.volume();
    order.settings.skin = skin_of(order.settings.volume.shape);
    order.dt = 1;
    order.settings.longest_tick = order.dt;
    order.input.mode = CharacterMode::fly;
    order.input.wish = question.motion.to - question.motion.from;
    order.before.position = question.motion.from;
    order.before.velocity = order.input.wish;
    return order;
}

}  // namespace surefoot::debugger
