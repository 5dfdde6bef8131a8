#include "sweep/upright_start.hpp"

#include "sweep/candidates.hpp"
#include "sweep/exact_query.hpp"

namespace surefoot::internal {

namespace {

template <typename Scalar>
UprightShape<Scalar> upright_shape(const Shape& shape, const Scalar& scale) noexcept {
    if (const auto* cone = std::get_if<Cone>(&shape)) {
        return {Scalar(cone->radius) * scale, Scalar(cone->height) * scale, true};
    }
    const auto& cylinder = *std::get_if<Cylinder>(&shape);
    return {Scalar(cylinder.radius) * scale, Scalar(cylinder.half_height) * scale, false};
}

// More than the rounding in any gap of the query, and in where its corners are.
double hair_of(const SweepQuery& query) noexcept {
    double hair = 64 * query.shape_slack;
    for (const double slack : query.corner_slack) hair += 64 * slack;
    return hair;
}

// The shape moved on by t.
UprightStart<double> start_in_doubles(const SweepQuery& query, double t) noexcept {
    ExactVec<double> corners[3];
    for (int i = 0; i < 3; ++i) {
        const Vec corner = query.corners[i] - query.along * t;
        corners[i] = {corner.x, corner.y, corner.z};
    }
    UprightStart<double> start(corners, {query.along.x, query.along.y, query.along.z},
                               upright_shape<double>(query.shape, 1.0), hair_of(query));
    start.propose();
    return start;
}

constexpr std::uint32_t bit_of(int slot) noexcept {
    return 1U << slot;
}

constexpr bool is_rim(int slot) noexcept {
    return slot >= UprightSlot::first_edge &&
           (slot - UprightSlot::first_edge) % UprightSlot::per_edge >= UprightSlot::rim;
}

enum class Slope : std::uint8_t { unknown, closing, not_closing };

// What doubles know of a start.
class Outlook {
public:
    Outlook(const SweepQuery& query, const Volume& volume, const Triangle& ordered) noexcept
        : query_(query), hair_(hair_of(query)), extent_(size_of(query.shape)), start_(start_in_doubles(query, 0)) {
        for (const Vec& corner : query.corners) extent_ += norm1(corner);
        least_ = start_.plane(0).gap - hair_;
        for (int i = 0; i < start_.count(); ++i) least_ = larger(least_, start_.plane(i).gap - hair_);
        // A motion near the end of the doubles' range has no digits left once it is turned.
        const double speed = norm1(query.along) > 0x1p-900 ? norm1(query.along) : HUGE_VAL;
        for (int i = 0; i < start_.count(); ++i) {
            const auto& plane = start_.plane(i);
            if (plane.gap + gap_doubt(plane) < least_) continue;
            active_ |= bit_of(plane.slot);
            const double flat = (plane.doubt + 0x1p-40) * speed;
            if (!(plane.approach < -flat)) closing_ &= ~bit_of(plane.slot);
            if (!(plane.approach > flat)) opening_ &= ~bit_of(plane.slot);
        }
        // An edge nearly parallel to the rims may have lost its climb to rounding, but not if the shape stands upright
        // in the world and the corners are as high there.
        const dvec3* world[3] = {&ordered.a, &ordered.b, &ordered.c};
        const bool upright = volume.orientation.x == 0 && volume.orientation.z == 0;
        for (int i = 0; i < 3; ++i) {
            const int next = (i + 1) % 3;
            const double climb = query.corners[next].y - query.corners[i].y;
            const bool is_level = upright && world[i]->y == world[next]->y;
            if (absolute(climb) < hair_ && !is_level) {
                const std::uint32_t rims = bit_of(UprightSlot::of_edge(i, UprightSlot::rim)) |
                                           bit_of(UprightSlot::of_edge(i, UprightSlot::rim + 1));
                active_ |= rims;
                closing_ &= ~rims;
                opening_ &= ~rims;
            }
        }
    }

    [[nodiscard]] std::uint32_t active() const noexcept { return active_; }
    [[nodiscard]] Slope slope(int slot) const noexcept {
        if ((closing_ & bit_of(slot)) != 0) return Slope::closing;
        return (opening_ & bit_of(slot)) != 0 ? Slope::not_closing : Slope::unknown;
    }
    [[nodiscard]] const RimRoots& roots() const noexcept { return start_.roots(); }
    /// A lower bound on the distance.
    [[nodiscard]] double least() const noexcept { return least_; }

