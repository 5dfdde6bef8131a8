#include "debugger/search_log.hpp"

#include <algorithm>
#include <bit>
#include <chrono>
#include <fmt/format.h>

#include "debugger/equation.hpp"
#include "text.hpp"

namespace surefoot::debugger {

namespace {

double time_of(const Mesh& mesh, const Volume& volume, const Motion& motion, const QueryOptions& options) {
    const auto begin = std::chrono::steady_clock::now();
    static_cast<void>(mesh.sweep(volume, motion, options));
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

bool same(const std::optional<Hit>& a, const std::optional<Hit>& b) {
    if (!a || !b) return a.has_value() == b.has_value();
    return std::bit_cast<std::uint64_t>(a->t) == std::bit_cast<std::uint64_t>(b->t) && a->triangle == b->triangle &&
           a->status == b->status;
}

std::string words_for(const SearchComparison& all) {
    const std::string answer = !all.tree.hit ? "no hit" : fmt::format("t = {}", short_text(all.tree.hit->t));
    return fmt::format("The tree tested {} triangles in {}; all {} take {}. {}: {}.",
                       tools::grouped(all.tree.triangles), tools::duration(all.tree.seconds),
                       tools::grouped(all.brute_force.triangles), tools::duration(all.brute_force.seconds),
                       all.same_answer ? "The same answer" : "THE ANSWERS DIFFER", answer);
}

}  // namespace

SearchRun run_search(const Mesh& mesh, const Volume& volume, const Motion& motion, Search search, bool one_sided,
                     int runs) {
    SearchRun run;
    run.search = search;
    run.steps.resize(std::min(most_steps, 2 * mesh.triangle_count() + 64));
    SearchLog log(run.steps);
    QueryWork work{.log = &log};
    run.hit = mesh.sweep(volume, motion, {.one_sided = one_sided, .search = search, .work = &work});
    run.untold = log.dropped();
    run.boxes = work.nodes;
    run.triangles = work.triangles;
    run.steps.resize(log.steps().size());
    run.seconds = time_of(mesh, volume, motion, {.one_sided = one_sided, .search = search});
    for (int i = 1; i < runs; ++i)
        run.seconds = std::min(run.seconds, time_of(mesh, volume, motion, {.one_sided = one_sided, .search = search}));
    return run;
}

SearchComparison compare_searches(const Mesh& mesh, const Volume& volume, const Motion& motion, bool one_sided) {
    SearchComparison all;
    all.tree = run_search(mesh, volume, motion, Search::tree, one_sided);
    all.scalar_tree = run_search(mesh, volume, motion, Search::scalar_tree, one_sided);
    // Of a very large level once more has to do: every run takes as long as a picture, or longer.
    constexpr std::size_t large = 200000;
    all.brute_force =
        run_search(mesh, volume, motion, Search::brute_force, one_sided, mesh.triangle_count() > large ? 1 : 5);
    all.same_answer = same(all.tree.hit, all.brute_force.hit) && same(all.tree.hit, all.scalar_tree.hit);
    all.text = words_for(all);
    return all;
}

}  // namespace surefoot::debugger
