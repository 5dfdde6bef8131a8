/// The families of queries that the judge is asked about, each aimed at one way in which sweeps go wrong.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "../query.hpp"
#include "draw.hpp"

namespace judge {

/// The function under judgement.
using Sweep = std::function<Answer(const Query&)>;

/// What a family may use: its own random numbers, the shape wanted, and the sweep itself (to go on from its contacts).
struct Source {
    Draw& draw;
    Kind kind;
    const Sweep& sweep;
};

struct Family {
    const char* name;
    const char* about;
    /// Appends one or more queries.
    void (*make)(const Source& source, std::vector<Query>& queries);
};

[[nodiscard]] std::span<const Family> families();

// families_everyday.cpp
void make_random(const Source&, std::vector<Query>&);
void make_sizes(const Source&, std::vector<Query>&);
void make_far(const Source&, std::vector<Query>&);
void make_ratios(const Source&, std::vector<Query>&);
void make_motions(const Source&, std::vector<Query>&);
void make_limits(const Source&, std::vector<Query>&);
void make_slivers(const Source&, std::vector<Query>&);
void make_invalid(const Source&, std::vector<Query>&);

// families_contact.cpp
void make_tangent(const Source&, std::vector<Query>&);
void make_touching(const Source&, std::vector<Query>&);
void make_inside(const Source&, std::vector<Query>&);
void make_still(const Source&, std::vector<Query>&);
void make_parallel(const Source&, std::vector<Query>&);
void make_edge_on(const Source&, std::vector<Query>&);
void make_one_sided(const Source&, std::vector<Query>&);

// families_neighbours.cpp
void make_resweep(const Source&, std::vector<Query>&);
void make_shared(const Source&, std::vector<Query>&);
void make_wedges(const Source&, std::vector<Query>&);

}  // namespace judge
