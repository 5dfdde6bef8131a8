/// The question carried into the shape's own frame, times |q|^2 so that no division is needed, and the planes that
/// separate. w is the vector from a corner of the triangle to the reference point; the point w, moving along d, meets
/// the triangle's shape mirrored, K' = -K. (Only the cone is not its own mirror image: its disc now lies *below*.)
#pragma once

#include "vec.hpp"

namespace judge {

template <class N>
struct Frame {
    Kind kind;
    Turn<N> turn;
    V3<N> w[3];
    V3<N> d;
    V3<N> size;  ///< of the shape, times |q|^2

    explicit Frame(const Query& query) : kind(query.kind), turn(query) {
        const V3<N> from = lift<N>(query.from);
        w[0] = turn.into_frame(from - lift<N>(query.a));
        w[1] = turn.into_frame(from - lift<N>(query.b));
        w[2] = turn.into_frame(from - lift<N>(query.c));
        d = turn.into_frame(lift<N>(query.to) - from);
        size = scaled(lift<N>(query.size), turn.s);
    }
};

/// The sign of e - sqrt(q), q >= 0, without the root.
template <class N>
int sign_minus_root(const N& e, const N& q) {
    const int se = sign_of(e);
    if (se < 0) return -1;
    if (se == 1) return sign_of(square(e) - q);
    if (se == 0) {
        const int sq = sign_of(q);
        return sq == 0 ? 0 : (sq == 1 ? -1 : unsure);
    }
    return unsure;
}

/// The smaller of two signs, either of which may be unsure.
inline int least_sign(int a, int b) {
    if (a == -1 || b == -1) return -1;
    if (a == unsure || b == unsure) return unsure;
    return a < b ? a : b;
}

/// The support function of K' is lin + sqrt(root); for the cone the apex, 0, competes with it.
template <class N>
struct Support {
    N lin, root;
    bool apex = false;
};

template <class N>
Support<N> support_of(Kind kind, const V3<N>& size, const V3<N>& n) {
    const auto flat = [&] { return square(size.x) * (square(n.x) + square(n.z)); };
    switch (kind) {
        case Kind::sphere:
            return {N(0.0), square(size.x) * (square(n.x) + square(n.y) + square(n.z))};
        case Kind::ellipsoid:
            return {N(0.0), square(size.x * n.x) + square(size.y * n.y) + square(size.z * n.z)};
        case Kind::capsule:
            return {size.y * abs(n.y), square(size.x) * (square(n.x) + square(n.y) + square(n.z))};
        case Kind::box:
            return {size.x * abs(n.x) + size.y * abs(n.y) + size.z * abs(n.z), N(0.0)};
        case Kind::cylinder:
            return {size.y * abs(n.y), flat()};
        case Kind::cone:
            break;
    }
    return {-(size.y * n.y), flat(), true};
}

/// The signs of the gap along n (of any length but zero) at time 0 and at time t. A gap > 0 separates strictly; the gap
/// is linear in time, so both ends together speak for all times between.
struct GapSigns {
    int at_start = unsure, at_end = unsure;
};

template <class N>
GapSigns gap_signs(const Frame<N>& frame, const V3<N>& n, const N& t) {
    const Support<N> h = support_of(frame.kind, frame.size, n);
    const N step = t * dot(n, frame.d);
    GapSigns signs{1, 1};
    for (const V3<N>& w : frame.w) {
        const N start = dot(n, w);
        const N end = start + step;
        signs.at_start = least_sign(signs.at_start, sign_minus_root(start - h.lin, h.root));
        signs.at_end = least_sign(signs.at_end, sign_minus_root(end - h.lin, h.root));
        if (h.apex) {
            signs.at_start = least_sign(signs.at_start, sign_of(start));
            signs.at_end = least_sign(signs.at_end, sign_of(end));
        }
        if (signs.at_start == -1 || signs.at_end == -1) break;
    }
    return signs;
}

/// Is the point k of the shape's frame (not scaled) in K'? `size` not scaled either. Answers 1 (in, or on the surface),
/// -1 or unsure.
template <class N>
int inside(Kind kind, const V3<N>& size, const V3<N>& k) {
    const auto not_less = [](const N& big, const N& small) {
        const int s = sign_of(big - small);
        return s == 0 ? 1 : s;
    };
    switch (kind) {
        case Kind::sphere:
            return not_less(square(size.x), dot(k, k));
        case Kind::ellipsoid: {
            const N yz = size.y * size.z, xz = size.x * size.z, xy = size.x * size.y;
            return not_less(square(xy * size.z), square(k.x * yz) + square(k.y * xz) + square(k.z * xy));
        }
        case Kind::capsule: {
            const N over = abs(k.y) - size.y;
            const N flat = square(k.x) + square(k.z);
            const int beyond = sign_of(over);
            if (beyond == unsure) return not_less(square(size.x), flat + square(over)) == 1 ? 1 : unsure;
            return not_less(square(size.x), beyond == 1 ? flat + square(over) : flat);
        }
        case Kind::box:
            return least_sign(not_less(size.x, abs(k.x)),
                              least_sign(not_less(size.y, abs(k.y)), not_less(size.z, abs(k.z))));
        case Kind::cylinder:
            return least_sign(not_less(size.y, abs(k.y)), not_less(square(size.x), square(k.x) + square(k.z)));
        case Kind::cone:
            break;
    }
    return least_sign(least_sign(not_less(N(0.0), k.y), not_less(k.y, -size.y)),
                      not_less(square(size.x * k.y), square(size.y) * (square(k.x) + square(k.z))));
}

}  // namespace judge
