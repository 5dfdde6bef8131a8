// Any bytes as a navigation section: reading says yes or why not, and whatever was read answers every question and
// ends.
#include <array>
#include <vector>

#include <surefoot/navigation_query.hpp>

#include "bytes.hpp"

namespace {

using namespace fuzz;

surefoot::dvec3 place(Bytes& bytes, const surefoot::NavigationQuery& query) {
    // Half of all places are on the mesh, where questions lead somewhere.
    const auto kind = bytes.take<std::uint8_t>();
    if (kind < 128)
        if (const auto point = query.random(kind)) return point->position;
    return bytes.vector(kind >= 250);
}

void require_sound(const surefoot::NavigationPath& path) {
    require(!path.polygons.empty() && path.portals.size() + 1 == path.polygons.size(), "a portal between two polygons");
    require(path.corners.size() >= 2, "a path has two ends");
    require(path.length >= 0 && std::isfinite(path.length), "a path has a length");
    for (const surefoot::NavigationCorner& corner : path.corners)
        require(is_finite(corner.position), "no NaN and no infinity in a path");
}

void ask(const surefoot::NavigationMesh& mesh, Bytes& bytes) {
    surefoot::NavigationQuery query(mesh, 256);
    const surefoot::dvec3 from = place(bytes, query);
    const surefoot::dvec3 to = place(bytes, query);
    static_cast<void>(query.under(from, 2, 2));
    const auto start = query.nearest(from, 3, 3);
    const auto end = query.nearest(to, 3, 3);
    if (!start || !end) return;
    if (const auto path = query.path(*start, *end)) require_sound(*path);
    if (const auto ray = query.ray(*start, to))
        require(ray->t >= 0 && ray->t <= 1 && is_finite(ray->position) && is_finite(ray->normal), "a ray has an end");
    static_cast<void>(query.random_reachable(*start, bytes.take<std::uint8_t>()));
    if (!query.begin_search(*start, *end)) return;
    std::array<surefoot::NavigationSearchNode, 16> nodes{};
    while (query.advance_search(1)) static_cast<void>(query.search_nodes(nodes));
    static_cast<void>(query.finish_search());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    constexpr std::size_t questions = 32;
    if (size < questions) return 0;
    Bytes bytes({data, questions});
    auto mesh = surefoot::NavigationMesh::read(std::as_bytes(std::span(data, size)).subspan(questions));
    if (!mesh) {
        require(!mesh.error().text.empty(), "an error says what is wrong");
        return 0;
    }
    for (int i = 0; i < 2; ++i) ask(*mesh, bytes);
    std::array<surefoot::NavigationOutline, 8> outlines{};
    static_cast<void>(mesh->outlines(outlines));
    require(std::isfinite(mesh->report().area), "ground has a size");
    // What was read can be written, and read again.
    const std::vector<std::byte> again = mesh->to_bytes();
    require(surefoot::NavigationMesh::read(again).has_value(), "what was written can be read");
    if (mesh->set_area(0, bytes.take<std::uint8_t>() % 2 != 0, 2)) ask(*mesh, bytes);
    mesh->take_out(std::array{outlines[0].polygon});
    ask(*mesh, bytes);
    return 0;
}
