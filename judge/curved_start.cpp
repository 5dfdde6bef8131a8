// Cylinder and cone: every normal that can be active is proposed and measured, and those that attain the largest gap
// decide. What is within the band of the largest counts as attaining it.
#include "curved.hpp"
#include "start.hpp"

namespace judge {
namespace {

/// In the frame: exact numbers rounded once, so that cancellation far from the origin costs nothing.
template <class F>
struct RoundedOnce;

template <>
struct RoundedOnce<Big> {
    static Big from(const Dyadic& a) { return Big(a); }
};
template <>
struct RoundedOnce<long double> {
    static long double from(const Dyadic& a) {
        const double high = to_double(a);
        return static_cast<long double>(high) + static_cast<long double>(to_double(a - Dyadic(high)));
    }
};

struct Exactly {
    V3<Dyadic> w[3], d, size;
    Dyadic s;

    Exactly(const Query& query, double t) : size(lift<Dyadic>(query.size)) {
        const Turn<Dyadic> turn(query);
        const V3<Dyadic> from = lift<Dyadic>(query.from), move = lift<Dyadic>(query.to) - from;
        const V3<Dyadic> here = from + scaled(move, Dyadic(t));
        const Vec* corners[3] = {&query.a, &query.b, &query.c};
        for (int i = 0; i < 3; ++i) w[i] = turn.into_frame(here - lift<Dyadic>(*corners[i]));
        d = turn.into_frame(move);
        s = turn.s;
    }
};

template <class F>
V3<F> rounded(const V3<Dyadic>& v) {
    return {RoundedOnce<F>::from(v.x), RoundedOnce<F>::from(v.y), RoundedOnce<F>::from(v.z)};
}

/// `band`: relative to the size of things, what counts as equal; `sure`: below it the long doubles do not decide.
template <class F>
StartSigns decide(const Kind kind, const Exactly& at, double band, bool rigid, double least_gap) {
    const F scale = F(1) / RoundedOnce<F>::from(at.s);
    V3<F> w[3];
    for (int i = 0; i < 3; ++i) w[i] = scaled(rounded<F>(at.w[i]), scale);
    const V3<F> d = scaled(rounded<F>(at.d), scale), size = rounded<F>(at.size);

    CurvedNormals<F> normals(kind, size, d);
    normals.screen(least_gap);
    for (int i = 0; i < 3; ++i) {
        normals.add_corner(w[i]);
        normals.add_edge(w[i], w[(i + 1) % 3]);
    }
    normals.add_face(cross(w[1] - w[0], w[2] - w[0]));
    const auto& found = normals.run();

    F best = found.front().gap;
    for (const auto& c : found)
        if (c.gap > best) best = c.gap;
    F largest = size.x > size.y ? size.x : size.y;
    for (const V3<F>& corner : w) {
        const F reach = length(corner);
        if (reach > largest) largest = reach;
    }
    const F width = F(band) * largest, steep = F(band) * length(d);

    StartSigns signs;
    signs.g = to_double(best);
    signs.depth = best > width ? 1 : (best < -width ? -1 : (rigid ? 0 : unsure));
    bool any = false;
    for (const auto& c : found) {
        if (c.gap < best - width) continue;
        const F rate = dot(c.n, d);
        const int here = rate > steep ? 1 : (rate < -steep ? -1 : (rigid ? 0 : unsure));
        if (here == unsure || (any && !rigid && here != signs.slope)) {
            signs.slope = unsure;
            break;
        }
        signs.slope = any && signs.slope > here ? signs.slope : here;
        any = true;
    }
    return signs;
}

}  // namespace

StartSigns curved_start(const Query& query, double t) {
    const Exactly at(query, t);
    const StartSigns quick = decide<long double>(query.kind, at, 1e-13, false, -HUGE_VAL);
    if (quick.depth != unsure && quick.slope != unsure) return quick;
    double largest_here = std::fmax(query.size.x, query.size.y);
    for (const V3<Dyadic>& w : at.w)
        largest_here = std::fmax(largest_here,
                                 length(V3<double>{to_double(w.x), to_double(w.y), to_double(w.z)}) / to_double(at.s));
    return decide<Big>(query.kind, at, 1e-60, true, quick.g - 1e-9 * largest_here);
}

StartSigns start_signs(const Query& query, double t) {
    return query.kind == Kind::cylinder || query.kind == Kind::cone ? curved_start(query, t) : polytope_start(query, t);
}

}  // namespace judge
