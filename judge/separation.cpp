#include "separation.hpp"

#include <algorithm>

#include "curved.hpp"

namespace judge {
namespace {

bool is_enough(const GapSigns& signs, bool strict) {
    return signs.at_start == 1 && (signs.at_end == 1 || (!strict && signs.at_end == 0));
}

bool is_refuted(const GapSigns& signs, bool strict) {
    return signs.at_start == -1 || signs.at_start == 0 || signs.at_end == -1 || (strict && signs.at_end == 0);
}

}  // namespace

const Frame<Interval>& Examination::intervals() {
    if (!intervals_) intervals_.emplace(query_);
    return *intervals_;
}

const Frame<Dyadic>& Examination::exactly() {
    if (!exact_) exact_.emplace(query_);
    return *exact_;
}

V3<double> Examination::into_frame(const Vec& n) const {
    const Turn<double> turn(query_);
    const V3<double> v = lift<double>(n);
    return turn.none ? v : scaled(turn.into_frame(v), 1 / turn.s);
}

template <class F>
bool Examination::separates(const V3<F>& n, double t, bool strict) {
    const V3<double> rounded{to_double(n.x), to_double(n.y), to_double(n.z)};
    if (!(std::isfinite(rounded.x) && std::isfinite(rounded.y) && std::isfinite(rounded.z))) return false;
    if constexpr (std::is_same_v<F, double>) {
        const V3<Interval> wide{Interval(n.x), Interval(n.y), Interval(n.z)};
        const GapSigns quick = gap_signs(intervals(), wide, Interval(t));
        if (is_enough(quick, strict)) return true;
        if (is_refuted(quick, strict)) return false;
    }
    return is_enough(gap_signs(exactly(), exact(n), Dyadic(t)), strict);
}

bool Examination::separates_exactly(const V3<Dyadic>& n, double t, bool strict) {
    return is_enough(gap_signs(exactly(), n, Dyadic(t)), strict);
}

/// The corners of what the triangle sweeps over [0, t], seen from the reference point; a triangle alone for t = 0.
template <class F>
static int sweep_corners(const Local<F>& local, double t, V3<F>* corners) {
    for (int i = 0; i < 3; ++i) {
        corners[i] = local.w[i];
        corners[i + 3] = local.w[i] + scaled(local.d, F(t));
    }
    return t > 0 ? 6 : 3;
}

template <class F>
Nearest<F> Examination::nearest(double t, const Local<F>& local) const {
    V3<F> corners[6];
    const int count = sweep_corners(local, t, corners);
    constexpr bool wide = sizeof(F) > sizeof(double);
    return Gjk<F>(local, corners, count).run(wide ? 120 : 40, wide ? 1e-32 : 1e-14);
}

template <class F>
bool Examination::try_direction(const Nearest<F>& found, const Local<F>& local, double t, bool strict) {
    if (found.overlaps) return false;
    V3<F> n = found.v;
    if (query_.kind == Kind::ellipsoid) n = {n.x / local.size.x, n.y / local.size.y, n.z / local.size.z};
    F size = length(n);
    if (!(size > F(0))) return false;
    return separates(scaled(n, F(1) / size), t, strict);
}

bool Examination::find_quickly(const V3<double>* hint, double t, bool strict) {
    if (hint != nullptr && separates(*hint, t, strict)) return true;
    if (query_.kind == Kind::box) return separates(best_box_facet(t), t, strict) || find_facets(intervals(), t, strict);
    return try_direction(nearest(t, local_), local_, t, strict);
}

/// Of the normals below, the one with the largest gap, in doubles.
V3<double> Examination::best_box_facet(double t) const {
    const V3<double> edges[4] = {local_.w[1] - local_.w[0], local_.w[2] - local_.w[1], local_.w[0] - local_.w[2],
                                 local_.d};
    constexpr V3<double> axes[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    V3<double> best = axes[1];
    double most = -HUGE_VAL;
    const auto offer = [&](const V3<double>& n) {
        const double size = length(n);
        if (!(size > 0)) return;
        for (const V3<double>& unit : {scaled(n, 1 / size), scaled(n, -1 / size)}) {
            const double least = std::min(gap(unit, 0), gap(unit, t));
            if (least > most) most = least, best = unit;
        }
    };
    offer(cross(edges[0], edges[1]));
    for (int i = 0; i < 3; ++i) {
        offer(axes[i]);
        offer(cross(edges[i], local_.d));
        for (const V3<double>& e : edges) offer(cross(e, axes[i]));
    }
    return best;
}

/// For a box these are all the normals there can be (the facets of prism + box); for the others, those of the flat
/// parts of the prism, which no rounded normal can match when they touch exactly.
template <class N>
bool Examination::find_facets(const Frame<N>& frame, double t, bool strict) {
    const V3<N> edges[4] = {frame.w[1] - frame.w[0], frame.w[2] - frame.w[1], frame.w[0] - frame.w[2], frame.d};
    const V3<N> axes[3] = {{N(1.0), N(0.0), N(0.0)}, {N(0.0), N(1.0), N(0.0)}, {N(0.0), N(0.0), N(1.0)}};
    const auto both = [&](const V3<N>& n) {
        return is_enough(gap_signs(frame, n, N(t)), strict) || is_enough(gap_signs(frame, -n, N(t)), strict);
    };
    if (both(cross(edges[0], edges[1]))) return true;
    for (int i = 0; i < 3; ++i)
        if (both(cross(edges[i], frame.d))) return true;
    if (query_.kind == Kind::sphere || query_.kind == Kind::ellipsoid) return false;
    for (int i = 0; i < 3; ++i) {
        if (query_.kind != Kind::box && i != 1) continue;
        if (query_.kind != Kind::capsule && both(axes[i])) return true;
        for (const V3<N>& e : edges)
            if (both(cross(e, axes[i]))) return true;
    }
    return false;
}

/// A corner of the prism that the triangle sweeps, less a corner of the core; squashed for an ellipsoid.
V3<Dyadic> Examination::corner_exactly(int corner, int mate, double t) {
    const Frame<Dyadic>& frame = exactly();
    V3<Dyadic> p = frame.w[corner % 3];
    if (corner >= 3) p = p + scaled(frame.d, Dyadic(t));
    if (query_.kind == Kind::capsule) p.y = p.y + (mate != 0 ? -frame.size.y : frame.size.y);
    if (query_.kind == Kind::ellipsoid) {
        const V3<Dyadic> r = lift<Dyadic>(query_.size);
        p = {p.x * (r.y * r.z), p.y * (r.x * r.z), p.z * (r.x * r.y)};
    }
    return p;
}

/// The normal towards the point, line or plane that these corners span, in exact numbers.
bool Examination::try_span(const V3<Dyadic>* p, int count, double t, bool strict) {
    V3<Dyadic> n = p[0];
    if (count == 2) {
        const V3<Dyadic> e = p[1] - p[0];
        n = scaled(p[0], dot(e, e)) - scaled(e, dot(p[0], e));
    } else if (count == 3) {
        n = cross(p[1] - p[0], p[2] - p[0]);
        if (sign_of(dot(n, p[0])) < 0) n = -n;
    }
    if (query_.kind == Kind::ellipsoid) {
        const V3<Dyadic> r = lift<Dyadic>(query_.size);
        n = {n.x * (r.y * r.z), n.y * (r.x * r.z), n.z * (r.x * r.y)};
    }
    return is_enough(gap_signs(exactly(), n, Dyadic(t)), strict);
}

/// Ball-like shapes: from the corners that span the nearest point.
bool Examination::find_spanned(const Nearest<Quad>& found, double t, bool strict) {
    if (found.overlaps) return false;
    V3<Dyadic> p[3];
    const int count = std::min(found.count, 3);
    for (int i = 0; i < count; ++i) p[i] = corner_exactly(found.corner[i], found.mate[i], t);
    return try_span(p, count, t, strict);
}

/// Ball-like shapes and an apex, when even wide floats cannot tell corners apart (an ulp of an ulp, or of zero): all
/// there are.
bool Examination::find_any_spanned(double t, bool strict) {
    const int mates = query_.kind == Kind::capsule ? 2 : 1, count = 6 * mates;
    V3<Dyadic> all[12];
    for (int i = 0; i < count; ++i) all[i] = corner_exactly(i / mates, i % mates, t);
    for (int i = 0; i < count; ++i) {
        if (try_span(&all[i], 1, t, strict)) return true;
        for (int j = i + 1; j < count; ++j) {
            const V3<Dyadic> two[2] = {all[i], all[j]};
            if (try_span(two, 2, t, strict)) return true;
            for (int k = j + 1; k < count; ++k) {
                const V3<Dyadic> three[3] = {all[i], all[j], all[k]};
                if (try_span(three, 3, t, strict)) return true;
            }
        }
    }
    return false;
}

/// Cylinder and cone: the normals along which they can be nearest to the prism that the triangle sweeps.
template <class F>
bool Examination::find_curved(const Local<F>& local, double t, bool strict) {
    CurvedNormals<F> normals(query_.kind, local.size, local.d);
    V3<F> corners[6];
    const int count = sweep_corners(local, t, corners);
    for (int i = 0; i < count; ++i) normals.add_corner(corners[i]);
    for (int i = 0; i < 3; ++i) {
        const int next = (i + 1) % 3;
        normals.add_edge(corners[i], corners[next]);
        if (count < 6) continue;
        normals.add_edge(corners[i + 3], corners[next + 3]);
        normals.add_edge(corners[i], corners[i + 3]);
        normals.add_face(cross(corners[next] - corners[i], local.d));
    }
    normals.add_face(cross(corners[1] - corners[0], corners[2] - corners[0]));
    auto found = normals.run();
    const std::size_t tries = std::min<std::size_t>(found.size(), 6);
    std::partial_sort(found.begin(), found.begin() + static_cast<std::ptrdiff_t>(tries), found.end(),
                      [](const auto& a, const auto& b) { return a.gap > b.gap; });
    for (std::size_t i = 0; i < tries; ++i)
        if (separates(found[i].n, t, strict)) return true;
    return false;
}

bool Examination::find_thoroughly(double t, bool strict) {
    if (query_.kind == Kind::box) return find_facets(exactly(), t, strict);
    const bool curved = query_.kind == Kind::cylinder || query_.kind == Kind::cone;
    if (find_facets(exactly(), t, strict) || (curved && find_curved(local_, t, strict))) return true;
    const Local<Quad> local(query_);
    const Nearest<Quad> found = nearest(t, local);
    if (try_direction(found, local, t, strict)) return true;
    if (curved && find_curved(local, t, strict)) return true;
    if (query_.kind == Kind::cone) return find_any_spanned(t, strict);  // against the apex
    if (curved) return false;
    return find_spanned(found, t, strict) || find_any_spanned(t, strict);
}

double Examination::support(const V3<double>& n) const {
    const V3<double>& s = local_.size;
    const auto flat = [&] { return s.x * std::sqrt(n.x * n.x + n.z * n.z); };
    switch (query_.kind) {
        case Kind::sphere:
            return s.x * length(n);
        case Kind::ellipsoid:
            return length(V3<double>{s.x * n.x, s.y * n.y, s.z * n.z});
        case Kind::capsule:
            return s.y * std::fabs(n.y) + s.x * length(n);
        case Kind::box:
            return s.x * std::fabs(n.x) + s.y * std::fabs(n.y) + s.z * std::fabs(n.z);
        case Kind::cylinder:
            return s.y * std::fabs(n.y) + flat();
        case Kind::cone:
            break;
    }
    return std::max(0.0, flat() - s.y * n.y);
}

double Examination::gap(const V3<double>& n, double t) const {
    const double low = std::min({dot(n, local_.w[0]), dot(n, local_.w[1]), dot(n, local_.w[2])});
    return (low + t * dot(n, local_.d) - support(n)) / length(n);
}

template bool Examination::separates<double>(const V3<double>&, double, bool);
template Nearest<double> Examination::nearest<double>(double, const Local<double>&) const;

}  // namespace judge
