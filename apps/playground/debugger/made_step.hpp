/// A step of a character with its whole story, and the step that a question is.
#pragma once

#include <cstddef>
#include <vector>

#include <surefoot/capture_explain.hpp>
#include <surefoot/capture_step.hpp>
#include <surefoot/character.hpp>
#include <surefoot/world.hpp>

#include "debugger/question.hpp"

namespace surefoot::debugger {

/// What a step is made of, besides the world.
struct StepOrder {
    CharacterSettings settings{};  ///< their table of surfaces is somebody else's, who has to outlive this
    CharacterInput input{};
    double dt = 0;  ///< [s]
    CharacterState before{};
};

struct MadeStep {
    StepOrder order{};
    StepResult result{};
    std::vector<StepRecord> records;  ///< all of them

    /// What `explain` wants; it refers to this step.
    [[nodiscard]] StepStory story() const;
};

[[nodiscard]] MadeStep make_step(const World& world, const StepOrder& order);

/// The recorded one, as the file has it. The file's surfaces have to outlive it.
[[nodiscard]] MadeStep recorded_step(const StepCapture& capture);

/// Its direction, of length 1; +Y where a file's has none.
[[nodiscard]] dvec3 up_of(const CharacterInput& input);

/// A question as one tick: a character that flies, so that nothing but the wish moves it, that has the velocity of its
/// wish already, and a second to go. So what it wants is END - START, bit for bit; it slides along what is in the way.
/// It knows no one-sided triangles: a step meets both sides.
[[nodiscard]] StepOrder order_of(const Question& question);

/// How far that character keeps off everything: what settings say by default, or less for a small shape [m].
[[nodiscard]] double skin_of(const Shape& shape);

}  // namespace surefoot::debugger
