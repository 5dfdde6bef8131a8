/// Why did I stop? The record of a step in plain sentences, each with the triangle, the rule and the number.
///
/// docs/why.md teaches it. It allocates and is no part of a step: step with a trace as always, and ask for words when
/// somebody wants to read them.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include <surefoot/character.hpp>
#include <surefoot/character_trace.hpp>

namespace [[gnu::visibility("default")]] surefoot {
inline namespace v0 {

/// A step that was made, and what its trace was told. The records are yours and must outlive the call.
struct StepStory {
    CharacterSettings settings{};
    CharacterInput input{};
    double dt = 0;  ///< [s]
    CharacterState before{};
    StepResult result{};
    std::span<const StepRecord> records{};
    std::size_t dropped = 0;  ///< how many records found no room in the trace
};

/// One sentence.
struct StepSentence {
    std::string text;
    /// What it is about: the rule that decided, with the value that was held against the limit, and the triangle.
    StepRecord about{};
};

/// Why a step went as it did: why the character stopped or was slowed, why there was no step, why it left the ground,
/// slid or did not jump. In the order in which things happened; at least one sentence. A pure function of the story.
/// A sentence that names a setting and the number that was held against it: with the setting past that number, by a
/// degree or a centimetre, this rule decides the other way (tests/why_stops_test.cpp). Another one may still refuse.
[[nodiscard]] std::vector<StepSentence> explain(const StepStory& story);

/// The same as one text, a sentence or two a line.
[[nodiscard]] std::string explain_text(const StepStory& story);

}  // namespace v0
}  // namespace surefoot
