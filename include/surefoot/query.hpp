/// What every source of triangles (a mesh, a height field, voxels, a world) is asked, and how it answers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <type_traits>

#include <surefoot/bounds.hpp>
#include <surefoot/hit.hpp>
#include <surefoot/math.hpp>
#include <surefoot/trace.hpp>

namespace [[gnu::visibility("default")]] surefoot {
inline namespace v0 {

/// How a query finds its triangles. All give the same bits; the slower ones are the references that prove it.
enum class Search : std::uint8_t {
    tree,         ///< the fastest way there is
    scalar_tree,  ///< the same tree one box at a time, without SIMD and without the float filter
    brute_force,  ///< every triangle is asked
};

/// What can be a filter.
template <typename T>
concept TriangleFilterCallable = std::is_invocable_r_v<bool, const T&, std::uint32_t, std::uint32_t>;

/// Which triangles a query may meet: any callable `bool(std::uint32_t triangle, std::uint32_t surface)`; by default
/// all of them. Non-owning: it must outlive the call it is handed to. It may not throw, and its answer may not depend
/// on the order in which it is asked.
class TriangleFilter {
public:
    constexpr TriangleFilter() noexcept = default;

    template <TriangleFilterCallable Callable>
    requires(!std::is_same_v<Callable, TriangleFilter>) constexpr TriangleFilter(const Callable& callable) noexcept
        : callable_(&callable), call_([](const void* target, std::uint32_t triangle, std::uint32_t surface) -> bool {
              return (*static_cast<const Callable*>(target))(triangle, surface);
          }) {}

    [[nodiscard]] bool operator()(std::uint32_t triangle, std::uint32_t surface) const {
        return call_ == nullptr || call_(callable_, triangle, surface);
    }
    [[nodiscard]] explicit operator bool() const noexcept { return call_ != nullptr; }

private:
    const void* callable_ = nullptr;
    bool (*call_)(const void*, std::uint32_t, std::uint32_t) = nullptr;
};

/// One thing that a search did: it opened a box, or it asked a triangle.
struct SearchStep {
    enum class Kind : std::uint8_t { box, triangle };

    Bounds box{};                ///< what was opened; all zeros for a triangle [m]
    double enters = 0;           ///< what the box was sorted by: for a sweep the time at which its reach gets there
    std::uint32_t triangle = 0;  ///< which triangle was asked; 0 for a box
    Kind kind = Kind::box;
};

/// Writes the steps of a search into the caller's memory until it is full, and counts the ones that found no room.
class SearchLog {
public:
    explicit SearchLog(std::span<SearchStep> room) noexcept : room_(room) {}

    void push(const SearchStep& step) noexcept {
        if (count_ < room_.size()) room_[count_] = step;
        ++count_;
    }

    /// In the order in which they were done.
    [[nodiscard]] std::span<const SearchStep> steps() const noexcept {
        return room_.first(count_ < room_.size() ? count_ : room_.size());
    }

    /// How many steps found no room.
    [[nodiscard]] std::size_t dropped() const noexcept { return count_ < room_.size() ? 0 : count_ - room_.size(); }

    void clear() noexcept { count_ = 0; }

private:
    std::span<SearchStep> room_;
    std::size_t count_ = 0;
};

/// How much work a query was. Counts are added to what is there.
struct QueryWork {
    std::uint64_t nodes = 0;      ///< boxes of the tree that were opened
    std::uint64_t triangles = 0;  ///< triangles whose exact test was asked
    /// What a `Mesh` did, step by step; none by default. Every search tells which triangles it asked; which boxes it
    /// opened is told by `Search::scalar_tree` alone, since the SIMD search opens eight at once. A `World` hands it on
    /// to its meshes, which speak of their own triangles in their own frame; other sources tell nothing.
    SearchLog* log = nullptr;
};

struct QueryOptions {
    bool one_sided = false;  ///< see SweepOptions and OverlapOptions
    Search search = Search::tree;
    Trace* trace = nullptr;     ///< records of every triangle that was tested; none by default
    TriangleFilter filter{};    ///< which triangles exist for this query; all by default
    QueryWork* work = nullptr;  ///< counts, for benchmarks and debuggers; none by default
};

/// The point of a source that is nearest to a given point.
struct NearestPoint {
    dvec3 point{0, 0, 0};             ///< on the triangle [m]
    double distance = 0;              ///< from the given point, to rounding [m, >= 0]
    std::uint32_t triangle = 0;       ///< which triangle; of several as near, the lowest
    std::uint32_t surface = 0;        ///< what that triangle is made of; 0 if nothing was said
    std::uint32_t body = 0;           ///< which body of the world; 0 for a query against one source
    Feature feature = Feature::face;  ///< the part of the triangle that holds `point`
    HitStatus status = HitStatus::ok;
};

static_assert(std::is_trivially_copyable_v<NearestPoint> && sizeof(NearestPoint) == 48);

/// How the surface bends at an edge of a triangle.
enum class EdgeKind : std::uint8_t {
    open,     ///< no other triangle shares it (or more than one does)
    convex,   ///< an outer edge: the other triangle falls away behind this one's plane
    flat,     ///< the other triangle goes on in the same plane, within the cooking tolerance
    concave,  ///< an inner edge: the other triangle rises before this one's plane
};

/// A triangle handed out by a source.
struct SourceTriangle {
    Triangle triangle;
    std::uint32_t id = 0;       ///< the source's own number of it
    std::uint32_t surface = 0;  ///< what it is made of
    std::uint32_t body = 0;     ///< which body of the world; 0 for a query against one source
    EdgeKind edges[3] = {EdgeKind::open, EdgeKind::open, EdgeKind::open};  ///< of ab, bc, ca
    std::uint8_t reserved = 0;
};

static_assert(std::is_trivially_copyable_v<SourceTriangle> && sizeof(SourceTriangle) == 88);

}  // namespace v0
}  // namespace surefoot
