// The triangles that one step may meet, taken out of the world once; then many questions are asked of them.
#pragma once

#include <cstddef>
#include <optional>

#include <surefoot/character_surface.hpp>
#include <surefoot/character_trace.hpp>
#include <surefoot/hit.hpp>
#include <surefoot/query.hpp>
#include <surefoot/shapes.hpp>
#include <surefoot/world.hpp>

#include "character/body.hpp"
#include "character/many_triangles.hpp"
#include "character/separation.hpp"
#include "character/touches.hpp"
#include "query/reach.hpp"
#include "raw_array.hpp"
#include "sweep/query.hpp"
#include "vec.hpp"
#include "world/ask.hpp"

namespace surefoot::internal {

/// What is met within this share of the skin after the first touch is met with it.
inline constexpr double met_together = 0.25;

/// A time is reached for certain at this many times what was worked out for it.
inline constexpr double surely_later = 1 + 1e-9;

class Neighbours;

/// Who was touched, in the user's own numbers.
struct Named {
    std::uint32_t body = 0;  ///< of a neighbour its id
    std::uint32_t triangle = 0;
};

/// Of a thousand triangles that are touched at the same time, are some enough?
enum class Wanted { all, some };

/// What can be met is listed, if there is room: one look at the world for many questions. Where there are too many
/// triangles for that, each question looks at all of them anew, a room full at a time; that is slow, and the answers
/// are the same.
class Surroundings {
public:
    static constexpr std::size_t most = 512;              ///< in the list
    static constexpr std::size_t most_in_reach = 0x8000;  ///< of one question; a bound on its work

    /// `slack`: how far a body may be behind a one-way surface and still have come from its front [m].
    Surroundings(const World& world, const WorldQuery& query, const SurfaceRules& rules, double slack,
                 const Neighbours& neighbours, StepTrace* trace) noexcept
        : world_(world), query_(query), rules_(rules), slack_(slack), neighbours_(neighbours), trace_(trace) {}

    /// For questions beside those of the step: the same world and rules, nothing covered, no trace.
    [[nodiscard]] Surroundings beside() const noexcept {
        return {world_, query_, rules_, slack_, neighbours_, nullptr};
    }

    /// Makes sure that a question about this box can be asked. False if there are more triangles than can be looked at.
    bool cover(const Box3& box) noexcept;

    /// Lists the triangles in a box of which several questions are going to be asked. False, and nothing is listed, if
    /// there are too many for that; then each question covers its own.
    bool cover_if_few(const Box3& box) noexcept;

    /// The same, beside what is listed already.
    void cover_as_well(const Box3& box) noexcept;

    /// Are the triangles in it listed?
    [[nodiscard]] bool covers(const Box3& box) const noexcept;

    /// The one that a touch speaks of. Until something else is covered.
    [[nodiscard]] const SourceTriangle& triangle(std::size_t index) const noexcept { return triangles_[index]; }

    /// Where a triangle is among the listed ones, if it is.
    [[nodiscard]] std::optional<std::size_t> find(const Named& name) const noexcept {
        for (std::size_t i = 0; i < count_ && !are_many_; ++i)
            if (triangles_[i].body == name.body && triangles_[i].id == name.triangle) return i;
        return std::nullopt;
    }

    /// Every triangle's touch on the way from `from` by `motion`, `volume` being moved from `from + shift`. Requires:
    /// the way is covered; `extent` is the box around the volume, relative to `from`.
    void sweep(const Volume& volume, const Vec& shift, const Box3& extent, const Vec& from, const Vec& motion,
               Touches& touches) noexcept;

    /// Calls `visit(triangle)` for those whose own box meets this one.
    template <typename Visit>
    void near(const Box3& box, const Visit& visit) const noexcept {
        if (are_many_) return each_of_many(world_, query_, box, visit);
        for (std::size_t i = 0; i < count_; ++i) {
            if (boxes_[i].meets(box)) visit(triangles_[i]);
        }
    }

    /// The same for the body itself, kept off by its skin, which is what most questions are about: a triangle that a
    /// plane keeps apart from all of the motion is not asked, and one that a plane keeps apart at first only if the
    /// touches before it are not enough.
    void sweep(const Body& body, const Vec& from, const Vec& motion, Touches& touches,
               Wanted wanted = Wanted::all) noexcept;

