#include <algorithm>

#include <surefoot/capture_step.hpp>

#include "capture/captured_world.hpp"
#include "capture/differences.hpp"
#include "capture/words.hpp"
#include "ieee_guard.hpp"

namespace surefoot {
inline namespace v0 {

using namespace internal;

namespace {

// In the story, "the same but longer" is a difference at its end.
std::string difference_in_story(const std::vector<StepRecord>& then, const std::vector<StepRecord>& now) {
    const std::size_t shared = std::min(then.size(), now.size());
    for (std::size_t i = 0; i < shared; ++i) {
        const std::string field = first_difference(then[i], now[i]);
        if (field.empty()) continue;
        return joined(
            {"record ", std::to_string(i), " of the story (", word_of(act_words, then[i].act), ") in ", field});
    }
    if (then.size() == now.size()) return {};
    return joined({"the length of the story, ", std::to_string(then.size()), " records then and ",
                   std::to_string(now.size()), " now"});
}

std::string difference_of(const StepCapture& then, const StepReplay& now) {
    std::string text = difference_in_story(then.records, now.records);
    std::string outcome = first_difference(then.after, now.result.state);
    if (outcome.empty()) {
        outcome = first_difference(then.events, now.result.events);
        if (!outcome.empty()) outcome = "events: " + outcome;
    }
    if (!text.empty() && !outcome.empty()) text += "; and ";
    return text + outcome;
}

}  // namespace

StepReplay replay(const StepCapture& capture) {
    const IeeeGuard guard;
    StepReplay again;
    const CapturedWorld captured(capture.triangles, capture.bodies);
    if (captured.is_whole()) {
        for (std::size_t room = std::max<std::size_t>(capture.records.size(), 1);;) {
            again.records.resize(room);
            StepTrace trace(again.records);
            again.result = step(captured.get(), settings_of(capture), capture.input, capture.dt, capture.before,
                                capture.neighbours, &trace);
            room = trace.records().size() + trace.dropped();
            again.records.resize(trace.records().size());
            if (trace.dropped() == 0) break;
        }
    } else {
        again.result = {capture.before, {}};
        again.result.events.set = static_cast<std::uint32_t>(CharacterEvent::invalid);
    }
    again.differs = difference_of(capture, again);
    return again;
}

}  // namespace v0
}  // namespace surefoot
