#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "character_words.hpp"
#include "query.hpp"
#include "replays.hpp"
#include "text.hpp"

namespace surefoot::tools {
namespace {

std::string counted(std::size_t count, std::string_view one, std::string_view many = {}) {
    if (count == 1) return fmt::format("1 {}", one);
    return many.empty() ? fmt::format("{} {}s", grouped(count), one) : fmt::format("{} {}", grouped(count), many);
}

std::string state_text(const CharacterState& state) {
    return fmt::format("at ({}), {} m/s, {}", short_vector(state.position), short_number(glm::length(state.velocity)),
                       footing_text(state.footing));
}

std::string outcome_text(const CharacterState& state, const CharacterEvents& events) {
    return fmt::format("  {}\n  events: {}\n", state_text(state), events_text(events));
}

std::vector<std::string> sentences_of(const StepCapture& capture, const StepReplay& again) {
    StepStory story = story_of(capture);
    story.result = again.result;
    story.records = again.records;
    std::vector<std::string> sentences;
    for (const StepSentence& one : explain(story)) sentences.push_back(one.text);
    return sentences;
}

}  // namespace

std::string version_text(const Version& v) {
    return fmt::format("{}.{}.{}", v.major, v.minor, v.patch);
}

std::string step_report(const std::string& file, const StepCapture& capture, const StepReplay& again) {
    std::string text =
        fmt::format("{}, saved by surefoot {} ({})\n", file, version_text(capture.origin.library), capture.origin.abi);
    if (!capture.note.empty()) text += fmt::format("Note: {}\n", capture.note);
    text += fmt::format("A step of {} s: {}, {}; it wishes for ({}) m/s{}.\n", short_number(capture.dt),
                        describe(capture.settings.volume), state_text(capture.before), short_vector(capture.input.wish),
                        capture.input.jump ? " and jumps" : "");
    const std::size_t others = capture.neighbours.size();
    text += fmt::format("Near its way: {} of {}{}. Its story has {}.\n", counted(capture.triangles.size(), "triangle"),
                        counted(capture.bodies.size(), "body", "bodies"),
                        others > 0 ? ", and " + counted(others, "neighbour") : "",
                        counted(capture.records.size(), "record"));
    text += "Recorded:\n" + outcome_text(capture.after, capture.events);
    if (again.is_same()) {
        text += "Made again: the same, to the last bit.\n";
    } else {
        text += fmt::format("Made again by surefoot {}: DIFFERENT, first in {}.\n", version_text(library_version()),
                            again.differs);
        text += outcome_text(again.result.state, again.result.events);
    }
    text += "Why:\n";
    for (const std::string& sentence : sentences_of(capture, again)) text += fmt::format("  {}\n", sentence);
    return text;
}

std::string step_json(const std::string& file, const StepCapture& capture, const StepReplay& again) {
    std::string text = fmt::format(R"({{"file":{},"same":{},"differs":{},"why":[)", json_string(file), again.is_same(),
                                   json_string(again.differs));
    bool is_first = true;
    for (const std::string& sentence : sentences_of(capture, again)) {
        if (!is_first) text += ',';
        text += json_string(sentence);
        is_first = false;
    }
    return text + fmt::format(R"(],"hash":"{:016x}","triangles":{},"neighbours":{},"library":{},"note":{}}})"
                              "\n",
                              hash(again.result.state), capture.triangles.size(), capture.neighbours.size(),
                              json_string(version_text(capture.origin.library)), json_string(capture.note));
}

}  // namespace surefoot::tools
