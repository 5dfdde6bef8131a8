/// The game's colours by what they mean, for eyes of every kind. No meaning is told by colour alone.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "view/colour.hpp"

namespace surefoot::platformer {

enum class ColourVision : std::uint8_t { usual, red_green, blue_yellow, contrast, count };

/// "Usual", for people; "usual", for files.
[[nodiscard]] std::string_view label_of(ColourVision vision);
[[nodiscard]] std::string_view word_of(ColourVision vision);

/// The usual one for a name that is none.
[[nodiscard]] ColourVision colour_vision_named(std::string_view word);

struct Palette {
    view::Colour ink;     ///< grounds of panels
    view::Colour paper;   ///< what is written
    view::Colour quiet;   ///< what is written and less important
    view::Colour accent;  ///< what is chosen
    view::Colour health;
    view::Colour coin;
    view::Colour star;
    view::Colour goal;
    view::Colour checkpoint;
    view::Colour key;
    view::Colour danger;  ///< enemies, and where it hurt
    view::Colour gold;
    view::Colour silver;
    view::Colour bronze;
};

/// Of a key and of the door that it opens, by the door's name: "red", "blue", "green", "yellow", "violet", "white"; any
/// other name gets one of them. Told apart by eyes of this kind, and by the sign beside it.
[[nodiscard]] view::Colour key_colour(std::string_view door, ColourVision vision);

/// The door's first letter: what stands beside its key.
[[nodiscard]] std::string key_sign(std::string_view door);

[[nodiscard]] const Palette& palette_for(ColourVision vision);

}  // namespace surefoot::platformer
