// Seeded faults: ways in which a sweep is known to go wrong, compiled in only to prove that the judge catches each of
// them. The library that users link never defines SUREFOOT_SEEDED_FAULTS, and every test below folds away.
#pragma once

namespace surefoot::internal {

enum class Fault {
    none,
    first_edge_dropped,            // the edge a-b proposes no plane
    vertices_dropped,              // no vertex proposes a plane
    face_dropped,                  // the face proposes no plane
    larger_root,                   // the exit root in place of the entry root
    absolute_epsilon,              // motions shorter than a fixed epsilon are taken for standing still
    one_ulp_late,                  // the gap's hair left out and the time rounded up
    mirrored_normal,               // the normal points into what was hit
    padding_along_velocity,        // the shape pulled back along the motion, not kept off along the normal
    parallel_skipped,              // a motion nearly parallel to the face skips the edges
    start_in_touch_ignored,        // whatever touches at the start is passed through
    start_in_touch_always_blocks,  // whatever touches at the start blocks, leaving or not
    approach_in_doubles,           // the sign of the approach at a touching start from rounded doubles
    far_end_ignored,               // a hit beyond the end of the motion is reported
    squash_without_rotation,       // the orientation of the volume is forgotten
    world_normal_not_unsquashed,   // the squashed normal reported as the world's
    hair_too_thick,                // stops early by a millionfold hair
    guess_believed,                // the feature that was guessed is believed, wherever it is met
    one_sided_by_rounding,         // the side of a one-sided triangle from rounded doubles
};

#ifdef SUREFOOT_SEEDED_FAULTS
inline Fault& active_fault() noexcept {
    static Fault fault = Fault::none;
    return fault;
}
inline bool has_fault(Fault fault) noexcept {
    return active_fault() == fault;
}
#else
constexpr bool has_fault(Fault) noexcept {
    return false;
}
#endif

}  // namespace surefoot::internal
