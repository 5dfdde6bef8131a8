#include "debugger/saved_step.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "debugger/made_step.hpp"

namespace surefoot::debugger {

namespace {

SavedStep saved(StepCapture capture, std::string_view file) {
    SavedStep step;
    step.file = file;
    step.capture = std::move(capture);
    step.differs = replay(step.capture).differs;
    const StepCapture& kept = step.capture;
    CharacterInput input = kept.input;
    input.up = up_of(input);
    const Neighbour body = neighbour_of(settings_of(kept), input, kept.before);
    Question& question = step.question;
    question.world = WorldKind::own;
    question.sizes.set(body.volume.shape);
    question.shape = name_of(body.volume.shape);
    question.orientation = body.volume.orientation;
    // From where it stands, and not from where lifts have carried it when it begins to go.
    const auto wants = std::find_if(kept.records.begin(), kept.records.end(),
                                    [](const StepRecord& record) { return record.act == StepAct::wants; });
    const dvec3 way = wants != kept.records.end() ? wants->motion : kept.after.position - kept.before.position;
    question.motion = {kept.before.position, kept.before.position + way};
    for (const CapturedTriangle& one : kept.triangles) question.triangles.push_back(placed(kept.bodies, one, 0));
    if (std::any_of(kept.bodies.begin(), kept.bodies.end(), is_placed))
        step.remark = "Its bodies stand here as they do when the tick begins.";
    return step;
}

}  // namespace

Expected<SavedStep> open_step(const std::string& file) {
    auto capture = read_step_capture(file);
    if (!capture) return tl::unexpected(capture.error());
    return saved(std::move(*capture), file);
}

Expected<SavedStep> step_from_text(std::string_view text, std::string_view file) {
    auto capture = parse_step_capture(text, file);
    if (!capture) return tl::unexpected(capture.error());
    return saved(std::move(*capture), file);
}

std::string verdict_text(const SavedStep& step) {
    if (step.differs.empty()) return "This build makes the same step of it, to the last bit.";
    return fmt::format("This build makes another step of it: it differs first in {}.", step.differs);
}

bool is_placed(const CapturedBody& body) {
    const Pose still{};
    const auto same = [](const Pose& a, const Pose& b) {
        return a.position == b.position && a.orientation == b.orientation;
    };
    return !same(body.start, still) || !same(body.start, body.end);
}

Triangle placed(std::span<const CapturedBody> bodies, const CapturedTriangle& one, double at) {
    for (const CapturedBody& body : bodies) {
        if (body.body != one.body || !is_placed(body)) continue;
        const Pose pose = pose_between(body.start, body.end, at);
        return {to_world(pose, one.triangle.a), to_world(pose, one.triangle.b), to_world(pose, one.triangle.c)};
    }
    return one.triangle;
}

std::optional<Triangle> triangle_at_start(const StepCapture& capture, std::uint32_t body, std::uint32_t triangle) {
    for (const CapturedTriangle& one : capture.triangles)
        if (one.body == body && one.id == triangle) return placed(capture.bodies, one, 0);
    return std::nullopt;
}

}  // namespace surefoot::debugger
