/// A short character controller of the usual build, and the faults that such controllers have. Each fault can be
/// switched on alone; a scene of the course that none of them fails shows nothing.
#pragma once

namespace surefoot::course {

struct Faults {
    bool hit_by_hit = false;        ///< slides along what was hit last and forgets what was hit before
    bool steps_by_tick = false;     ///< looks for a step no farther ahead than the rest of the tick's motion
    bool raw_edges = false;         ///< believes the normals of inner edges
    bool pads_velocity = false;     ///< keeps its distance along the motion instead of the normal
    bool one_body = false;          ///< knows the contacts of one body at a time
    bool moves_first = false;       ///< moves, then pushes itself out of what it overlaps
    bool single_precision = false;  ///< keeps its position in floats
    bool pushes_too_far = false;    ///< keeps farther off by pushing than by stopping
    bool stops = false;             ///< stays where it meets something
    bool any_slope = false;         ///< stands on whatever is under it
    bool human_lengths = false;     ///< lengths in its code instead of its settings
};

}  // namespace surefoot::course
