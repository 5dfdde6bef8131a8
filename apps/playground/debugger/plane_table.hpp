/// How the library itself decides, for every shape: the planes between shape and triangle that its trace records, in
/// words. For capsule, box, cylinder and cone this is the table that the debugger shows.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <surefoot/hit.hpp>
#include <surefoot/math.hpp>
#include <surefoot/shapes.hpp>
#include <surefoot/trace.hpp>

namespace surefoot::debugger {

struct PlaneRow {
    std::string proposed_by;  ///< "face", "edge ab", "vertex c"
    dvec3 normal{0, 0, 0};    ///< unit, from the triangle towards the shape
    double gap_from = 0;      ///< at START [m]; negative is depth
    double gap_to = 0;        ///< at END [m]
    std::optional<double> t;  ///< when the gap closes or opens
    Verdict verdict = Verdict::inside;
    bool answer = false;  ///< the last plane to give way, which the answer is
    std::string why;      ///< the verdict in words
};

struct PlaneTable {
    std::vector<PlaneRow> rows;  ///< each plane once, in the order in which it was tried
    std::optional<Hit> hit;
    std::string conclusion;
};

/// Asks the library's sweep of this triangle, with a trace.
[[nodiscard]] PlaneTable plane_table(const Volume& volume, const Motion& motion, const Triangle& triangle,
                                     bool one_sided = false);

}  // namespace surefoot::debugger
