// Any bytes as a saved moment, step or session: reading says yes or why not, and what was read is written, read and
// replayed to the same.
#include <array>
#include <string>
#include <string_view>

#include "bytes.hpp"

namespace {

using namespace fuzz;

// Bodies that turn are asked in thousands of pieces; many triangles in each would only look like a hang.
constexpr std::size_t most_triangles = 64;

// So would a step of a minute in parts of a microsecond.
bool is_short(double dt, const surefoot::CharacterSettings& settings) {
    return !(dt > 16 * settings.longest_tick);
}

void fuzz_step(std::string_view bytes) {
    const auto capture = surefoot::parse_step_capture(bytes, "step.json");
    if (!capture) {
        require(!capture.error().text.empty(), "an error says what is wrong");
        require(capture.error().byte <= bytes.size(), "an error says where");
        return;
    }
    const std::string text = surefoot::capture_text(*capture);
    const auto again = surefoot::parse_step_capture(text);
    require(again.has_value(), "what is written can be read");
    require(surefoot::capture_text(*again) == text, "what is read is what was written");
    require(!surefoot::explain(surefoot::story_of(*capture)).empty(), "there is always something to say");
    if (capture->triangles.size() > most_triangles || !is_short(capture->dt, capture->settings)) return;
    const surefoot::StepReplay first = surefoot::replay(*capture);
    const surefoot::StepReplay second = surefoot::replay(*again);
    require(first.differs == second.differs, "a replay depends on the capture alone");
    require(surefoot::hash(first.result.state) == surefoot::hash(second.result.state), "to the last bit");
}

void fuzz_session(std::string_view bytes) {
    const auto session = surefoot::parse_session(bytes, "session.json");
    if (!session) {
        require(!session.error().text.empty(), "an error says what is wrong");
        require(session.error().byte <= bytes.size(), "an error says where");
        return;
    }
    const std::string text = surefoot::session_text(*session);
    const auto again = surefoot::parse_session(text);
    require(again.has_value(), "what is written can be read");
    require(surefoot::session_text(*again) == text, "what is read is what was written");
    surefoot::Session on_nothing = *session;
    surefoot::World world;
    on_nothing.level = surefoot::level_hash(world);
    for (const surefoot::SessionTick& tick : session->ticks) {
        if (!is_short(tick.dt, session->settings)) return;
    }
    static_cast<void>(surefoot::replay(on_nothing, world, 64));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    const surefoot::SavedKind kind = surefoot::saved_kind(bytes);
    if (kind == surefoot::SavedKind::step) fuzz_step(bytes);
    if (kind == surefoot::SavedKind::session) fuzz_session(bytes);
    const auto capture = surefoot::parse_capture(bytes, "moment.json");
    if (!capture) {
        require(!capture.error().text.empty(), "an error says what is wrong");
        require(capture.error().byte <= size, "an error says where");
        return 0;
    }
    const std::string text = surefoot::capture_text(*capture);
    const auto again = surefoot::parse_capture(text);
    require(again.has_value(), "what is written can be read");
    require(surefoot::capture_text(*again) == text, "what is read is what was written");
    static_cast<void>(surefoot::capture_cpp_test(*capture));
    if (capture->triangles.size() > most_triangles) return 0;
    std::array<surefoot::TraceRecord, 64> room;
    surefoot::Trace trace(room);
    const surefoot::Replay first = surefoot::replay(*capture, &trace);
    const surefoot::Replay second = surefoot::replay(*again);
    require(!surefoot::difference_of(first.answer, second.answer).any(), "a replay depends on the capture alone");
    return 0;
}
