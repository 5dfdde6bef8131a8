#include <algorithm>
#include <atomic>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <surefoot/mesh.hpp>
#include <surefoot/ray.hpp>

#include "ieee_guard.hpp"
#include "limits.hpp"
#include "mesh/tree.hpp"
#include "sweep/query.hpp"
#include "sweep/sweep.hpp"

namespace surefoot {
inline namespace v0 {

using namespace internal;

// Counted by hand rather than by shared_ptr: its header alone would be a quarter of what ours cost to compile, and its
// type information, which the core is built without, would be missed by a caller's sanitizers.
struct Mesh::Data {
    mutable std::atomic<std::uint64_t> owners{1};
    std::vector<vec3> vertices;
    std::vector<std::uint32_t> indices;
    std::vector<std::uint32_t> surfaces;
    Tree tree;
    Box3 bounds;

    [[nodiscard]] Triangle triangle(std::uint32_t id) const noexcept {
        const auto corner = [&](std::size_t i) { return dvec3(vertices[indices[3 * std::size_t{id} + i]]); };
        return {corner(0), corner(1), corner(2)};
    }
    [[nodiscard]] std::uint32_t surface(std::uint32_t id) const noexcept { return surfaces.empty() ? 0 : surfaces[id]; }
    [[nodiscard]] std::uint32_t count() const noexcept { return static_cast<std::uint32_t>(indices.size() / 3); }
};

namespace {

// A few thousand times the rounding of a sweep: a box may be visited for nothing, never be passed over.
constexpr double box_margin_share = 0x1p-36;

double magnitude(const Box3& box) noexcept {
    return larger(largest(box.min), largest(box.max));
}

// How far the volume reaches from its reference point along each axis of the world, and a margin.
Vec reach_of(const Volume& volume, const Motion& motion, const Box3& bounds) noexcept {
    const Frame frame(volume.orientation);
    const auto along = [&](const Vec& axis) {
        const Vec local = unit(frame.to_local(axis));
        return larger(reach_against(volume.shape, local), reach_against(volume.shape, -local));
    };
    const double margin = box_margin_share * (size_of(volume.shape) + magnitude(bounds) + norm1(to_vec(motion.from)) +
                                              norm1(to_vec(motion.to)));
    return Vec{along({1, 0, 0}), along({0, 1, 0}), along({0, 0, 1})} + Vec{margin, margin, margin};
}

bool is_before(const Hit& a, const Hit& b) noexcept {
    return a.t != b.t ? a.t < b.t : a.triangle < b.triangle;
}

// Calls `ask(id)` for every triangle whose box the motion may meet before `limit()`, nearest boxes first.
template <typename Ask, typename Limit>
void visit_nearest_first(const Tree& tree, const BoxSweep& boxes, const Ask& ask, const Limit& limit) noexcept {
    struct Entry {
        double t;
        std::uint32_t node;
    };
    Entry stack[Tree::deepest];
    int size = 0;
    if (tree.nodes.empty()) return;
    const double root_entry = boxes.entry(tree.nodes[0].box);
    if (root_entry <= 1) stack[size++] = {root_entry, 0};
    while (size > 0) {
        const Entry entry = stack[--size];
        if (entry.t > limit()) continue;
        const TreeNode& node = tree.nodes[entry.node];
        for (std::uint32_t i = 0; i < node.count; ++i) ask(tree.order[node.first + i]);
        if (node.count > 0) continue;
        Entry near{boxes.entry(tree.nodes[node.first].box), node.first};
        Entry far{boxes.entry(tree.nodes[node.first + 1].box), node.first + 1};
        if (far.t < near.t) std::swap(near, far);
        if (far.t <= 1) stack[size++] = far;
        if (near.t <= 1) stack[size++] = near;
    }
}

Error invalid(std::string text) {
    return {ErrorCode::invalid, std::move(text), {}, 0};
}

}  // namespace

Mesh::Mesh(const Data* data) noexcept : data_(data) {}

Mesh::Mesh(const Mesh& other) noexcept : data_(other.data_) {
    if (data_ != nullptr) data_->owners.fetch_add(1, std::memory_order_relaxed);
}

Mesh::Mesh(Mesh&& other) noexcept : data_(std::exchange(other.data_, nullptr)) {}

Mesh& Mesh::operator=(Mesh other) noexcept {
    std::swap(data_, other.data_);
    return *this;
}

Mesh::~Mesh() {
    if (data_ != nullptr && data_->owners.fetch_sub(1, std::memory_order_acq_rel) == 1) delete data_;
}

Expected<Mesh> Mesh::build(const MeshInput& input) {
    const internal::IeeeGuard guard;
    const std::size_t triangles = input.indices.size() / 3;
    if (input.indices.size() % 3 != 0) {
        return tl::unexpected(invalid("a mesh needs three indices a triangle, but there are " +
                                      std::to_string(input.indices.size()) + " indices"));
    }
    if (triangles > (std::size_t{1} << 31)) {
        return tl::unexpected(Error{ErrorCode::limit, "a mesh holds at most 2^31 triangles: split it", {}, 0});
    }
    if (!input.surfaces.empty() && input.surfaces.size() != triangles) {
        return tl::unexpected(invalid("there are " + std::to_string(input.surfaces.size()) + " surfaces for " +
                                      std::to_string(triangles) + " triangles: give one a triangle, or none"));
    }
    for (std::size_t i = 0; i < input.vertices.size(); ++i) {
        if (!is_valid_point(dvec3(input.vertices[i]))) {
            return tl::unexpected(
                invalid("vertex " + std::to_string(i) +
                        " is not finite or lies beyond 1e9 m: repair it, or bring the level nearer to its origin"));
        }
    }
    for (std::size_t i = 0; i < input.indices.size(); ++i) {
        if (input.indices[i] >= input.vertices.size()) {
            return tl::unexpected(invalid("triangle " + std::to_string(i / 3) + " asks for vertex " +
                                          std::to_string(input.indices[i]) + ", but there are only " +
                                          std::to_string(input.vertices.size()) + " vertices"));
        }
    }

    auto* data = new Data;
    data->vertices.assign(input.vertices.begin(), input.vertices.end());
    data->indices.assign(input.indices.begin(), input.indices.end());
    data->surfaces.assign(input.surfaces.begin(), input.surfaces.end());
    std::vector<Box3> boxes(triangles);
    for (std::uint32_t id = 0; id < triangles; ++id) {
        const Triangle triangle = data->triangle(id);
        boxes[id] = {to_vec(triangle.a), to_vec(triangle.a)};
        boxes[id].include(to_vec(triangle.b));
        boxes[id].include(to_vec(triangle.c));
    }
    data->tree = build_tree(boxes);
    if (!data->tree.nodes.empty()) data->bounds = data->tree.nodes[0].box;
    return Mesh(data);
}

std::optional<Hit> Mesh::sweep(const Volume& volume, const Motion& motion,
                               const MeshQueryOptions& options) const noexcept {
    const internal::IeeeGuard guard;
    if (!is_valid_query(volume, motion)) return blocked(HitStatus::invalid);
    std::optional<Hit> first;
    const auto ask = [&](std::uint32_t id) {
        auto hit = sweep_triangle(volume, motion, data_->triangle(id), id, options.one_sided, options.trace);
        if (hit && (!first || is_before(*hit, *first))) first = hit;
    };
    if (options.search == Search::brute_force) {
        for (std::uint32_t id = 0; id < data_->count(); ++id) ask(id);
    } else {
        const BoxSweep boxes(motion, reach_of(volume, motion, data_->bounds));
        visit_nearest_first(data_->tree, boxes, ask, [&] { return first ? first->t : 1.0; });
    }
    if (first) first->surface = data_->surface(first->triangle);
    return first;
}

std::optional<Hit> Mesh::ray(const Motion& motion, const MeshQueryOptions& options) const noexcept {
    const internal::IeeeGuard guard;
    if (!is_valid_point(motion.from) || !is_valid_point(motion.to)) return blocked(HitStatus::invalid);
    std::optional<Hit> first;
    const auto ask = [&](std::uint32_t id) {
        auto hit = surefoot::ray(motion, data_->triangle(id), {.one_sided = options.one_sided});
        if (!hit) return;
        hit->triangle = id;
        if (!first || is_before(*hit, *first)) first = hit;
    };
    if (options.search == Search::brute_force) {
        for (std::uint32_t id = 0; id < data_->count(); ++id) ask(id);
    } else {
        const double margin =
            box_margin_share * (magnitude(data_->bounds) + norm1(to_vec(motion.from)) + norm1(to_vec(motion.to)));
        const BoxSweep boxes(motion, {margin, margin, margin});
        visit_nearest_first(data_->tree, boxes, ask, [&] { return first ? first->t : 1.0; });
    }
    if (first) first->surface = data_->surface(first->triangle);
    return first;
}

std::size_t Mesh::overlap(const Volume& volume, const dvec3& position, std::span<Overlap> found,
                          const MeshQueryOptions& options) const noexcept {
    const internal::IeeeGuard guard;
    const Motion standing{position, position};
    if (!is_valid_query(volume, standing)) {
        if (!found.empty()) {
            found[0] = Overlap{};
            found[0].status = HitStatus::invalid;
        }
        return 1;
    }
    std::size_t count = 0;
    const auto ask = [&](std::uint32_t id) {
        auto overlap = surefoot::overlap(volume, position, data_->triangle(id), {.one_sided = options.one_sided});
        if (!overlap) return;
        overlap->triangle = id;
        overlap->surface = data_->surface(id);
        // Into its place by id; the last one falls out when there is no more room.
        std::size_t place = std::min(count, found.size());
        while (place > 0 && found[place - 1].triangle > id) {
            if (place < found.size()) found[place] = found[place - 1];
            --place;
        }
        if (place < found.size()) found[place] = *overlap;
        ++count;
    };
    if (options.search == Search::brute_force) {
        for (std::uint32_t id = 0; id < data_->count(); ++id) ask(id);
    } else {
        const BoxSweep boxes(standing, reach_of(volume, standing, data_->bounds));
        visit_nearest_first(data_->tree, boxes, ask, [] { return 1.0; });
    }
    return count;
}

std::size_t Mesh::triangle_count() const noexcept {
    return data_->count();
}

std::size_t Mesh::vertex_count() const noexcept {
    return data_->vertices.size();
}

Bounds Mesh::bounds() const noexcept {
    return {to_dvec3(data_->bounds.min), to_dvec3(data_->bounds.max)};
}

Triangle Mesh::triangle(std::uint32_t id) const noexcept {
    return data_->triangle(id);
}

std::uint32_t Mesh::surface(std::uint32_t id) const noexcept {
    return data_->surface(id);
}

}  // namespace v0
}  // namespace surefoot
