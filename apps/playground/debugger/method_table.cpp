#include "debugger/method_table.hpp"

#include <cmath>
#include <fmt/format.h>
#include <glm/geometric.hpp>

#include <surefoot/barycentrics.hpp>

#include "debugger/squash.hpp"

namespace surefoot::debugger {

namespace {

constexpr const char* edge_names[] = {"ab", "bc", "ca"};
constexpr const char* corner_names[] = {"a", "b", "c"};

/// What all seven have in common. START is the origin.
struct Squashed {
    std::array<dvec3, 3> corners;
    dvec3 along;  ///< the motion
    /// How long 1 of the squashed space is: a radius for a ball; for an ellipsoid it depends on the direction.
    std::optional<double> metres;

    /// A length of the squashed space, in words.
    [[nodiscard]] std::string length_text(double length) const {
        return metres ? short_text(length * *metres) + " m" : short_text(length) + " of squashed space";
    }
};

void reject(Candidate& candidate, Reason reason, std::string why) {
    candidate.kept = false;
    candidate.reason = reason;
    candidate.why = std::move(why);
}

/// The checks of time, which all candidates share. `what` is the endless thing whose distance the equation is about.
bool is_in_time(Candidate& candidate, Root root, const Squashed& space, const char* what) {
    const Equation& equation = candidate.equation;
    candidate.roots = roots_of(equation);
    if (equation.a == 0 && equation.b == 0) {
        reject(candidate, Reason::parallel, fmt::format("the motion is parallel to the {}", what));
        return false;
    }
    if (equation.c <= 0) {
        reject(candidate, Reason::before_start, fmt::format("at START the ball already cuts the {}", what));
        return false;
    }
    if (equation.b >= 0) {
        reject(candidate, Reason::moving_away, fmt::format("moving away from the {}", what));
        return false;
    }
    if (candidate.roots.count == 0) {
        const double closest = std::sqrt(std::max(0.0, 1 + equation.c - equation.b * equation.b / (4 * equation.a)));
        reject(candidate, Reason::no_root, fmt::format("no real root: passes by {}", space.length_text(closest - 1)));
        return false;
    }
    candidate.t = root == Root::lower ? candidate.roots.lower : candidate.roots.upper;
    if (*candidate.t > 1) {
        reject(candidate, Reason::after_end, fmt::format("comes only after END, at t = {}", short_text(*candidate.t)));
        return false;
    }
    return true;
}

/// Barycentrics in the triangle's plane, which may lie outside of the triangle.
dvec3 weights_in_plane(const std::array<dvec3, 3>& corners, const dvec3& normal, const dvec3& p) {
    const auto share = [&](const dvec3& from, const dvec3& to) {
        return glm::dot(glm::cross(to - from, p - from), normal) / glm::dot(normal, normal);
    };
    return {share(corners[1], corners[2]), share(corners[2], corners[0]), share(corners[0], corners[1])};
}

Candidate ask_interior(const Squashed& space) {
    Candidate candidate;
    candidate.name = "interior";
    const auto& [a, b, c] = space.corners;
    const dvec3 normal = glm::cross(b - a, c - a);
    const double area = glm::length(normal);
    if (area == 0) {
        reject(candidate, Reason::degenerate, "the triangle has no area, so it has no plane");
        return candidate;
    }
    const double height = -glm::dot(normal, a) / area;  // of START over the plane
    const double side = height < 0 ? -1 : 1;
    const dvec3 towards = normal * (side / area);
    candidate.equation = {0, glm::dot(towards, space.along), std::abs(height) - 1};
    if (!is_in_time(candidate, Root::lower, space, "plane")) return candidate;
    const dvec3 contact = space.along * *candidate.t - towards;
    candidate.squashed_contact = contact;
    const dvec3 weights = weights_in_plane(space.corners, normal, contact);
    candidate.weights = weights;
    candidate.kept = weights.x >= 0 && weights.y >= 0 && weights.z >= 0;
    if (!candidate.kept) reject(candidate, Reason::outside, "the contact lies outside the triangle");
    return candidate;
}

Candidate ask_edge(const Squashed& space, std::uint8_t index, Root root) {
    Candidate candidate;
    candidate.feature = Feature::edge;
    candidate.index = index;
    candidate.name = fmt::format("edge {}", edge_names[index]);
    const dvec3 p = space.corners[index];
    const dvec3 edge = space.corners[(index + 1U) % 3] - p;
    const double squared = glm::dot(edge, edge);
    if (squared == 0) {
        reject(candidate, Reason::degenerate, "the edge has no length; its corner is asked anyway");
        return candidate;
    }
    // Both without their parts along the edge: what remains is a point that passes a circle.
    const dvec3 across = space.along - edge * (glm::dot(space.along, edge) / squared);
    const dvec3 start = -p + edge * (glm::dot(p, edge) / squared);
    const bool parallel =
        glm::length(glm::cross(space.along, edge)) <= 1e-14 * glm::length(space.along) * std::sqrt(squared);
    if (!parallel) candidate.equation = {glm::dot(across, across), 2 * glm::dot(across, start), 0};
    candidate.equation.c = glm::dot(start, start) - 1;
    if (!is_in_time(candidate, root, space, "edge's line")) return candidate;
    const double share = glm::dot(space.along * *candidate.t - p, edge) / squared;
    candidate.along = share;
    candidate.squashed_contact = p + edge * share;
    candidate.kept = share >= 0 && share <= 1;
    if (!candidate.kept) {
        reject(candidate, Reason::outside,
               fmt::format("the contact lies beyond {}", corner_names[share < 0 ? index : (index + 1U) % 3]));
    }
    return candidate;
}

Candidate ask_vertex(const Squashed& space, std::uint8_t index, Root root) {
    Candidate candidate;
    candidate.feature = Feature::vertex;
    candidate.index = index;
    candidate.name = fmt::format("vertex {}", corner_names[index]);
    const dvec3 p = space.corners[index];
    candidate.equation = {glm::dot(space.along, space.along), -2 * glm::dot(space.along, p), glm::dot(p, p) - 1};
    if (!is_in_time(candidate, root, space, "corner")) return candidate;
    candidate.squashed_contact = p;
    candidate.kept = true;
    return candidate;
}

void reject_all(MethodTable& table, Reason reason, const std::string& why) {
    for (Candidate& candidate : table.candidates) reject(candidate, reason, why);
}

/// g is the distance to the triangle minus 1, and its slope at START is that of the distance to the nearest point.
void decide_start_in_touch(MethodTable& table, const dvec3& nearest) {
    const bool deeper = glm::dot(-nearest, table.squashed_motion) < 0;
    reject_all(table, Reason::in_touch_at_start, "in touch at START: whether it goes deeper decides");
    if (deeper) table.t = 0;
    table.conclusion = deeper ? "In touch at START and going deeper: a hit at t = 0."
                              : "In touch at START and going no deeper: free to leave, so no hit.";
}

void decide(MethodTable& table) {
    for (std::size_t i = 0; i < table.candidates.size(); ++i) {
        const Candidate& candidate = table.candidates[i];
        if (candidate.kept && (!table.t || *candidate.t < *table.t)) {
            table.t = candidate.t;
            table.answer = i;
        }
    }
    if (!table.answer) {
        table.conclusion = "No candidate is left: no hit, the whole way is free.";
        return;
    }
    const Candidate& first = table.candidates[*table.answer];
    for (Candidate& candidate : table.candidates) {
        if (!candidate.kept) continue;
        const bool is_first = &candidate == &first;
        candidate.reason = is_first ? Reason::first_touch : Reason::later;
        candidate.why =
            is_first ? "the first touch" : fmt::format("later than the {}'s t = {}", first.name, short_text(*first.t));
    }
    table.conclusion = fmt::format("The {} is touched first, at t = {}.", first.name, short_text(*first.t));
}

}  // namespace

MethodTable method_table(const Volume& volume, const Motion& motion, const Triangle& triangle,
                         const MethodOptions& options) {
    // Differences first, so that a place far from the origin loses nothing.
    Squashed space;
    space.corners = {squashed(volume, triangle.a - motion.from), squashed(volume, triangle.b - motion.from),
                     squashed(volume, triangle.c - motion.from)};
    space.along = squashed(volume, motion.to - motion.from);
    if (const auto* sphere = std::get_if<Sphere>(&volume.shape)) space.metres = sphere->radius;

    MethodTable table;
    table.squashed_triangle = {space.corners[0], space.corners[1], space.corners[2]};
    table.squashed_motion = space.along;
    const dvec3 weights = barycentrics({0, 0, 0}, table.squashed_triangle);
    const dvec3 nearest = space.corners[0] * weights.x + space.corners[1] * weights.y + space.corners[2] * weights.z;
    table.gap_at_start = glm::length(nearest) - 1;

    table.candidates[0] = ask_interior(space);
    for (std::uint8_t i = 0; i < 3; ++i) {
        table.candidates[1U + i] = ask_edge(space, i, options.root);
        table.candidates[4U + i] = ask_vertex(space, i, options.root);
    }
    for (Candidate& candidate : table.candidates) {
        if (candidate.squashed_contact)
            candidate.contact = motion.from + unsquashed(volume, *candidate.squashed_contact);
    }
    const dvec3 front = glm::cross(triangle.b - triangle.a, triangle.c - triangle.a);
    if (space.along == dvec3(0, 0, 0)) {
        reject_all(table, Reason::parallel, "nothing moves");
        table.conclusion = "Nothing moves, so nothing comes closer: no hit.";
    } else if (options.one_sided && !(glm::dot(motion.to - motion.from, front) < 0)) {
        reject_all(table, Reason::from_behind, "one-sided, and the motion is not against its front");
        table.conclusion = "A one-sided triangle does not exist for a motion that is not against its front: no hit.";
    } else if (table.gap_at_start <= 0) {
        decide_start_in_touch(table, nearest);
    } else {
        decide(table);
    }
    return table;
}

}  // namespace surefoot::debugger
