#include <surefoot/visited_source.hpp>

#include "query/ask.hpp"

namespace surefoot {
inline namespace v0 {

using namespace internal;

namespace {

Bounds to_bounds(const Box3& box) noexcept {
    return {to_dvec3(box.min), to_dvec3(box.max)};
}

/// A sink that calls `take`, which must outlive it.
template <typename Take>
TriangleSink sink_of(const Take& take) noexcept {
    return {const_cast<Take*>(&take),
            [](void* target, const SourceTriangle& found) noexcept { (*static_cast<const Take*>(target))(found); }};
}

}  // namespace

class VisitedSource::Finder {
public:
    static constexpr bool trusted = false;

    explicit Finder(const VisitedSource& source) noexcept : source_(source), bounds_(source.bounds()) {}

    [[nodiscard]] Box3 box() const noexcept { return {to_vec(bounds_.min), to_vec(bounds_.max)}; }

    template <typename Ask>
    void find_all(const Ask& ask) const noexcept {
        source_.visit_(source_.mine_, bounds_, sink_of(ask));
    }

    template <typename Ask, typename Limit>
    void find(const MovingReach& reach, const Ask& ask, const Limit& limit, QueryWork* work) const noexcept {
        const std::uint32_t pieces = pieces_of(reach);
        // Keys are rounded, so a triangle whose box the reach just touches may be found a hair away from there.
        const double slack = 0x1p-44 * (magnitude_of(reach.whole()) + magnitude_of(box()));
        const auto time = [pieces](std::uint32_t piece) { return static_cast<double>(piece) / pieces; };
        for (std::uint32_t piece = 0; piece < pieces && time(piece) <= limit(); ++piece) {
            if (work != nullptr) ++work->nodes;
            const double begin = time(piece);
            const double end = time(piece + 1);
            const bool last = piece + 1 == pieces;
            const auto ask_of_this_piece = [&](const SourceTriangle& found) noexcept {
                // What is no triangle has no key to be judged by; it is asked at once, and blocks.
                if (!is_valid_triangle(found.triangle)) return ask(found);
                const double key = reach.key(box_of(found.triangle));
                // What is met in another piece is asked there.
                if (key >= begin && (key < end || (last && key <= end)) && key <= limit()) ask(found);
            };
            Box3 near = reach.between(begin, end);
            near = {near.min - Vec{slack, slack, slack}, near.max + Vec{slack, slack, slack}};
            source_.visit_(source_.mine_, to_bounds(near), sink_of(ask_of_this_piece));
        }
    }

    template <typename Ask, typename Limit>
    void find(const RoundReach& reach, const Ask& ask, const Limit& limit, QueryWork* work) const noexcept {
        const auto ask_if_near = [&](const SourceTriangle& found) noexcept {
            if (reach.key(box_of(found.triangle)) <= limit()) ask(found);
        };
        // Look nearby first: what is found there says how far one has to look at all. Asking again changes nothing.
        const double everything = limit();
        const Box3 around = box();
        double distance = larger(reach.key(around), larger(largest(around.max - around.min) * 0x1p-10, reach.slack()));
        for (;; distance *= 4) {
            if (work != nullptr) ++work->nodes;
            const bool all = !(distance < smaller(everything, 16 * largest_coordinate));
            source_.visit_(source_.mine_, to_bounds(all ? reach.whole() : reach.within(distance)),
                           sink_of(ask_if_near));
            if (all || limit() <= distance) return;
        }
    }

private:
    /// As many that the boxes of the pieces are about as long as the shape's own, at most 32.
    static std::uint32_t pieces_of(const MovingReach& reach) noexcept {
        const Vec start = reach.between(0, 0).max - reach.between(0, 0).min;
        const double pieces = largest(reach.along()) / larger(4 * largest(start), 0x1p-1000);
        return pieces < 1 ? 1 : (pieces < 32 ? static_cast<std::uint32_t>(pieces) + 1 : 32);
    }

    const VisitedSource& source_;
    Bounds bounds_;
};

std::optional<Hit> VisitedSource::sweep(const Volume& volume, const Motion& motion,
                                        const QueryOptions& options) const noexcept {
    return ask_sweep(Finder(*this), volume, motion, options);
}

bool VisitedSource::sweep_any(const Volume& volume, const Motion& motion, const QueryOptions& options) const noexcept {
    return ask_sweep_any(Finder(*this), volume, motion, options);
}

std::optional<Hit> VisitedSource::ray(const Motion& motion, const QueryOptions& options) const noexcept {
    return ask_ray(Finder(*this), motion, options);
}

bool VisitedSource::ray_any(const Motion& motion, const QueryOptions& options) const noexcept {
    return ask_ray_any(Finder(*this), motion, options);
}

std::size_t VisitedSource::overlap(const Volume& volume, const dvec3& position, std::span<Overlap> found,
                                   const QueryOptions& options) const noexcept {
    return ask_overlap(Finder(*this), volume, position, found, options);
}

std::optional<NearestPoint> VisitedSource::nearest(const dvec3& point, double farthest,
                                                   const QueryOptions& options) const noexcept {
    return ask_nearest(Finder(*this), point, farthest, options);
}

std::size_t VisitedSource::gather(const Bounds& near, std::span<SourceTriangle> found,
                                  const QueryOptions& options) const noexcept {
    return ask_gather(Finder(*this), near, found, options);
}

}  // namespace v0
}  // namespace surefoot
