#include "families.hpp"

namespace judge {

std::span<const Family> families() {
    static constexpr Family all[] = {
        {"random", "shapes, triangles and motions of everyday sizes", make_random},
        {"tangent", "passing exactly tangent (3-4-5 offsets), and an ulp to either side", make_tangent},
        {"touching", "starting exactly in touch or an ulp in or out: approaching, sliding, leaving", make_touching},
        {"inside", "starting inside, shallow and deep", make_inside},
        {"still", "no motion at all, or the least there is", make_still},
        {"parallel", "moving parallel to the plane or to an edge, on it, near it", make_parallel},
        {"edge-on", "within the plane of a ledge of no thickness, against its edge", make_edge_on},
        {"resweep", "going on from each reported contact", make_resweep},
        {"slivers", "slivers, needles and triangles without area", make_slivers},
        {"sizes", "triangles from 1e-4 m to 1e5 m", make_sizes},
        {"far", "1e3, 1e6 and 1e7 m from the origin", make_far},
        {"ratios", "radii in a ratio of up to 1:100", make_ratios},
        {"shared", "2 to 8 faces around one edge or corner", make_shared},
        {"wedges", "inner and outer wedges of 5 to 90 degrees, in the world and squashed", make_wedges},
        {"motions", "motions from 1e-6 m to 1e5 m", make_motions},
        {"limits", "the stated limits: 1e9 m, radii of 1e-6 to 1e6 m, a ratio of 1e4", make_limits},
        {"one-sided", "one-sided triangles, along and nearly along their planes", make_one_sided},
        {"invalid", "data outside the limits", make_invalid},
    };
    return all;
}

}  // namespace judge
