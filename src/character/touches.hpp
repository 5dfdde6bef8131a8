// What a body touches on its way, in order of time, found as it is asked for.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include <surefoot/hit.hpp>
#include <surefoot/query.hpp>
#include <surefoot/shapes.hpp>

#include "raw_array.hpp"
#include "vec.hpp"

namespace surefoot::internal {

class Surroundings;

/// One touch on the way of a body.
struct Touch {
    double t = 0;           ///< [0, 1]
    Vec point;              ///< [m]
    Vec normal;             ///< unit, towards the body
    std::size_t index = 0;  ///< which of the surrounding triangles
    Feature feature = Feature::face;
    HitStatus status = HitStatus::ok;
    bool is_neighbour = false;  ///< then `index` is one of the neighbours
};

/// The touches of one move in order of time. Most moves want the first two or three of a dozen: a triangle is asked
/// only when no other can be touched before it.
class Touches {
public:
    static constexpr std::size_t most = 48;
    static constexpr std::size_t most_pending = 512;

    /// Begins a move of this volume; what is put off is asked of `surroundings`, which must not change meanwhile. After
    /// a page was turned only touches that come later than those on it count.
    void begin(const Surroundings& surroundings, const Volume& volume, const Motion& motion) noexcept;

    /// Puts a triangle off: it cannot be touched before `earliest`. Requires: no touch was asked for yet.
    void put_off(std::size_t index, double earliest) noexcept;

    void add(const Touch& touch) noexcept;  // keeps the earliest if there are too many

    /// The time after which there is no room for another touch; beyond 1 as long as there is room.
    [[nodiscard]] double latest() const noexcept { return count_ < most ? 2 : touches_[most - 1].t; }
    /// Were there more touches than there is room for? Then nothing is known of what comes after the last one.
    [[nodiscard]] bool lost_some() const noexcept { return lost_some_; }
    /// Then the same move may be begun again, for those that come after it. False if none were lost.
    [[nodiscard]] bool turn_page() noexcept;
    /// The least number that no triangle's touch has for its index; at most `most`. Requires: as many triangles.
    [[nodiscard]] std::size_t spare_index() const noexcept;

    /// The touch that comes after `place` others; none after the last. Those later than `until` may be missing. What
    /// was returned stays as it is until the next move.
    [[nodiscard]] const Touch* at(std::size_t place, double until = 1) noexcept;

private:
    struct Pending {
        double earliest;
        std::uint32_t index;
    };
    // The order of touches: by time, then by what is touched.
    struct Rank {
        double t;
        bool is_neighbour;
        std::uint32_t body;
        std::uint32_t number;
    };
    static bool comes_before(const Rank& a, const Rank& b) noexcept;
    [[nodiscard]] Rank rank_of(const Touch& touch) const noexcept;
    [[nodiscard]] bool is_before(const Touch& a, const Touch& b) const noexcept;
    static bool comes_later(const Pending& a, const Pending& b) noexcept { return a.earliest > b.earliest; }
    void order_pending() noexcept;
    void ask_earliest() noexcept;

    const Surroundings* surroundings_ = nullptr;
    Volume volume_;
    Motion motion_{};
    std::size_t count_ = 0;
    std::size_t given_ = 0;  // so many were returned, and stay
    std::size_t pending_count_ = 0;
    bool lost_some_ = false;
    std::optional<Rank> after_;      // on the pages before
    std::optional<Rank> page_ends_;  // at the last one here, if the page was turned
    bool is_heap_ = true;            // the pending ones, the earliest first
    RawArray<Touch, most> touches_;
    RawArray<Pending, most_pending> pending_;
};

}  // namespace surefoot::internal
