#include <algorithm>
#include <memory>

#include <surefoot/capture_step.hpp>

#include "capture/listener.hpp"
#include "capture/parts.hpp"
#include "ieee_guard.hpp"

namespace surefoot {
inline namespace v0 {

using namespace internal;

namespace {

constexpr std::size_t usual_records = 1024;

/// The same world, each body of which listens.
struct ListeningWorld {
    std::vector<BodyPose> poses;  // by number
    std::vector<std::unique_ptr<Listener>> listeners;
    World world;

    explicit ListeningWorld(const World& heard) {
        poses.resize(heard.body_count());
        heard.save_poses(poses);
        for (const BodyPose& pose : poses) {
            const BodyHandle handle = heard.find(pose.body);
            const std::optional<SourceView> source = heard.source(handle);
            if (!source) continue;
            listeners.push_back(std::make_unique<Listener>(*source));
            const auto added = world.add(*listeners.back(), {.pose = pose.start, .body = pose.body});
            if (added) static_cast<void>(world.move(*added, pose.start, pose.end));
        }
    }
};

// Bodies that carry the character or one of its neighbours move them, whatever is asked of their triangles.
bool carries(const StepCapture& capture, std::uint32_t body) noexcept {
    const auto carried = [&](const Neighbour& one) { return one.is_carried && one.carrier == body; };
    return (capture.before.footing != Footing::air && capture.before.ground_body == body) ||
           std::any_of(capture.neighbours.begin(), capture.neighbours.end(), carried);
}

void keep_heard(StepCapture& capture, const ListeningWorld& heard) {
    for (std::size_t i = 0; i < heard.listeners.size(); ++i) {
        const Listener& listener = *heard.listeners[i];
        const BodyPose& pose = heard.poses[i];
        if (!listener.was_asked() && !carries(capture, pose.body)) continue;
        capture.bodies.push_back(
            {.body = pose.body, .start = pose.start, .end = pose.end, .bounds = listener.bounds()});
        for (const std::uint32_t id : listener.heard()) {
            capture.triangles.push_back(
                {.triangle = listener.triangle(id), .id = id, .surface = listener.surface(id), .body = pose.body});
        }
    }
}

}  // namespace

StepCapture capture_step(const World& world, const CharacterSettings& settings, const CharacterInput& input, double dt,
                         const CharacterState& state, std::span<const Neighbour> neighbours) {
    const IeeeGuard guard;
    StepCapture capture;
    capture.settings = settings;
    capture.settings.surfaces = {};
    capture.surfaces.assign(settings.surfaces.all().begin(), settings.surfaces.all().end());
    capture.input = input;
    capture.dt = dt;
    capture.before = state;
    capture.neighbours.assign(neighbours.begin(), neighbours.end());
    capture.origin = {.library = library_version(), .abi = abi_name, .format = step_form};
    const ListeningWorld listening(world);
    for (std::size_t room = usual_records;;) {
        capture.records.resize(room);
        StepTrace trace(capture.records);
        const StepResult result = step(listening.world, settings, input, dt, state, neighbours, &trace);
        room = trace.records().size() + trace.dropped();
        capture.records.resize(trace.records().size());
        capture.after = result.state;
        capture.events = result.events;
        if (trace.dropped() == 0) break;
    }
    keep_heard(capture, listening);
    return capture;
}

CharacterSettings settings_of(const StepCapture& capture) noexcept {
    CharacterSettings settings = capture.settings;
    settings.surfaces = SurfaceRules(capture.surfaces);
    return settings;
}

StepStory story_of(const StepCapture& capture) noexcept {
    return {.settings = settings_of(capture),
            .input = capture.input,
            .dt = capture.dt,
            .before = capture.before,
            .result = {capture.after, capture.events},
            .records = capture.records,
            .dropped = 0};
}

}  // namespace v0
}  // namespace surefoot
