/// Staged stops: small scenes in which a character stops for a reason that is known, and what would let it go on.
#pragma once

#include <functional>
#include <ostream>
#include <string>
#include <vector>

#include "movement_scene.hpp"

namespace surefoot::tests {

/// A scene, a character, what is asked of it, and what is known about why it does not get there.
struct Stage {
    std::string name;  ///< as a test is called
    Scene scene;
    CharacterSettings settings{};
    dvec3 start{-2, 1.5, 0};
    dvec3 wish{3, 0, 0};
    bool jumps = false;                    ///< once it has landed
    bool passes = false;                   ///< it is told once and not in every tick from then on
    std::vector<std::uint32_t> triangles;  ///< one of them is named
    StepRule rule = StepRule::none;        ///< decided
    std::string says;                      ///< the part of the sentence before the number
    double number = 0;                     ///< what the sentence says there
    double within = 0;                     ///< how far it may be from that
    /// Changes the settings so that the number, by the margin, is no reason any more.
    std::function<void(CharacterSettings&, double number)> change;
    /// Did the character get where it was to go?
    std::function<bool(const Actor&)> succeeded;
    double seconds = 1.5;
};

inline void PrintTo(const Stage& stage, std::ostream* out) {
    *out << stage.name;
}

[[nodiscard]] std::vector<Stage> stages();

}  // namespace surefoot::tests
