/// What the player sees over the game: health, coins, stars, time, prompts, where things are, where it hurt.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <surefoot/math.hpp>

#include "platformer/hud/minimap.hpp"
#include "platformer/screens/bindings.hpp"
#include "platformer/screens/palette.hpp"
#include "view/camera.hpp"
#include "view/canvas.hpp"

namespace surefoot::platformer {

/// Something that the player looks for. Shown at the screen's edge while it is out of sight.
struct HudMarker {
    enum class Kind : std::uint8_t { goal, checkpoint, key, door, star, ghost };
    Kind kind = Kind::goal;
    dvec3 place{0, 0, 0};  ///< in the level [m]
    std::string door{};    ///< of a key or a door: its name
};

/// Something hurt. The arc fades with its age.
struct HudHurt {
    dvec3 from{0, 0, 0};  ///< where it came from [m]
    double age = 0;       ///< [s]
};

/// All that the display needs to know; filled anew each frame.
struct HudView {
    int health = 3;
    int most_health = 3;
    int coins = 0;
    int coins_all = 0;
    int stars = 0;
    int stars_all = 3;
    std::vector<std::string> keys{};  ///< that the hero holds, by the names of their doors
    double seconds = 0;
    std::string section{};                  ///< the part of the level that was entered last
    double section_age = 1e9;               ///< since then [s]
    std::optional<double> section_split{};  ///< later (or, negative, sooner) than the best run was there [s]
    std::vector<PromptPart> prompt{};
    std::vector<HudMarker> markers{};
    std::vector<HudHurt> hurts{};
    std::vector<MapItem> map{};
    dvec3 hero{0, 0, 0};  ///< his middle [m]
    dvec3 facing{0, 0, -1};
    double hero_height = 1.6;   ///< [m]
    double since_coin = 1e9;    ///< [s]
    double since_health = 1e9;  ///< since it changed [s]
    bool watching = false;      ///< a recording, not a player
    std::string mark{};         ///< a word for the observer of somebody who is tested; empty: none
    view::Camera camera{};
    view::ivec2 window{800, 600};  ///< that the camera's picture fills [any unit]
};

struct HudLook {
    ColourVision colours = ColourVision::usual;
    bool reduced_motion = false;
    bool timer = true;
    bool minimap = true;
};

/// `plan` may be none: then there is no minimap. The canvas's picture has to be the plan's.
void draw_hud(view::Canvas& canvas, const HudView& hud, const Plan* plan, const HudLook& look);

/// What the hero covers, with room about him, where the camera sees him; nothing of the display stands there.
[[nodiscard]] view::Rect hero_box(const HudView& hud, const view::dvec2& size);

/// Where a marker stands on a frame about the picture's middle, and which way it points (0: up, to the right [rad]).
/// None while its place is in sight.
struct EdgePlace {
    view::dvec2 at{0, 0};
    double turn = 0;
};
[[nodiscard]] std::optional<EdgePlace> edge_place(const view::Camera& camera, const dvec3& place,
                                                  const view::dvec2& size, double margin);

}  // namespace surefoot::platformer
