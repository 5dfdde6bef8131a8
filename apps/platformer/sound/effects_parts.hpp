/// The four workshops behind `make`: each makes the raw sound of the effects that it knows. Two random numbers are
/// never drawn within one expression: compilers differ in which of them they draw first.
#pragma once

#include "platformer/sound/effects.hpp"
#include "platformer/sound/instruments.hpp"
#include "platformer/sound/random.hpp"

namespace surefoot::sound {

[[nodiscard]] Samples make_of_feet(Effect effect, Random& random);     ///< steps, landings, slide, splash
[[nodiscard]] Samples make_of_moves(Effect effect, Random& random);    ///< jumps, dash, grab, climb, bounce, stomp
[[nodiscard]] Samples make_of_things(Effect effect, Random& random);   ///< coin to crumble
[[nodiscard]] Samples make_of_moments(Effect effect, Random& random);  ///< hurt, death, enemies, win, lose, menus

/// Noise through a band filter, struck and left to fade.
[[nodiscard]] Samples puff(Random& random, double frequency, double q, double half_life, double seconds);

/// A sine that falls from one frequency towards another and fades: a body that meets the ground.
[[nodiscard]] Samples thump(double from, double to, double half_life, double seconds);

}  // namespace surefoot::sound
