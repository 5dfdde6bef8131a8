#include <algorithm>
#include <cmath>
#include <string>
#include <thread>
#include <utility>

#include <surefoot/mesh.hpp>

#include "ieee_guard.hpp"
#include "limits.hpp"
#include "mesh/data.hpp"
#include "mesh/edges.hpp"
#include "mesh/sections.hpp"
#include "parallel.hpp"

namespace surefoot {
inline namespace v0 {

using namespace internal;

namespace {

Error invalid(std::string text) {
    return {ErrorCode::invalid, std::move(text), {}, 0};
}

Error too_large() {
    return {ErrorCode::limit, "a mesh holds at most 2 GB of triangles, some 80 million: split it", {}, 0};
}

// Whether all numbers are, without saying where one is not: in loops without a way out, which compilers make vectors
// of.
bool all_fine(const MeshInput& input) {
    constexpr auto most = static_cast<float>(largest_coordinate);  // exactly
    unsigned faults = 0;
    for (const vec3& v : input.vertices) {
        faults |=
            (std::abs(v.x) <= most ? 0U : 1U) | (std::abs(v.y) <= most ? 0U : 1U) | (std::abs(v.z) <= most ? 0U : 1U);
    }
    const auto count = static_cast<std::uint32_t>(std::min<std::size_t>(input.vertices.size(), 0xFFFFFFFF));
    for (const std::uint32_t index : input.indices) faults |= index < count ? 0U : 1U;
    return faults == 0;
}

// What is wrong with it, if anything is.
std::optional<Error> fault_in(const MeshInput& input) {
    const std::size_t triangles = input.indices.size() / 3;
    if (input.indices.size() % 3 != 0) {
        return (invalid("a mesh needs three indices a triangle, but there are " + std::to_string(input.indices.size()) +
                        " indices"));
    }
    if (triangles > (std::size_t{1} << 31)) {
        return (Error{ErrorCode::limit, "a mesh holds at most 2^31 triangles: split it", {}, 0});
    }
    if (!input.surfaces.empty() && input.surfaces.size() != triangles) {
        return (invalid("there are " + std::to_string(input.surfaces.size()) + " surfaces for " +
                        std::to_string(triangles) + " triangles: give one a triangle, or none"));
    }
    if (all_fine(input)) return std::nullopt;
    for (std::size_t i = 0; i < input.vertices.size(); ++i) {
        if (!is_valid_point(dvec3(input.vertices[i]))) {
            return (invalid("vertex " + std::to_string(i) +
                            " is not finite or lies beyond 1e9 m: repair it, or bring the level nearer to its origin"));
        }
    }
    for (std::size_t i = 0; i < input.indices.size(); ++i) {
        if (input.indices[i] >= input.vertices.size()) {
            return (invalid("triangle " + std::to_string(i / 3) + " asks for vertex " +
                            std::to_string(input.indices[i]) + ", but there are only " +
                            std::to_string(input.vertices.size()) + " vertices"));
        }
    }
    return std::nullopt;
}

FloatBox box_of(const LeafInput& input, std::uint32_t id) {
    const vec3 a = input.corner(id, 0);
    FloatBox box{{a.x, a.y, a.z}, {a.x, a.y, a.z}};
    for (std::uint32_t i = 1; i < 3; ++i) {
        const vec3 p = input.corner(id, i);
        box.include({{p.x, p.y, p.z}, {p.x, p.y, p.z}});
    }
    return box;
}

std::vector<FloatBox> boxes_of(const LeafInput& input) {
    std::vector<FloatBox> boxes(input.indices.size() / 3);
    for (std::uint32_t id = 0; id < boxes.size(); ++id) boxes[id] = box_of(input, id);
    return boxes;
}

Box3 bounds_of(const FloatBox& whole) {
    return {{whole.min[0], whole.min[1], whole.min[2]}, {whole.max[0], whole.max[1], whole.max[2]}};
}

Box3 bounds_of(std::span<const FloatBox> boxes) {
    if (boxes.empty()) return {};
    FloatBox whole = boxes[0];
    for (const FloatBox& box : boxes) whole.include(box);
    return bounds_of(whole);
}

constexpr std::size_t least_to_share = 4096;  // triangles: fewer are not worth a thread

int building_threads() {
    return static_cast<int>(std::clamp(std::thread::hardware_concurrency(), 1U, 16U));
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
    const IeeeGuard guard;
    if (auto fault = fault_in(input)) return tl::unexpected(std::move(*fault));
    const std::size_t count = input.indices.size() / 3;
    const int threads = count < least_to_share ? 1 : building_threads();
    LeafInput triangles{.vertices = input.vertices, .indices = input.indices};
    std::vector<std::uint8_t> edges;
    BinaryTree binary;
    const auto find_edges = [&] { edges = edge_kinds(input.vertices, input.indices); };
    const auto make_binary = [&] {
        std::vector<TreeItem> items(count);
        in_pieces(count, threads, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                const auto id = static_cast<std::uint32_t>(i);
                items[i] = TreeItem::of(box_of(triangles, id), id, 0);
            }
        });
        if (count != 0) binary = build_binary_tree(std::move(items), threads);
    };
    // The edges are one thread's work, and so is the top of the tree: neither waits for the other.
    if (threads > 1) {
        std::thread other([&] {
            const IeeeGuard own_guard;
            find_edges();
        });
        make_binary();
        other.join();
    } else {
        find_edges();
        make_binary();
    }
    triangles.edges = edges;
    WideTree tree;
    Box3 bounds{};
    if (count != 0) {
        bounds = bounds_of(binary.nodes[0].box);
        tree = collapse(binary, triangles, threads);
    }
    if (tree.too_large) return tl::unexpected(too_large());
    return Mesh(
        Data::from(std::move(tree), {input.surfaces.begin(), input.surfaces.end()}, bounds, input.vertices.size()));
}

Expected<Mesh> Mesh::refit(const MeshInput& moved) const {
    const IeeeGuard guard;
    if (auto fault = fault_in(moved)) return tl::unexpected(std::move(*fault));
    const MeshView& view = data_->view;
    if (moved.indices.size() / 3 != view.triangle_count()) {
        return tl::unexpected(invalid("a refit moves the " + std::to_string(view.triangle_count()) +
                                      " triangles of the mesh, but was given " +
                                      std::to_string(moved.indices.size() / 3) + ": build a new mesh instead"));
    }
    if (const Container* const file = data_->container()) {
        // Queries may read whatever a file holds; this writes where it says.
        if (auto sound = check_structure(view, *file); !sound) return tl::unexpected(std::move(sound.error()));
    }
    const std::vector<std::uint8_t> edges = edge_kinds(moved.vertices, moved.indices);
    const LeafInput triangles{.vertices = moved.vertices, .indices = moved.indices, .edges = edges};
    const std::vector<FloatBox> boxes = boxes_of(triangles);
    WideTree tree = internal::refit(view, triangles, boxes);
    if (tree.too_large) return tl::unexpected(too_large());
    Data* const data =
        Data::from(std::move(tree),
                   moved.surfaces.empty() ? std::vector<std::uint32_t>(view.surfaces.begin(), view.surfaces.end())
                                          : std::vector<std::uint32_t>(moved.surfaces.begin(), moved.surfaces.end()),
                   bounds_of(boxes), moved.vertices.size());
    data->hide_as({view.hidden.begin(), view.hidden.end()});
    return Mesh(data);
}

Expected<Mesh> Mesh::with_hidden(std::span<const std::uint32_t> ids, bool hidden) const {
    const MeshView& view = data_->view;
    std::vector<std::uint64_t> bits(view.hidden.begin(), view.hidden.end());
    bits.resize((std::size_t{view.triangle_count()} + 63) / 64);
    for (const std::uint32_t id : ids) {
        if (id >= view.triangle_count()) {
            return tl::unexpected(invalid("there is no triangle " + std::to_string(id) + " to hide or show, only " +
                                          std::to_string(view.triangle_count())));
        }
        const std::uint64_t bit = std::uint64_t{1} << (id % 64);
        bits[id / 64] = hidden ? bits[id / 64] | bit : bits[id / 64] & ~bit;
    }
    Data* const data = Data::sharing(*data_);
    data->hide_as(std::move(bits));
    return Mesh(data);
}

std::size_t Mesh::triangle_count() const noexcept {
    return data_->view.triangle_count();
}

std::size_t Mesh::vertex_count() const noexcept {
    return data_->view.vertex_count;
}

Bounds Mesh::bounds() const noexcept {
    return {to_dvec3(data_->view.bounds.min), to_dvec3(data_->view.bounds.max)};
}

Triangle Mesh::triangle(std::uint32_t id) const noexcept {
    return data_->view.triangle(id);
}

std::uint32_t Mesh::surface(std::uint32_t id) const noexcept {
    return data_->view.surface(id);
}

bool Mesh::is_hidden(std::uint32_t id) const noexcept {
    return data_->view.is_hidden(id);
}

MeshMemory Mesh::memory() const noexcept {
    const MeshView& view = data_->view;
    return {.nodes = view.nodes.size_bytes(),
            .leaves = view.leaves.size_bytes(),
            .places = view.places.size_bytes(),
            .surfaces = view.surfaces.size_bytes()};
}

}  // namespace v0
}  // namespace surefoot
