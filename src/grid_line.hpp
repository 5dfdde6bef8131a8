// One axis of a regular grid, its coordinates rounded to floats as a mesh would hold them.
#pragma once

#include <cstdint>

#include "rounded.hpp"
#include "vec.hpp"

namespace surefoot::internal {

/// `count` cells side by side, numbered from `first`; cell i goes from at(i) to at(i + 1).
/// Requires: told_apart(), or a search may take as many steps as there are cells.
class GridLine {
public:
    constexpr GridLine() noexcept = default;
    constexpr GridLine(double origin, double step, std::int64_t first, std::int64_t count) noexcept
        : origin_(origin), step_(step), first_(first), end_(first + count) {}

    [[nodiscard]] std::int64_t first() const noexcept { return first_; }
    /// One beyond the last cell.
    [[nodiscard]] std::int64_t end() const noexcept { return end_; }
    [[nodiscard]] std::int64_t count() const noexcept { return end_ - first_; }
    [[nodiscard]] double step() const noexcept { return step_; }
    [[nodiscard]] bool holds(std::int64_t cell) const noexcept { return first_ <= cell && cell < end_; }

    /// A coordinate of the grid or between two of its lines [m]. Never falls as `place` rises, since rounding does not.
    [[nodiscard]] double at(double place) const noexcept { return rounded_to_float(origin_ + step_ * place); }
    [[nodiscard]] double at(std::int64_t place) const noexcept { return at(static_cast<double>(place)); }

    /// The first cell that ends at `low` or beyond, or end() if there is none. Infinity is fine.
    [[nodiscard]] std::int64_t first_reaching(double low) const noexcept {
        std::int64_t cell = near(low);
        while (cell > first_ && at(cell) >= low) --cell;
        while (cell < end_ && at(cell + 1) < low) ++cell;
        return cell;
    }

    /// The last cell that begins at `high` or before, or first() - 1 if there is none. Infinity is fine.
    [[nodiscard]] std::int64_t last_reached(double high) const noexcept {
        std::int64_t cell = near(high);
        while (cell + 1 < end_ && at(cell + 1) <= high) ++cell;
        while (cell >= first_ && at(cell) > high) --cell;
        return cell;
    }

    /// Are any two lines of the grid different floats, and none of them beyond `limit` [m]? A float has 24 bits, so two
    /// lines that are 2^-22 of the coordinate apart are.
    [[nodiscard]] bool told_apart(double limit) const noexcept {
        const double low = absolute(origin_ + step_ * static_cast<double>(first_));
        const double high = absolute(origin_ + step_ * static_cast<double>(end_));
        return step_ > 0 && low <= limit && high <= limit && step_ >= larger(low, high) * 0x1p-22;
    }

private:
    // The cell by division, which rounding may have moved by a cell or so.
    [[nodiscard]] std::int64_t near(double coordinate) const noexcept {
        const double place = (coordinate - origin_) / step_;
        if (!(place > static_cast<double>(first_))) return first_;
        if (!(place < static_cast<double>(end_ - 1))) return end_ - 1;
        const auto cell = static_cast<std::int64_t>(place);
        return static_cast<double>(cell) > place ? cell - 1 : cell;
    }

    double origin_ = 0;
    double step_ = 1;
    std::int64_t first_ = 0;
    std::int64_t end_ = 1;
};

}  // namespace surefoot::internal
