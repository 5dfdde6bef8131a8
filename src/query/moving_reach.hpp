// Where and when a query comes by: what a source asks of its boxes before it asks anything of its triangles.
#pragma once

#include <cmath>
#include <limits>

#include <surefoot/math.hpp>

#include "query/reach.hpp"
#include "vec.hpp"

namespace surefoot::internal {

/// The key of a box that a query never meets. Every limit is less.
inline constexpr double never = std::numeric_limits<double>::infinity();

/// Something of a given extent about its reference point, on a straight motion. Keys are times in [0, 1].
/// Requires: an extent with the margin of extent_of, which is far more than the rounding here.
class MovingReach {
public:
    MovingReach(const Motion& motion, const Box3& extent) noexcept
        : low_(to_vec(motion.from) + extent.min),
          high_(to_vec(motion.from) + extent.max),
          along_(to_vec(motion.to) - to_vec(motion.from)),
          per_along_{along_.x == 0 ? 0 : 1 / along_.x, along_.y == 0 ? 0 : 1 / along_.y,
                     along_.z == 0 ? 0 : 1 / along_.z} {}

    /// When it first meets the box, touching included: never later than the truth; `never` if it does not.
    [[nodiscard]] double key(const Box3& box) const noexcept {
        Span span;
        span.clip(box.min.x - high_.x, box.max.x - low_.x, per_along_.x);
        span.clip(box.min.y - high_.y, box.max.y - low_.y, per_along_.y);
        span.clip(box.min.z - high_.z, box.max.z - low_.z, per_along_.z);
        return span.enter <= span.leave ? span.enter : never;
    }

    /// The box around all that it meets between two times.
    [[nodiscard]] Box3 between(double begin, double end) const noexcept {
        Box3 box{low_ + along_ * begin, high_ + along_ * begin};
        box.include(Box3{low_ + along_ * end, high_ + along_ * end});
        return box;
    }
    [[nodiscard]] Box3 whole() const noexcept { return between(0, 1); }

    [[nodiscard]] const Vec& along() const noexcept { return along_; }

    /// The part of [0, 1], as {enter, leave}, in which it meets what lies between two coordinates of one axis.
    struct Span {
        double enter = 0;
        double leave = 1;

        void clip(double to_low, double to_high, double per_along) noexcept {
            if (per_along == 0) {
                if (to_low > 0 || to_high < 0) leave = -1;
                return;
            }
            const double a = to_low * per_along;
            const double b = to_high * per_along;
            enter = larger(enter, smaller(a, b));
            leave = smaller(leave, larger(a, b));
        }
    };
    [[nodiscard]] Span span_in(double Vec::*axis, double low, double high) const noexcept {
        Span span;
        span.clip(low - high_.*axis, high - low_.*axis, per_along_.*axis);
        return span;
    }

private:
    Vec low_;
    Vec high_;
    Vec along_;
    Vec per_along_;  // 0 along an axis on which it does not move
};

/// Everything around a point. Keys are distances [m].
class RoundReach {
public:
    /// `slack`: how much nearer a triangle may turn out to be than the corners of its box say, by rounding [m].
    RoundReach(const dvec3& point, double farthest, double slack) noexcept
        : point_(to_vec(point)), farthest_(farthest), slack_(slack) {}

    /// Never more than the distance of anything in the box.
    [[nodiscard]] double key(const Box3& box) const noexcept {
        const auto outside = [](double low, double at, double high) { return larger(larger(low - at, at - high), 0); };
        const Vec away{outside(box.min.x, point_.x, box.max.x), outside(box.min.y, point_.y, box.max.y),
                       outside(box.min.z, point_.z, box.max.z)};
        return length(away) * (1 - 0x1p-40) - slack_;
    }

    [[nodiscard]] Box3 whole() const noexcept { return within(farthest_); }
    /// The box around everything up to a distance.
    [[nodiscard]] Box3 within(double distance) const noexcept {
        const double reach = distance + slack_;
        return {point_ - Vec{reach, reach, reach}, point_ + Vec{reach, reach, reach}};
    }
    [[nodiscard]] const Vec& point() const noexcept { return point_; }
    [[nodiscard]] double slack() const noexcept { return slack_; }

private:
    Vec point_;
    double farthest_;
    double slack_;
};

}  // namespace surefoot::internal
