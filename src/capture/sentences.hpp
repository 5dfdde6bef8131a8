// What single records of a step mean, in words.
#pragma once

#include <string>

#include <surefoot/capture_explain.hpp>

#include "character/surroundings.hpp"
#include "vec.hpp"

namespace surefoot::internal {

/// What the sentences about one step have in common.
struct Speaker {
    const StepStory& story;
    Vec up;     ///< unit
    Body body;  ///< measured

    /// Requires: the step's arguments were valid.
    explicit Speaker(const StepStory& told) noexcept;

    /// "triangle 12 of body 0".
    [[nodiscard]] std::string name(const StepRecord& record) const;
    /// How a plane that is in the way lies: "that face rises by 62 degrees, and the slope limit is 50".
    [[nodiscard]] std::string lie(const StepRecord& record) const;
    [[nodiscard]] std::string no_step(const StepRecord& record) const;
    [[nodiscard]] std::string no_ground(const StepRecord& record) const;
    [[nodiscard]] std::string left_ground(const StepRecord& record) const;
    /// For acts that are told by themselves; empty for all others.
    [[nodiscard]] std::string act(const StepRecord& record) const;

private:
    [[nodiscard]] std::string slope(const StepRecord& record) const;
    [[nodiscard]] std::string ledge(const StepRecord& record) const;
    [[nodiscard]] std::string perch(const StepRecord& record) const;
};

/// Four digits, as a person would write them.
[[nodiscard]] std::string short_text(double value);

/// The angle whose cosine this is [degrees, 0 to 180].
[[nodiscard]] double angle_deg(double cosine) noexcept;

}  // namespace surefoot::internal
