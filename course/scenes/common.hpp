/// What the files of scenes share.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include <surefoot/random.hpp>

#include "course/catalogue.hpp"
#include "course/measures.hpp"

namespace surefoot::course {

/// A short name for a number: "30", "0.25".
[[nodiscard]] inline std::string text_of(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.6g", value);
    return text;
}

/// A run of the hero that begins two skins above a place on the ground.
[[nodiscard]] inline Run run_at(std::string name, LevelPointer level, const dvec3& ground, Script script,
                                double seconds = 3) {
    Run run;
    run.settings = hero();
    run.name = std::move(name);
    run.level = std::move(level);
    run.start = ground + dvec3{0, standing(run.settings) + 2 * run.settings.skin, 0};
    run.script = std::move(script);
    run.seconds = seconds;
    return run;
}

/// The height of the lowest point of the body at the end, a skin below which level ground is expected.
[[nodiscard]] inline double feet(const Outing& outing) {
    const CharacterSettings& settings = outing.run->settings;
    return outing.last().position.y - standing(settings) - (gap_below(settings) - settings.skin);
}

/// Numbers that look random and are the same on every machine.
class Dice {
public:
    explicit Dice(std::uint64_t seed) : state_(seed) {}

    std::uint64_t bits() { return next_random(state_); }
    double from(double low, double high) { return low + (high - low) * static_cast<double>(bits() >> 11) * 0x1p-53; }

private:
    std::uint64_t state_;
};

}  // namespace surefoot::course