    /// Is the shape in touch beyond doubt at the start, or at some time that is tried?
    [[nodiscard]] bool surely_meets() const noexcept {
        if (is_inside(start_)) return true;
        for (const double t : {1.0, 0.5, 0x1p-6, 0x1p-16}) {
            if (is_inside(start_in_doubles(query_, t))) return true;
        }
        return false;
    }

private:
    // On a rim the gap is at its largest, so that a turned normal hardly matters; elsewhere it counts in full.
    [[nodiscard]] double gap_doubt(const UprightStart<double>::Plane& plane) const noexcept {
        return hair_ + (is_rim(plane.slot) ? 0x1p-20 : plane.doubt) * extent_;
    }

    [[nodiscard]] bool is_inside(const UprightStart<double>& start) const noexcept {
        for (int i = 0; i < start.count(); ++i) {
            if (start.plane(i).gap + gap_doubt(start.plane(i)) > 0) return false;
        }
        return true;
    }

    const SweepQuery& query_;
    double hair_;
    double extent_;
    UprightStart<double> start_;
    double least_ = 0;
    std::uint32_t active_ = 0;
    std::uint32_t closing_ = UprightSlot::all;
    std::uint32_t opening_ = UprightSlot::all;
};

// Planes whose normals are made of whole products: the sign of their slope is exact, without a root.
class ExactSlopes {
public:
    ExactSlopes(const Volume& volume, const Motion& motion, const Triangle& triangle) noexcept
        : query_(motion, triangle), is_cone_(std::holds_alternative<Cone>(volume.shape)) {
        query_.turn_into_frame(volume.orientation);
    }

    [[nodiscard]] Slope of(int slot) const noexcept {
        if (slot < UprightSlot::face) return told(query_.along.y, slot == UprightSlot::cap);
        if (slot < UprightSlot::first_edge) {
            return told(dot(query_.face_normal(), query_.along), slot == UprightSlot::face);
        }
        const int edge = (slot - UprightSlot::first_edge) / UprightSlot::per_edge;
        const int which = (slot - UprightSlot::first_edge) % UprightSlot::per_edge;
        if (is_cone_ || which > UprightSlot::side_of_vertex) return Slope::unknown;
        if (which == UprightSlot::side_of_vertex) {
            const auto& corner = query_.corners[edge];
            if (corner.x.sign() == 0 && corner.z.sign() == 0) return Slope::unknown;
            return told(corner.x * query_.along.x + corner.z * query_.along.z, false);
        }
        const auto along = query_.edge(edge);
        return told(along.x * query_.along.z - along.z * query_.along.x, which == UprightSlot::side_of_edge);
    }

private:
    using Number = GameNumber;

    static Slope told(const Number& slope, bool as_it_is) noexcept {
        if (slope.overflowed()) return Slope::unknown;
        return (as_it_is ? slope.sign() : -slope.sign()) < 0 ? Slope::closing : Slope::not_closing;
    }

    ExactQuery<Number> query_;
    bool is_cone_;
};

// In 512-digit reals. What differs by less than 2^-300 of the sizes involved is taken for equal.
class RealStart {
public:
    RealStart(const Volume& volume, const Motion& motion, const Triangle& triangle) noexcept
        : query_(motion, triangle) {
        query_.turn_into_frame(volume.orientation);
        shape_ = upright_shape<Real>(volume.shape, query_.scale);
        const Real tiny(0x1p-300);
        Real size = shape_.radius + shape_.height;
        for (const auto& corner : query_.corners) size = size + square_root(dot(corner, corner));
        hair_ = size * tiny;
        slope_hair_ = square_root(dot(query_.along, query_.along)) * tiny;
    }

