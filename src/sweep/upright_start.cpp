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

UprightStart<double> start_in_doubles(const SweepQuery& query) noexcept {
    ExactVec<double> corners[3];
    for (int i = 0; i < 3; ++i) corners[i] = {query.corners[i].x, query.corners[i].y, query.corners[i].z};
    UprightStart<double> start(corners, {query.along.x, query.along.y, query.along.z},
                               upright_shape<double>(query.shape, 1.0), 0.0);
    start.propose(false);
    return start;
}

// In doubles: plane i counts as one of the nearest when no other is nearer by more than `hair`.
struct Outlook {
    bool decided = false;
    Approach approach = Approach::no_closer;
    bool rims_matter = true;
};

Outlook look_in_doubles(const Volume& volume, const Motion& motion, const Triangle& triangle) noexcept {
    const SweepQuery query(volume, motion, triangle, 0);
    double hair = 64 * query.shape_slack;
    double extent = size_of(query.shape);
    for (int i = 0; i < 3; ++i) {
        hair += 64 * query.corner_slack[i];
        extent += norm1(query.corners[i]);
    }
    // The normal at a rim loses digits where the triangle is much larger than the shape; its gap is trusted that much
    // less.
    const double rim_hair = 0x1p-20 * extent;
    const double rim_slope_hair = 0x1p-20 * norm1(query.along);
    const double slope_hair = 0x1p-40 * norm1(query.along);
    const UprightStart<double> start = start_in_doubles(query);
    const int first_rim = start.first_rim();
    const double nearest = start.largest_gap();

    Outlook outlook;
    bool all_close = true;
    bool all_open = true;
    // An edge nearly parallel to the rims may have lost its climb to rounding.
    bool some_rim = false;
    for (int i = 0; i < 3; ++i) some_rim = some_rim || absolute(query.edge_direction(i).y) < hair;
    for (int i = 0; i < start.count(); ++i) {
        const auto& plane = start.plane(i);
        if (plane.gap < nearest - (i < first_rim ? hair : rim_hair)) continue;
        some_rim = some_rim || i >= first_rim;
        const double flat = i < first_rim ? slope_hair : rim_slope_hair;
        all_close = all_close && plane.approach < -flat;
        all_open = all_open && plane.approach > flat;
    }
    // About the axis all sides are as near; doubles cannot tell whether a corner is there.
    bool on_axis = false;
    for (const Vec& corner : query.corners) {
        on_axis = on_axis || std::sqrt(corner.x * corner.x + corner.z * corner.z) < hair;
    }
    // A motion near the end of the doubles' range has no digits left once it is turned.
    outlook.decided = (all_close || all_open) && !on_axis && norm1(query.along) > 0x1p-900;
    outlook.approach = all_close ? Approach::deeper : Approach::no_closer;
    outlook.rims_matter = some_rim;
    return outlook;
}

Approach decide_in_reals(const Volume& volume, const Motion& motion, const Triangle& triangle,
                         bool skip_rims) noexcept {
    ExactQuery<Real> query(motion, triangle);
    query.turn_into_frame(volume.orientation);
    const UprightShape<Real> shape = upright_shape<Real>(volume.shape, query.scale);

    // What differs by less than 2^-300 of the sizes involved is taken for equal.
    const Real tiny(0x1p-300);
    Real size = shape.radius + shape.height;
    for (const auto& corner : query.corners) size = size + square_root(dot(corner, corner));
    const Real hair = size * tiny;
    const Real slope_hair = square_root(dot(query.along, query.along)) * tiny;
    UprightStart<Real> start(query.corners, query.along, shape, hair);
    start.propose(skip_rims);
    const Real nearest = start.largest_gap();

    if (nearest > hair) {
        // Outside by less than the hair of doubles: a gap that does not close proves a miss.
        for (int i = 0; i < start.count(); ++i) {
            const auto& closing = start.plane(i);
            if (!(closing.gap > hair)) continue;
            if (closing.approach > -slope_hair) return Approach::no_closer;
            for (int j = 0; j < start.count(); ++j) {
                const auto& opening = start.plane(j);
                if (!(opening.approach > slope_hair)) continue;
                const auto across = start.combine(closing, opening);
                if (across.gap > hair && across.approach > -slope_hair) return Approach::no_closer;
            }
        }
        return Approach::deeper;
    }
    for (int i = 0; i < start.count(); ++i) {
        const auto& plane = start.plane(i);
        if (plane.gap > nearest - hair && plane.approach > -slope_hair) return Approach::no_closer;
    }
    return Approach::deeper;
}

}  // namespace

void propose_upright_standing(const SweepQuery& query, Planes& planes) noexcept {
    const UprightStart<double> start = start_in_doubles(query);
    for (int i = 0; i < start.count(); ++i) {
        const auto& normal = start.plane(i).normal;
        planes.consider({normal.x, normal.y, normal.z});
    }
}

Approach upright_approach_at_start(const Volume& volume, const Motion& motion, const Triangle& triangle) noexcept {
    const Outlook outlook = look_in_doubles(volume, motion, triangle);
    if (outlook.decided) return outlook.approach;
    return decide_in_reals(volume, motion, triangle, !outlook.rims_matter);
}

}  // namespace surefoot::internal
