/// A step that is looked into: made again with other settings, beside the one that is the matter. What changes, and
/// from which line of the story on, in words.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <surefoot/capture_step.hpp>

#include "debugger/arena.hpp"
#include "debugger/made_step.hpp"

namespace surefoot::debugger {

/// A number of the settings that can be turned.
struct Dial {
    const char* label;
    double CharacterSettings::*field;
    double low;
    double high;
    const char* format;  ///< for a slider, as `printf` has it
    bool logarithmic;
    const char* hint;
};

/// Those that decide most stops first.
[[nodiscard]] std::span<const Dial> dials();

class StepStudy {
public:
    /// A saved step. It is made again of the triangles that were saved with it.
    explicit StepStudy(StepCapture capture);
    /// A step that was made just now.
    StepStudy(const Arena& arena, MadeStep made);
    StepStudy(const StepStudy&) = delete;  // steps refer to its surfaces
    StepStudy& operator=(const StepStudy&) = delete;

    /// The one that is the matter: as it was saved, or as it came out.
    [[nodiscard]] const MadeStep& recorded() const { return recorded_; }
    /// The same made again, with the edited settings.
    [[nodiscard]] const MadeStep& again() const { return again_; }

    [[nodiscard]] double value(const Dial& dial) const { return edited_.*dial.field; }
    void set(const Dial& dial, double value);
    [[nodiscard]] Response response() const { return edited_.response; }
    void set_response(Response response);
    /// Of what carried it when the tick began, or of surface 0 [SurfaceRule].
    [[nodiscard]] double grip() const;
    void set_grip(double grip);
    /// Back to the settings that it was made with.
    void reset();
    [[nodiscard]] bool is_edited() const;

    /// Why the recorded one, and why the one that was made again, went as they did.
    [[nodiscard]] const std::vector<StepSentence>& why() const { return why_; }
    [[nodiscard]] const std::vector<StepSentence>& why_again() const { return why_again_; }

    /// What is different with the edited settings, in sentences.
    [[nodiscard]] std::string difference() const;

    /// In the world when the tick begins; none for a record that names none.
    [[nodiscard]] std::optional<Triangle> triangle_of(const StepRecord& record) const;

    /// The step as it was made, with the triangles near it, to be kept.
    [[nodiscard]] StepCapture capture() const { return capture_(); }

private:
    void make_again();

    MadeStep recorded_;
    CharacterSettings edited_;
    std::vector<SurfaceRule> surfaces_;  // that the edited settings refer to
    MadeStep again_;
    std::vector<StepSentence> why_;
    std::vector<StepSentence> why_again_;
    std::function<MadeStep(const StepOrder&)> make_;
    std::function<std::optional<Triangle>(std::uint32_t body, std::uint32_t triangle)> find_;
    std::function<StepCapture()> capture_;
};

/// How a step that was made differs from another, in sentences: where it ends, what carries it, what happened, and the
/// line at which their stories part.
[[nodiscard]] std::string difference_text(const MadeStep& then, const MadeStep& now);

}  // namespace surefoot::debugger
