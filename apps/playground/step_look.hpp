/// The story of a step, drawn into the world: its ways, what it touched, the planes that it obeyed, where it looked for
/// steps and edges, what it stood on. All rooms show it alike.
#pragma once

#include <cstdint>
#include <span>

#include <surefoot/character_trace.hpp>
#include <surefoot/math.hpp>

#include "view/renderer.hpp"

namespace surefoot::playground {

/// What a record is about, and so how it is drawn.
enum class StepPart : std::uint8_t {
    way,      ///< a motion: wanted, gone, given up, carried or pushed
    contact,  ///< a touch, or a plane that came of one
    probe,    ///< a look for a step, for an edge, or for room
    ground,   ///< what is stood on, or is not
};

[[nodiscard]] StepPart part_of(StepAct act);

/// What of a story is to be seen, and how large.
struct StepLook {
    dvec3 middle{0, 0, 0};  ///< from the reference point to where ways are drawn [m]
    dvec3 up{0, 1, 0};      ///< of the step, unit
    double size = 0.9;      ///< of normals; planes are as wide to either side [m]
    dvec3 from{0, 0, 0};    ///< about this place ...
    double stretch = 1;     ///< ... ways are drawn so many times as long: those of one tick are short
    bool ways = true;
    bool contacts = true;  ///< points and normals
    bool planes = true;    ///< that were obeyed, as pieces of themselves
    bool probes = true;
    bool ground = true;
};

/// The colour of what was tried, met or decided: an act that refuses is red, one that is obeyed orange, and so on.
[[nodiscard]] view::Colour colour_of(StepAct act);

/// All of a story, quietly.
void draw_story(view::Renderer& renderer, std::span<const StepRecord> records, const StepLook& look);

/// One record, lit, whatever the look leaves out.
void draw_record(view::Renderer& renderer, const StepRecord& record, const StepLook& look);

}  // namespace surefoot::playground