    /// Of the planes in `active`, with the slopes that are known. `apart`: none is nearer than some gap.
    [[nodiscard]] Slope slope(std::uint32_t active, const Slope (&slopes)[UprightSlot::count], const RimRoots& roots,
                              bool& apart) const noexcept {
        UprightStart<Real> start(query_.corners, query_.along, shape_, hair_);
        start.propose(active, &roots);
        // What doubles took for on the axis, or for a root, may not be there at all.
        if (start.count() == 0) start.propose();
        const Real least = start.nearest().gap - hair_;
        apart = least > Real(0.0);
        for (int i = 0; i < start.count(); ++i) {
            const auto& plane = start.plane(i);
            if (plane.gap < least) continue;
            const Slope known = slopes[plane.slot];
            if (known == Slope::not_closing) return known;
            if (known == Slope::unknown && plane.approach > -slope_hair_) return Slope::not_closing;
        }
        return Slope::closing;
    }

    /// Does the motion meet the triangle? The gap along a normal is linear in time, so every plane that separates
    /// bounds the times that are left, from below if it closes and from above if it opens.
    [[nodiscard]] bool meets() const noexcept {
        Real low(0.0);
        Real high(1.0);
        Real t(0.0);
        for (int round = 0; round < most_rounds; ++round) {
            ExactVec<Real> corners[3];
            for (int i = 0; i < 3; ++i) corners[i] = query_.corners[i] - query_.along * t;
            UprightStart<Real> start(corners, query_.along, shape_, hair_);
            start.propose();
            const auto& nearest = start.nearest();
            if (!(nearest.gap > hair_)) return true;
            const bool closes = nearest.approach < -slope_hair_;
            if (!closes && !(nearest.approach > slope_hair_)) return false;
            (closes ? low : high) = t - nearest.gap / nearest.approach;
            if (low > high + Real(0x1p-280)) return false;
            t = round % 2 == 1 ? (low + high) * Real(0.5) : (closes ? low : high);
        }
        return true;  // so nearly that it counts
    }

private:
    static constexpr int most_rounds = 200;

    ExactQuery<Real> query_;
    UprightShape<Real> shape_;
    Real hair_;
    Real slope_hair_;
};

}  // namespace

void propose_upright_standing(const SweepQuery& query, Planes& planes) noexcept {
    const UprightStart<double> start = start_in_doubles(query, 0);
    for (int i = 0; i < start.count(); ++i) {
        const auto& normal = start.plane(i).normal;
        planes.consider({normal.x, normal.y, normal.z});
    }
}

Approach upright_approach_at_start(const Volume& volume, const Motion& motion, const Triangle& triangle) noexcept {
    const SweepQuery query(volume, motion, triangle, 0);
    const dvec3* corners[3] = {&triangle.a, &triangle.b, &triangle.c};
    const auto corner = [&](int i) { return *corners[query.original[i]]; };
    const Triangle ordered{corner(0), corner(1), corner(2)};
    const Outlook outlook(query, volume, ordered);
    Slope slopes[UprightSlot::count] = {};
    bool some_closing = false;
    bool some_not_closing = false;
    bool some_unknown = false;
    const auto for_each_active = [&](const auto& ask) {
        some_closing = some_not_closing = some_unknown = false;
        for (int slot = 0; slot < UprightSlot::count; ++slot) {
            if ((outlook.active() & bit_of(slot)) == 0) continue;
            if (slopes[slot] == Slope::unknown) slopes[slot] = ask(slot);
            some_closing = some_closing || slopes[slot] == Slope::closing;
            some_not_closing = some_not_closing || slopes[slot] == Slope::not_closing;
            some_unknown = some_unknown || slopes[slot] == Slope::unknown;
        }
    };
    for_each_active([&](int slot) { return outlook.slope(slot); });
    if (some_unknown) {
        const ExactSlopes exact(volume, motion, ordered);
        for_each_active([&](int slot) { return exact.of(slot); });
    }
    if (!some_unknown && !some_closing) return Approach::no_closer;
    if ((some_unknown || some_not_closing) && outlook.least() <= 0) {
        const RealStart start(volume, motion, ordered);
        bool apart = false;
        const Slope slope = start.slope(outlook.active(), slopes, outlook.roots(), apart);
        if (slope == Slope::not_closing) return Approach::no_closer;
        return !apart || start.meets() ? Approach::deeper : Approach::no_closer;
    }
    if (outlook.surely_meets()) return Approach::deeper;
    return RealStart(volume, motion, ordered).meets() ? Approach::deeper : Approach::no_closer;
}

}  // namespace surefoot::internal
