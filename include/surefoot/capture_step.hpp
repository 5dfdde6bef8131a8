/// Save this step: what a character was asked in one tick with the triangles that concern it, what came out and the
/// whole story of it, in one small file. Any build can make the step again of those triangles alone, see whether it
/// gets the same bits, and say why the character stopped (`surefoot replay FILE`). docs/capture.md tells every line of
/// the file, docs/why.md what to do with it.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <surefoot/capture.hpp>
#include <surefoot/capture_explain.hpp>
#include <surefoot/character.hpp>
#include <surefoot/error.hpp>
#include <surefoot/world.hpp>

namespace [[gnu::visibility("default")]] surefoot {
inline namespace v0 {

/// A step: everything that `replay` needs, and nothing else.
struct StepCapture {
    CharacterSettings settings{};       ///< without `surfaces`: see `settings_of`
    std::vector<SurfaceRule> surfaces;  ///< what the settings' `surfaces` refer to
    CharacterInput input{};
    double dt = 0;  ///< [s]
    CharacterState before{};
    std::vector<Neighbour> neighbours;  ///< that the step was given, in their order
    CharacterState after{};             ///< as it came out
    CharacterEvents events{};
    std::vector<StepRecord> records;          ///< the whole story
    std::vector<CapturedTriangle> triangles;  ///< that the step asked for, by (body, id), each once
    std::vector<CapturedBody> bodies;         ///< of those, and what carries it or a neighbour, by number
    CaptureOrigin origin{};
    std::string note;  ///< yours: where it happened, what you expected [UTF-8]
};

/// Makes the step and keeps what it was given and what it asked the world's bodies for. The state is not changed;
/// `after` is what `step` would return. Guarantees: `replay` of the capture gives the very bits that `step` gave. Of a
/// character in a crowd the neighbours are those that `Crowd::neighbours` lists, gathered before anybody stepped.
[[nodiscard]] StepCapture capture_step(const World& world, const CharacterSettings& settings,
                                       const CharacterInput& input, double dt, const CharacterState& state,
                                       std::span<const Neighbour> neighbours = {});

/// The settings with their table of surfaces, which is the capture's: good as long as it is.
[[nodiscard]] CharacterSettings settings_of(const StepCapture& capture) noexcept;

/// What `explain` wants. It refers to the capture.
[[nodiscard]] StepStory story_of(const StepCapture& capture) noexcept;

/// The step made again.
struct StepReplay {
    StepResult result{};              ///< what this build says
    std::vector<StepRecord> records;  ///< and the story that it tells
    std::string differs;  ///< what differs first in the story and in the outcome, in words; empty if no bit does

    [[nodiscard]] bool is_same() const noexcept { return differs.empty(); }
};

/// Makes the step again in a world of the captured triangles, and compares bit for bit. A capture whose bodies make no
/// world (a pose that is not finite) leaves the state unchanged and says `invalid`.
[[nodiscard]] StepReplay replay(const StepCapture& capture);

/// The file's text.
[[nodiscard]] std::string capture_text(const StepCapture& capture);

/// Reads the text of a file, as strictly as `parse_capture` and with the same errors; `limit` also beyond 2^20 records
/// or 2^16 surfaces or neighbours.
[[nodiscard]] Expected<StepCapture> parse_step_capture(std::string_view text, std::string_view file = {});

/// Writes the file. Whoever looks finds the whole old file or the whole new one. Fails with `write_failed`.
[[nodiscard]] Expected<void> write_capture(const StepCapture& capture, const std::string& path);

/// Reads the file. Fails with `not_found`, and as above.
[[nodiscard]] Expected<StepCapture> read_step_capture(const std::string& path);

/// A GoogleTest case in C++ that makes the step again and expects the captured state and events: a whole file that
/// compiles against this library. The story is not in it. `name` is as for a question's.
[[nodiscard]] std::string capture_cpp_test(const StepCapture& capture, std::string_view name = "moment");

}  // namespace v0
}  // namespace surefoot
