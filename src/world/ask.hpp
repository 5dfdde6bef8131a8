// One body is asked: the question is carried into its frame, and the answer back.
#pragma once

#include <optional>

#include <surefoot/world.hpp>

#include "query/answers.hpp"
#include "world/body.hpp"

namespace surefoot::internal {

/// What the world's options are for one body's source. Must outlive the call that it is handed to.
class SourceOptions {
public:
    SourceOptions(const WorldBody& body, const WorldQuery& query) noexcept : query_(query), body_(body.id) {}

    [[nodiscard]] QueryOptions get() const noexcept {
        QueryOptions options{
            .one_sided = query_.one_sided, .search = query_.search, .trace = query_.trace, .work = query_.work};
        if (query_.triangles) options.filter = TriangleFilter(*this);
        return options;
    }
    /// Does the triangle exist for the query?
    [[nodiscard]] bool operator()(std::uint32_t triangle, std::uint32_t surface) const {
        return query_.triangles(body_, triangle, surface);
    }

private:
    const WorldQuery& query_;
    std::uint32_t body_;
};

/// A volume and its motion as a body sees them; the volume is grown by what was rounded.
struct CarriedQuery {
    Volume volume;
    Motion motion;
    bool within_limits = true;
};

/// Requires: the two stances differ in position only.
[[nodiscard]] CarriedQuery carried(const Volume& volume, const Motion& motion, const Stance& at_begin,
                                   const Stance& at_end) noexcept;

/// The volume with its shape grown, and where its reference point goes for it.
struct GrownVolume {
    Volume volume;
    Vec shift;            ///< of the reference point, in the frame of the volume's orientation's world [m]
    double overhang = 0;  ///< [m]
    bool within_limits = true;
};
[[nodiscard]] GrownVolume grown(const Volume& volume, double by) noexcept;

/// A body that cannot be answered blocks where the motion could first meet it: `entry`.
[[nodiscard]] Hit refused(HitStatus status, const WorldBody& body, double entry) noexcept;

/// The records that were added to a trace since it had `before` turn from the body's frame to the world's.
void turn_records(Trace* trace, std::size_t before, const Stance& stance) noexcept;

/// `volume` null asks a ray. `limit` is the time after which an answer cannot matter any more, `entry` the time at
/// which the motion could first meet the body's box. Requires: a valid volume and motion.
[[nodiscard]] std::optional<Hit> sweep_body(const WorldBody& body, const Volume* volume, const Motion& motion,
                                            const WorldQuery& query, double limit, double entry) noexcept;
[[nodiscard]] bool sweep_body_any(const WorldBody& body, const Volume* volume, const Motion& motion,
                                  const WorldQuery& query, double entry) noexcept;

void overlap_body(const WorldBody& body, const Volume& volume, const dvec3& position, const WorldQuery& query,
                  OverlapsInOrder& overlaps) noexcept;

/// The body's triangles, in the world, whose own box in the body's frame meets the box around `near` there.
[[nodiscard]] std::size_t gather_body(const WorldBody& body, const Box3& near, std::span<SourceTriangle> found,
                                      const WorldQuery& query) noexcept;

}  // namespace surefoot::internal
