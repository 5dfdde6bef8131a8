/// A scene of the course: levels, a character in each, what it is asked to do tick by tick, and the bars that every
/// character controller has to clear, each with the geometry that it follows from.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include <surefoot/character_settings.hpp>
#include <surefoot/math.hpp>

#include "course/level.hpp"
#include "course/shape.hpp"

namespace surefoot::course {

/// What is asked of a character in one tick.
struct Input {
    dvec3 wish{0, 0, 0};  ///< the level velocity that is wanted, reached at once [m/s]
    bool jump = false;    ///< the button is held
};

/// Where a character is after a tick, by its own account.
struct Spot {
    double time = 0;  ///< since the run's script began; negative while it settles [s]
    dvec3 position{0, 0, 0};
    bool grounded = false;
    Input input{};  ///< what was asked of it in the tick that ends here
};

/// The input of the tick that begins at a time; `now` is where the character is then.
using Script = std::function<Input(double time, const Spot& now)>;

/// One walk of one character.
struct Run {
    std::string name;  ///< unique within its scene: "30 degrees"
    LevelPointer level;
    dvec3 start{0, 0, 0};     ///< of the centre of its body
    dvec3 rests_on{0, 1, 0};  ///< the normal of what it is put on, so that other shapes start as far from it
    Script script;
    double seconds = 3;   ///< of the script
    double rate = 60;     ///< ticks a second
    double settle = 0.5;  ///< before the script: no wish, so that it comes to stand [s]
    CharacterSettings settings{};

    [[nodiscard]] double dt() const { return 1 / rate; }
};

/// What came of a run: the spot at its start, then one a tick.
struct Outing {
    const Run* run = nullptr;
    std::vector<Spot> spots;
    std::string failure;  ///< why the mover gave up; empty if it did not

    /// The spots from the moment when the script begins.
    [[nodiscard]] std::span<const Spot> scripted() const;
    [[nodiscard]] const Spot& last() const { return spots.back(); }
};

/// The largest number of all that were measured, and in which run that was.
struct Worst {
    double value = 0;
    std::string where;

    /// NaN is worse than anything.
    void take(double measured, const std::string& run);
};

/// A number that may not be exceeded.
struct Bar {
    std::string what;    ///< "height changes"
    std::string unit;    ///< "m"; empty for a share or a count
    double most = 0;     ///< of what is measured
    std::string reason;  ///< why geometry asks for this much, in a sentence
    std::function<Worst(std::span<const Outing>)> measure;
};

struct Scene {
    std::string name;   ///< "floor-seams"
    std::string title;  ///< what it is, in a few words
    std::vector<Run> runs;
    std::vector<Bar> bars;
    std::vector<std::string> catches;  ///< which of the deliberately broken movers do not clear it
    std::string not_for_shape{};       ///< why geometry leaves it nothing to ask of such a body; empty if it applies

    /// A scene that does not apply to the shape is neither passed nor failed.
    [[nodiscard]] bool applies() const { return not_for_shape.empty(); }
};

/// The character that every scene begins from: a capsule 1.8 m high and 0.8 m wide, slopes of 50 degrees, steps of
/// 0.4 m, gravity 20 m/s^2, and no inertia on its feet or in the air, so that a wish is a speed.
[[nodiscard]] CharacterSettings hero();

/// Walks with one and the same wish.
[[nodiscard]] Script walk(const dvec3& wish);

/// A level velocity: `degrees` from +x towards +z.
[[nodiscard]] dvec3 heading(double degrees, double speed);

}  // namespace surefoot::course