    /// One of the triangles.
    void ask(std::size_t i, const Volume& volume, const Motion& motion, Touches& touches) const noexcept;

    /// The body has changed.
    void forget_body() noexcept { separated_ = nullptr; }

    /// Calls `visit(triangle)` for those that the body, kept off by its skin or by `less`, which is no more than that,
    /// may overlap at this place.
    template <typename Visit>
    void near_body(const Body& body, const GrownVolume& less, const Vec& position, const Visit& visit) noexcept {
        if (are_many_) return near_body_of_many(body, less, position, visit);
        separate(body, position);
        const Vec moved = position - separated_at_;
        for (std::size_t i = 0; i < count_; ++i) {
            const Separation& apart = separations_[i];
            const double gap = apart.gap + dot(apart.normal, moved);
            if (gap > hair_ || gap + thinner_by(body, less, apart.normal) > hair_) continue;
            visit(triangles_[i]);
        }
    }

    [[nodiscard]] const World& world() const noexcept { return world_; }
    [[nodiscard]] const Neighbours& neighbours() const noexcept { return neighbours_; }
    [[nodiscard]] Named name_of(const Touch& touch) const noexcept;
    [[nodiscard]] SurfaceRule rule_of(std::uint32_t surface) const noexcept { return rules_[surface]; }
    [[nodiscard]] const WorldQuery& query() const noexcept { return query_; }

    /// Tells the trace, if there is one. `make()` returns the record, and is not called otherwise.
    template <typename Make>
    void tell(const Make& make) const noexcept {
        if (trace_ != nullptr) trace_->push(make());
    }

    [[nodiscard]] bool is_traced() const noexcept { return trace_ != nullptr; }

private:
    // How much less `less` reaches against a normal than the body with all of its skin.
    static double thinner_by(const Body& body, const GrownVolume& less, const Vec& normal) noexcept {
        const Vec local = body.frame.to_local(normal);
        return reach_against(body.kept_off.shape, local) - dot(body.shift, normal) -
               (reach_against(less.volume.shape, local) - dot(less.shift, normal));
    }

    static constexpr Box3 nothing{{1, 1, 1}, {-1, -1, -1}};  // no box lies inside of it

    // How much of a gap may be rounding, with numbers as large as these.
    static double hair_of(const Body& body, double largest_number) noexcept;

    // Lists what is in the box, if it fits. How many there are.
    std::size_t list(const Box3& box) noexcept;

    template <typename Visit>
    void near_body_of_many(const Body& body, const GrownVolume& less, const Vec& position,
                           const Visit& visit) const noexcept {
        const Separator separator(body.kept_off.shape, body.frame, position + body.shift);
        each_of_many(world_, query_, body.around(position, {}, 0), [&](const SourceTriangle& triangle) noexcept {
            const Separation apart = separator.from(triangle.triangle);
            const double hair = hair_of(body, larger(largest(position), magnitude_of(box_of(triangle.triangle))));
            if (apart.gap > hair || apart.gap + thinner_by(body, less, apart.normal) > hair) return;
            visit(triangle);
        });
    }
    void sweep_many(const Body& body, const Vec& from, const Vec& motion, Touches& touches, Wanted wanted) noexcept;
    // The triangle is asked and, if it is touched early enough, kept where its touch finds it.
    void ask_one_of_many(const SourceTriangle& triangle, const Volume& volume, const Motion& motion,
                         Touches& touches) noexcept;

    // Finds the planes between the body and the triangles, if it was not done for this body and these triangles.
    void separate(const Body& body, const Vec& position) noexcept;

    const World& world_;
    WorldQuery query_;
    SurfaceRules rules_;
    double slack_;
    const Neighbours& neighbours_;
    StepTrace* trace_;
    std::size_t count_ = 0;
    Box3 covered_ = nothing;
    bool are_many_ = false;  // nothing is listed: each question looks for itself
    RawArray<SourceTriangle, most> triangles_;
    RawArray<Box3, most> boxes_;

    // The planes, and what they were found for.
    const Body* separated_ = nullptr;
    Vec separated_at_;
    double hair_ = 0;  // gaps below this may be rounding [m]
    RawArray<Separation, most> separations_;
};

}  // namespace surefoot::internal
