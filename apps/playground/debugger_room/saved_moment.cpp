#include "playground/debugger_room/saved_moment.hpp"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <glm/geometric.hpp>
#include <iterator>

#include "debugger/saved_step.hpp"
#include "moment.hpp"
#include "text.hpp"

namespace surefoot::playground {

Expected<Moment> open_moment(const std::string& file) {
    auto capture = read_capture(file);
    if (!capture) return tl::unexpected(capture.error());
    Moment moment;
    moment.file = file;
    moment.capture = std::move(*capture);
    moment.replay = replay(moment.capture);
    const CapturedQuestion& asked = moment.capture.question;
    debugger::Question& question = moment.question;
    question.world = debugger::WorldKind::own;
    question.motion = asked.motion;
    question.one_sided = asked.one_sided;
    if (asked.kind == CaptureKind::ray) {
        // Thin enough to be a line beside its own length.
        question.sizes.sphere.radius = std::max(1e-6, 1e-3 * glm::length(asked.motion.to - asked.motion.from));
        question.shape = debugger::ShapeName::sphere;
        moment.remark = "It is a ray; a thin ball stands for it here.";
    } else {
        question.sizes.set(asked.volume.shape);
        question.shape = debugger::name_of(asked.volume.shape);
        question.orientation = asked.volume.orientation;
    }
    for (const CapturedTriangle& one : moment.capture.triangles)
        question.triangles.push_back(debugger::placed(moment.capture.bodies, one, asked.begin));
    if (std::any_of(moment.capture.bodies.begin(), moment.capture.bodies.end(), debugger::is_placed))
        moment.remark += fmt::format("{}Its bodies stand here as they do when the question begins.",
                                     moment.remark.empty() ? "" : " ");
    return moment;
}

SavedKind kind_of_file(const std::string& file) {
    std::ifstream input(file, std::ios::binary);
    return saved_kind(std::string(std::istreambuf_iterator<char>(input), {}));
}

Capture capture_of(const debugger::Question& question, const std::optional<Hit>& answer) {
    // One triangle's capture tells which build it is and how the question is written down; the rest is ours.
    Capture capture = capture_sweep(question.triangles.empty() ? Triangle{} : question.triangles.front(),
                                    question.volume(), question.motion, {.one_sided = question.one_sided});
    capture.triangles.clear();
    for (const Triangle& triangle : question.triangles)
        capture.triangles.push_back({.triangle = triangle, .id = static_cast<std::uint32_t>(capture.triangles.size())});
    capture.answer = answer;
    return capture;
}

std::string verdict_text(const Moment& moment) {
    if (moment.replay.is_same()) return "This build answers with the same bits as the saved answer.";
    return "This build answers otherwise than the saved answer: " + tools::difference_text(moment.replay.differs) +
           " differ.";
}

std::string free_name(const std::string& folder) {
    for (int i = 1;; ++i) {
        const std::filesystem::path path = std::filesystem::path(folder) / fmt::format("moment-{}.json", i);
        std::error_code error;
        if (!std::filesystem::exists(path, error)) return path.string();
    }
}

}  // namespace surefoot::playground
