/// What a sweep did on a level: which boxes of the tree it opened and which triangles it tested, in order; the tree
/// against asking every triangle.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <surefoot/hit.hpp>
#include <surefoot/math.hpp>
#include <surefoot/mesh.hpp>
#include <surefoot/query.hpp>
#include <surefoot/shapes.hpp>

namespace surefoot::debugger {

struct SearchRun {
    Search search = Search::tree;
    std::optional<Hit> hit;
    std::vector<SearchStep> steps;  ///< boxes are told by the scalar tree alone
    std::size_t untold = 0;         ///< steps beyond `most_steps`
    std::uint64_t boxes = 0;        ///< opened
    std::uint64_t triangles = 0;    ///< tested
    double seconds = 0;             ///< the shortest of several runs without a log [s]
};

inline constexpr std::size_t most_steps = 200000;

/// One search, logged; `runs` more are timed [>= 1].
[[nodiscard]] SearchRun run_search(const Mesh& mesh, const Volume& volume, const Motion& motion, Search search,
                                   bool one_sided = false, int runs = 5);

struct SearchComparison {
    SearchRun tree;            ///< the fastest way: counts and time; eight boxes at a time
    SearchRun scalar_tree;     ///< the same tree, box by box: what is drawn
    SearchRun brute_force;     ///< every triangle
    bool same_answer = false;  ///< all three, to the last bit of t, and the same triangle
    std::string text;
};

[[nodiscard]] SearchComparison compare_searches(const Mesh& mesh, const Volume& volume, const Motion& motion,
                                                bool one_sided = false);

}  // namespace surefoot::debugger
