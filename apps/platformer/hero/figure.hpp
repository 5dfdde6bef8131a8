/// The hero as pieces: what a pose looks like.
#pragma once

#include <vector>

#include <surefoot/shapes.hpp>

#include "platformer/hero/pose.hpp"
#include "view/renderer.hpp"

namespace surefoot::platformer {

struct HeroColours {
    view::Colour fur = view::rgb(0xEE7F30);
    view::Colour cream = view::rgb(0xFFF0DA);
    view::Colour paw = view::rgb(0x54302B);
    view::Colour scarf = view::rgb(0x139C9C);
    view::Colour scarf_end = view::rgb(0x35C7B7);
};

struct HeroLook {
    HeroColours colours{};
    double opacity = 1;     ///< below 1 where the camera is so near that it would fill the picture [0 to 1]
    bool is_ghost = false;  ///< of another run: pale, without a shadow
};

/// Appends the pieces of one pose.
void add_pieces(std::vector<view::Piece>& pieces, const HeroPose& pose, const HeroLook& look = {});

/// Draws what is `blend` of the way from one tick to the next.
void draw(view::Renderer& renderer, const HeroPose& before, const HeroPose& after, double blend,
          const HeroLook& look = {});

/// The volume that meets the world, as F3 shows it.
void draw_volume(view::Renderer& renderer, const CharacterSettings& settings, const CharacterState& state);

}  // namespace surefoot::platformer
