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
#include "query/answers.hpp"
#include "query/reach.hpp"
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
    [[nodiscard]] std::optional<Hit> with_surface(std::optional<Hit> hit) const noexcept {
        if (hit) hit->surface = surface(hit->triangle);
        return hit;
    }
    template <typename Ask, typename Limit>
    void visit(const Motion& motion, const Box3& extent, const QueryOptions& options, const Ask& ask,
               const Limit& limit) const noexcept;
    [[nodiscard]] std::uint32_t count() const noexcept { return static_cast<std::uint32_t>(indices.size() / 3); }
};

namespace {

// Every coordinate that takes part in a query on a mesh is at most this.
double magnitude_of(const Motion& motion, const Box3& bounds) noexcept {
    return larger(internal::magnitude_of(motion), internal::magnitude_of(bounds));
}

// Calls `ask(id)` for every triangle whose box the motion may meet before `limit()`, nearest boxes first.
template <typename Ask, typename Limit>
void visit_nearest_first(const Tree& tree, const BoxSweep& boxes, const Ask& ask, const Limit& limit,
                         QueryWork* work) noexcept {
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
        if (work != nullptr) ++work->nodes;
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

// Calls `ask(id)` for the triangles that a query can have to do with: all of them by brute force.
template <typename Ask, typename Limit>
void Mesh::Data::visit(const Motion& motion, const Box3& extent, const QueryOptions& options, const Ask& ask,
                       const Limit& limit) const noexcept {
    const auto ask_filtered = [&](std::uint32_t id) {
        if (options.filter && !options.filter(id, surface(id))) return;
        if (options.work != nullptr) ++options.work->triangles;
        ask(id);
    };
    if (options.search == Search::brute_force) {
        for (std::uint32_t id = 0; id < count(); ++id) ask_filtered(id);
    } else {
        visit_nearest_first(tree, BoxSweep(motion, extent), ask_filtered, limit, options.work);
    }
}

std::optional<Hit> Mesh::sweep(const Volume& volume, const Motion& motion, const QueryOptions& options) const noexcept {
    const internal::IeeeGuard guard;
    if (!is_valid_query(volume, motion)) return blocked(HitStatus::invalid);
    FirstHit first;
    data_->visit(
        motion, extent_of(volume, magnitude_of(motion, data_->bounds)), options,
        [&](std::uint32_t id) {
            first.offer(sweep_triangle(volume, motion, data_->triangle(id), id, options.one_sided, options.trace));
        },
        [&] { return first.limit(); });
    return data_->with_surface(first.get());
}

bool Mesh::sweep_any(const Volume& volume, const Motion& motion, const QueryOptions& options) const noexcept {
    const internal::IeeeGuard guard;
    if (!is_valid_query(volume, motion)) return true;
    bool found = false;
    data_->visit(
        motion, extent_of(volume, magnitude_of(motion, data_->bounds)), options,
        [&](std::uint32_t id) {
            if (found) return;
            found =
                sweep_triangle(volume, motion, data_->triangle(id), id, options.one_sided, options.trace).has_value();
        },
        [&] { return found ? -1.0 : 1.0; });
    return found;
}

std::optional<Hit> Mesh::ray(const Motion& motion, const QueryOptions& options) const noexcept {
    const internal::IeeeGuard guard;
    if (!is_valid_point(motion.from) || !is_valid_point(motion.to)) return blocked(HitStatus::invalid);
    FirstHit first;
    data_->visit(
        motion, extent_of_point(magnitude_of(motion, data_->bounds)), options,
        [&](std::uint32_t id) {
            auto hit = surefoot::ray(motion, data_->triangle(id), {.one_sided = options.one_sided});
            if (hit) hit->triangle = id;
            first.offer(hit);
        },
        [&] { return first.limit(); });
    return data_->with_surface(first.get());
}

bool Mesh::ray_any(const Motion& motion, const QueryOptions& options) const noexcept {
    const internal::IeeeGuard guard;
    if (!is_valid_point(motion.from) || !is_valid_point(motion.to)) return true;
    bool found = false;
    data_->visit(
        motion, extent_of_point(magnitude_of(motion, data_->bounds)), options,
        [&](std::uint32_t id) {
            if (found) return;
            found = surefoot::ray(motion, data_->triangle(id), {.one_sided = options.one_sided}).has_value();
        },
        [&] { return found ? -1.0 : 1.0; });
    return found;
}

std::size_t Mesh::overlap(const Volume& volume, const dvec3& position, std::span<Overlap> found,
                          const QueryOptions& options) const noexcept {
    const internal::IeeeGuard guard;
    const Motion standing{position, position};
    if (!is_valid_query(volume, standing)) {
        if (!found.empty()) {
            found[0] = Overlap{};
            found[0].status = HitStatus::invalid;
        }
        return 1;
    }
    OverlapsInOrder overlaps(found);
    data_->visit(
        standing, extent_of(volume, magnitude_of(standing, data_->bounds)), options,
        [&](std::uint32_t id) {
            auto overlap = surefoot::overlap(volume, position, data_->triangle(id), {.one_sided = options.one_sided});
            if (!overlap) return;
            overlap->triangle = id;
            overlap->surface = data_->surface(id);
            overlaps.add(*overlap);
        },
        [] { return 1.0; });
    return overlaps.count();
}

std::optional<NearestPoint> Mesh::nearest(const dvec3& point, double farthest,
                                          const QueryOptions& options) const noexcept {
    const internal::IeeeGuard guard;
    if (!is_valid_point(point) || !(farthest >= 0)) {
        return NearestPoint{.point = {}, .status = HitStatus::invalid};
    }
    NearestOfAll nearest(point, farthest);
    const double reach = smaller(farthest, 4 * largest_coordinate);
    Box3 extent = extent_of_point(larger(largest(to_vec(point)), internal::magnitude_of(data_->bounds)));
    extent = {extent.min - Vec{reach, reach, reach}, extent.max + Vec{reach, reach, reach}};
    data_->visit(
        Motion{point, point}, extent, options,
        [&](std::uint32_t id) {
            nearest.offer({.triangle = data_->triangle(id), .id = id, .surface = data_->surface(id)});
        },
        [] { return 1.0; });
    return nearest.get();
}

std::size_t Mesh::gather(const Bounds& near, std::span<SourceTriangle> found,
                         const QueryOptions& options) const noexcept {
    const internal::IeeeGuard guard;
    const Box3 box{to_vec(near.min), to_vec(near.max)};
    std::size_t count = 0;
    data_->visit(
        Motion{}, box, options,
        [&](std::uint32_t id) {
            const Triangle triangle = data_->triangle(id);
            if (!box.meets(box_of(triangle))) return;
            if (count < found.size()) found[count] = {.triangle = triangle, .id = id, .surface = data_->surface(id)};
            ++count;
        },
        [] { return 1.0; });
    sort_gathered(found.first(std::min(count, found.size())));
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
