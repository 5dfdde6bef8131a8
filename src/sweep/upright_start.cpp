#include "sweep/upright_start.hpp"

#include "sweep/candidates.hpp"
#include "sweep/exact_facets.hpp"
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

UprightStart<double> start_in_doubles(const SweepQuery& query, const Vec& along) noexcept {
    ExactVec<double> corners[3];
    for (int i = 0; i < 3; ++i) corners[i] = {query.corners[i].x, query.corners[i].y, query.corners[i].z};
    UprightStart<double> start(corners, {along.x, along.y, along.z}, upright_shape<double>(query.shape, 1.0),
                               hair_of(query));
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

constexpr bool is_rim_against(int slot, int edge) noexcept {
    return slot == UprightSlot::of_edge(edge, UprightSlot::rim) ||
           slot == UprightSlot::of_edge(edge, UprightSlot::rim + 1);
}

constexpr bool is_about_axis(int slot) noexcept {
    return slot >= UprightSlot::first_edge &&
           (slot - UprightSlot::first_edge) % UprightSlot::per_edge == UprightSlot::about_axis;
}

// Between an ulp of zero and the largest coordinate there is more than 512 digits can tell.
bool is_wide(const Motion& motion, const Triangle& triangle) noexcept {
    DigitSpan coordinates;
    for (const dvec3* point : {&motion.from, &motion.to, &triangle.a, &triangle.b, &triangle.c}) {
        coordinates.include(*point);
    }
    return coordinates.digits() > 340;
}

enum class Slope : std::uint8_t { unknown, closing, not_closing };

// What doubles know of a start.
class Outlook {
public:
    Outlook(const SweepQuery& query, const Volume& volume, const Motion& motion, const Triangle& ordered) noexcept
        : hair_(hair_of(query)), extent_(size_of(query.shape)), start_(start_in_doubles(query, query.along)) {
        for (const Vec& corner : query.corners) extent_ += norm1(corner);
        // A plane that doubles have turned may have a gap that the true one has not; a triangle without area has no
        // face at all.
        const auto surely = [&](const UprightStart<double>::Plane& plane) {
            return plane.gap - (is_rim(plane.slot) ? hair_ : gap_doubt(plane));
        };
        least_ = surely(start_.plane(0));
        for (int i = 0; i < start_.count(); ++i) least_ = larger(least_, surely(start_.plane(i)));
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
        // A triangle as thin as an ulp of zero has a face all the same.
        if (!has_face()) {
            active_ |= face_slots;
            closing_ &= ~face_slots;
            opening_ &= ~face_slots;
        }
        // Nor may such a motion, or a corner by an ulp of zero off the axis, have left a direction for a side.
        const bool has_lost = speed == HUGE_VAL || is_wide(motion, ordered);
        for (int i = 0; i < 3 && has_lost; ++i) {
            if (norm1(query.corners[i] - Vec{0, query.corners[i].y, 0}) > hair_) continue;
            const std::uint32_t sides = bit_of(UprightSlot::of_edge(i, UprightSlot::about_axis)) |
                                        bit_of(UprightSlot::of_edge(i, UprightSlot::side_of_vertex));
            active_ |= sides;
            closing_ &= ~sides;
            opening_ &= ~sides;
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

private:
    static constexpr std::uint32_t face_slots = bit_of(UprightSlot::face) | bit_of(UprightSlot::face + 1);

    [[nodiscard]] bool has_face() const noexcept {
        for (int i = 0; i < start_.count(); ++i) {
            if ((face_slots & bit_of(start_.plane(i).slot)) != 0) return true;
        }
        return false;
    }

    // On a rim the gap is at its largest, so that a turned normal hardly matters; elsewhere it counts in full.
    [[nodiscard]] double gap_doubt(const UprightStart<double>::Plane& plane) const noexcept {
        return hair_ + (is_rim(plane.slot) ? 0x1p-20 : plane.doubt) * extent_;
    }

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
        : query_(motion, triangle),
          radius_(upright_shape<Number>(volume.shape, Number(1.0)).radius),
          is_cone_(std::holds_alternative<Cone>(volume.shape)) {
        query_.turn_into_frame(volume.orientation);
    }

    [[nodiscard]] Slope of(int slot) const noexcept {
        if (slot < UprightSlot::face) return told(query_.along.y, slot == UprightSlot::cap);
        if (slot < UprightSlot::first_edge) {
            return told(dot(query_.face_normal(), query_.along), slot == UprightSlot::face);
        }
        const int edge = (slot - UprightSlot::first_edge) / UprightSlot::per_edge;
        const int which = (slot - UprightSlot::first_edge) % UprightSlot::per_edge;
        const auto along = query_.edge(edge);
        const auto& corner = query_.corners[edge];
        if (which >= UprightSlot::rim) {
            const bool is_upright = along.x.sign() == 0 && along.z.sign() == 0;
            return is_upright && !is_near_axis(corner) ? of_level(edge, false, false) : Slope::unknown;
        }
        if (is_cone_ || which == UprightSlot::about_axis) return Slope::unknown;
        if (which == UprightSlot::side_of_vertex) {
            return corner.x.sign() == 0 && corner.z.sign() == 0 ? Slope::unknown : of_level(edge, false, false);
        }
        return of_level(edge, true, which == UprightSlot::side_of_edge);
    }

    /// Along the level normal across an edge, or along the one away from the axis through its first corner.
    [[nodiscard]] Slope of_level(int edge, bool is_across, bool as_it_is) const noexcept {
        const auto along = query_.edge(edge);
        const auto& corner = query_.corners[edge];
        return is_across ? told(along.x * query_.along.z - along.z * query_.along.x, as_it_is)
                         : told(corner.x * query_.along.x + corner.z * query_.along.z, as_it_is);
    }

private:
    using Number = GameNumber;

    static Slope told(const Number& slope, bool as_it_is) noexcept {
        if (slope.overflowed()) return Slope::unknown;
        return (as_it_is ? slope.sign() : -slope.sign()) < 0 ? Slope::closing : Slope::not_closing;
    }

    // Nearer than where every direction counts, in doubles and in reals.
    [[nodiscard]] bool is_near_axis(const ExactVec<Number>& corner) const noexcept {
        const Number least = Number(0x1p-20) * radius_ * query_.scale;
        const Number apart = exact_absolute(corner.x) + exact_absolute(corner.z) - least;
        return apart.overflowed() || apart.sign() < 0;
    }

    ExactQuery<Number> query_;
    Number radius_;
    bool is_cone_;
};

// In reals. Depths that differ by less than `tie` of the sizes involved are taken for equal, and slopes below 2^-300 of
// the motion for zero: a normal that is turned by an ulp of zero has a depth that no digits here tell.
template <typename Real>
class RealStart {
public:
    RealStart(const Volume& volume, const Motion& motion, const Triangle& triangle, const Real& tie) noexcept
        : query_(motion, triangle) {
        query_.turn_into_frame(volume.orientation);
        shape_ = upright_shape<Real>(volume.shape, query_.scale);
        Real size = shape_.radius + shape_.height;
        for (const auto& corner : query_.corners) size = size + square_root(dot(corner, corner));
        hair_ = size * tie;
        slope_hair_ = square_root(dot(query_.along, query_.along)) * Real(0x1p-300);
    }

    /// Of the nearest of the planes in `active`, with the slopes that are known.
    [[nodiscard]] Slope slope(std::uint32_t active, const Slope (&slopes)[UprightSlot::count], const RimRoots& roots,
                              const ExactSlopes& exact) const noexcept {
        UprightStart<Real> start(query_.corners, query_.along, shape_, hair_);
        start.propose(active, &roots);
        // What doubles took for on the axis, or for a root, may not be there at all.
        if (start.count() == 0) start.propose();
        if (start.nearest().gap > hair_) start.propose_outside();
        const Real least = start.nearest().gap - hair_;
        for (int i = 0; i < start.count(); ++i) {
            const auto& plane = start.plane(i);
            if (plane.gap < least) continue;
            const Slope known = slope_of(start, i, slopes);
            if (known == Slope::not_closing) return known;
            if (known != Slope::unknown || plane.approach < -slope_hair_) continue;
            if (plane.approach > slope_hair_ || level_slope(plane, exact) != Slope::closing) {
                return Slope::not_closing;
            }
        }
        return Slope::closing;
    }

private:
    // A rim or a cone's side whose normal is that of a cap, a face or an upright side but for rounding has its slope.
    static Slope slope_of(const UprightStart<Real>& start, int i, const Slope (&slopes)[UprightSlot::count]) noexcept {
        const auto& plane = start.plane(i);
        Slope known = plane.slot == UprightSlot::outside ? Slope::unknown : slopes[plane.slot];
        if (known != Slope::unknown) return known;
        Real nearest(same_normal);
        for (int k = 0; k < start.count(); ++k) {
            const auto& other = start.plane(k);
            if (other.slot == UprightSlot::outside || slopes[other.slot] == Slope::unknown) continue;
            const ExactVec<Real> apart = other.normal - plane.normal;
            const Real squared = dot(apart, apart);
            if (!(squared < nearest)) continue;
            nearest = squared;
            known = slopes[other.slot];
        }
        return known;
    }

    // A cone's rim may be nearest along a normal that is level but for rounding, across an edge or away from the axis.
    // Where the edge lies along the rim's tangent at its corner, the two are an ulp of zero apart and may have slopes
    // of opposite signs. A rim's normal against an edge is perpendicular to it, and so is the one across.
    [[nodiscard]] Slope level_slope(const typename UprightStart<Real>::Plane& plane,
                                    const ExactSlopes& exact) const noexcept {
        const Real zero(0.0);
        const ExactVec<Real>& normal = plane.normal;
        if (!(normal.y * normal.y < Real(same_normal))) return Slope::unknown;
        Real nearest(same_normal);
        Slope slope = Slope::unknown;
        for (int i = 0; i < 3; ++i) {
            const ExactVec<Real> edge = query_.edge(i);
            const ExactVec<Real>& corner = query_.corners[i];
            for (const bool is_across : {true, false}) {
                const ExactVec<Real> level =
                    is_across ? ExactVec<Real>{-edge.z, zero, edge.x} : ExactVec<Real>{corner.x, zero, corner.z};
                const Real size = square_root(dot(level, level));
                if (size.sign() == 0) continue;
                const bool as_it_is = dot(level, normal).sign() > 0;
                const ExactVec<Real> apart = normal - level * (Real(as_it_is ? 1.0 : -1.0) / size);
                const Real squared = dot(apart, apart);
                const bool is_own = is_across && is_rim_against(plane.slot, i) && squared < Real(same_normal);
                if (!is_own && !(squared < nearest)) continue;
                nearest = squared;
                slope = exact.of_level(i, is_across, as_it_is);
                if (is_own) return slope;
            }
        }
        return slope;
    }

    static constexpr double same_normal = 0x1p-320;  // of two unit normals, squared

    ExactQuery<Real> query_;
    UprightShape<Real> shape_;
    Real hair_;
    Real slope_hair_;
};

}  // namespace

void propose_upright_standing(const SweepQuery& query, const Vec& heading, Planes& planes) noexcept {
    const UprightStart<double> start = start_in_doubles(query, heading);
    for (int i = 0; i < start.count(); ++i) {
        const auto& normal = start.plane(i).normal;
        planes.consider({normal.x, normal.y, normal.z});
        // Of the sides about a corner on the axis, that which the motion closes on the most is as near.
        if (is_about_axis(start.plane(i).slot)) planes.consider({-normal.x, normal.y, -normal.z});
    }
}

Approach upright_approach_at_start(const Volume& volume, const Motion& motion, const Triangle& triangle) noexcept {
    const SweepQuery query(volume, motion, triangle, 0);
    const dvec3* corners[3] = {&triangle.a, &triangle.b, &triangle.c};
    const auto corner = [&](int i) { return *corners[query.original[i]]; };
    const Triangle ordered{corner(0), corner(1), corner(2)};
    const Outlook outlook(query, volume, motion, ordered);
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
    if (!some_unknown && !some_closing) return Approach::no_closer;
    // All that is as near as the nearest closes. If shape and triangle are apart by less than the hair and the motion
    // passes by within it, this is a false hit of the kind that is promised to be rare, and not a miss.
    if (!some_unknown && !some_not_closing) return Approach::deeper;
    const ExactSlopes exact(volume, motion, ordered);
    if (some_unknown) {
        for_each_active([&](int slot) { return exact.of(slot); });
        if (!some_unknown && !some_closing) return Approach::no_closer;
        if (!some_unknown && !some_not_closing) return Approach::deeper;
    }
    const auto slope_with = [&](const auto& start) {
        return start.slope(outlook.active(), slopes, outlook.roots(), exact);
    };
    const WideReal least = WideReal(0x1p-650) * WideReal(0x1p-650);
    const Slope slope = is_wide(motion, triangle)
                            ? slope_with(RealStart<WideReal>(volume, motion, ordered, least))
                            : slope_with(RealStart<Real>(volume, motion, ordered, Real(0x1p-300)));
    return slope == Slope::not_closing ? Approach::no_closer : Approach::deeper;
}

}  // namespace surefoot::internal
