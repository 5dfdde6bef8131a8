// Any bytes, as the vertices and indices of a mesh and as queries on it: building says yes or why not, and the tree
// answers what brute force answers, to the bit.
#include <algorithm>
#include <array>
#include <bit>
#include <optional>
#include <vector>

#include "bytes.hpp"

namespace {

using namespace fuzz;

bool same_bits(const surefoot::dvec3& a, const surefoot::dvec3& b) {
    const auto bits = [](double value) { return std::bit_cast<std::uint64_t>(value); };
    return bits(a.x) == bits(b.x) && bits(a.y) == bits(b.y) && bits(a.z) == bits(b.z);
}

bool same_bits(const surefoot::Hit& a, const surefoot::Hit& b) {
    return std::bit_cast<std::uint64_t>(a.t) == std::bit_cast<std::uint64_t>(b.t) && same_bits(a.point, b.point) &&
           same_bits(a.normal, b.normal) && a.triangle == b.triangle && a.surface == b.surface && a.body == b.body &&
           a.feature == b.feature && a.status == b.status && a.started_inside == b.started_inside;
}

bool same_bits(const surefoot::Overlap& a, const surefoot::Overlap& b) {
    return same_bits(a.point, b.point) && same_bits(a.normal, b.normal) &&
           std::bit_cast<std::uint64_t>(a.depth) == std::bit_cast<std::uint64_t>(b.depth) && a.triangle == b.triangle &&
           a.surface == b.surface && a.body == b.body && a.feature == b.feature && a.status == b.status;
}

void require_same(const std::optional<surefoot::Hit>& by_tree, const std::optional<surefoot::Hit>& by_force) {
    require(by_tree.has_value() == by_force.has_value(), "tree and brute force both hit or both miss");
    require(!by_tree || same_bits(*by_tree, *by_force), "tree equals brute force, bit for bit");
}

void check_queries(const surefoot::Mesh& mesh, Bytes& bytes) {
    const auto kind = bytes.take<std::uint8_t>();
    const bool raw = (kind & 1) != 0;
    const surefoot::QueryOptions tree{.one_sided = (kind & 2) != 0};
    surefoot::QueryOptions force = tree;
    force.search = surefoot::Search::brute_force;
    const surefoot::Volume volume = bytes.volume(raw);
    const surefoot::Motion motion{bytes.vector(raw), bytes.vector(raw)};

    const auto sweep = [&] { return surefoot::capture_sweep(mesh, volume, motion, tree); };
    const auto ray = [&] { return surefoot::capture_ray(mesh, motion, tree); };
    const surefoot::CapturedQuestion question{.volume = volume, .motion = motion, .one_sided = tree.one_sided};
    const auto bare = [&] { return unasked(mesh, question); };
    const auto bare_ray = [&] {
        return unasked(mesh, {.kind = surefoot::CaptureKind::ray, .motion = motion, .one_sided = question.one_sided});
    };
    {
        const Asking asking(ray, bare_ray);
        require_same(mesh.ray(motion, tree), mesh.ray(motion, force));
    }
    const Asking asking(sweep, bare);
    const auto swept = mesh.sweep(volume, motion, tree);
    require_same(swept, mesh.sweep(volume, motion, force));
    const bool valid = surefoot::is_valid(volume) && is_within_limits(motion);
    require(swept || valid || mesh.triangle_count() == 0, "data outside the limits are no free pass");
    if (swept) require_sound(*swept, valid);

    std::array<surefoot::Overlap, 16> by_tree{};
    std::array<surefoot::Overlap, 16> by_force{};
    const std::size_t count = mesh.overlap(volume, motion.from, by_tree, tree);
    require(count == mesh.overlap(volume, motion.from, by_force, force), "tree and brute force find as many overlaps");
    for (std::size_t i = 0; i < std::min(count, by_tree.size()); ++i)
        require(same_bits(by_tree[i], by_force[i]), "tree equals brute force, bit for bit");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    Bytes bytes({data, size});
    const auto kind = bytes.take<std::uint8_t>();
    const bool raw = (kind & 1) != 0;
    const bool honest = (kind & 2) == 0;  // else indices may lead anywhere
    const std::size_t vertex_count = bytes.take<std::uint8_t>();
    const std::size_t index_count = std::size_t{bytes.take<std::uint8_t>()} * (honest ? 3 : 1);

    std::vector<surefoot::vec3> vertices(vertex_count);
    for (surefoot::vec3& vertex : vertices)
        for (int axis = 0; axis < 3; ++axis)
            vertex[axis] = raw ? bytes.take<float>() : static_cast<float>(bytes.take<std::int8_t>()) * 0.125f;
    std::vector<std::uint32_t> indices(index_count);
    for (std::uint32_t& index : indices) {
        index = honest && vertex_count != 0 ? static_cast<std::uint32_t>(bytes.take<std::uint8_t>() % vertex_count)
                                            : bytes.take<std::uint32_t>();
    }

    const auto mesh = surefoot::Mesh::build({.vertices = vertices, .indices = indices});
    if (!mesh) {
        require(!mesh.error().text.empty(), "an error says what is wrong");
        return 0;
    }
    require(mesh->triangle_count() * 3 == indices.size(), "a mesh keeps every triangle");
    for (int queries = 0; queries < 8 && !bytes.empty(); ++queries) check_queries(*mesh, bytes);
    return 0;
}
