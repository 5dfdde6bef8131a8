// Upper bounds on a distance: a point of the triangle (by its weights, so it lies in it exactly) and a point of the
// shape (checked to lie in it exactly), both of rational coordinates, and the distance between them.
#include <algorithm>
#include <limits>

#include "separation.hpp"

namespace judge {
namespace {

/// The point of K' nearest to p, about.
V3<double> nearest_of_ellipsoid(const V3<double>& r, const V3<double>& p) {
    const double parts[3] = {p.x, p.y, p.z}, radii[3] = {r.x, r.y, r.z};
    const auto excess = [&](double lambda) {
        double sum = -1;
        for (int i = 0; i < 3; ++i) {
            const double u = radii[i] * parts[i] / (radii[i] * radii[i] + lambda);
            sum += u * u;
        }
        return sum;
    };
    if (excess(0) <= 0) return p;
    // `excess` falls and is convex: Newton from the left never overshoots.
    double lambda = 0;
    for (int step = 0; step < 60; ++step) {
        double slope = 0;
        for (int i = 0; i < 3; ++i) {
            const double under = radii[i] * radii[i] + lambda, u = radii[i] * parts[i] / under;
            slope -= 2 * u * u / under;
        }
        const double next = lambda - excess(lambda) / slope;
        if (!(next > lambda)) break;
        lambda = next;
    }
    double k[3];
    for (int i = 0; i < 3; ++i) k[i] = parts[i] * radii[i] * radii[i] / (radii[i] * radii[i] + lambda);
    return {k[0], k[1], k[2]};
}

V3<double> nearest_of_cone(double radius, double height, const V3<double>& p) {
    const double flat = std::sqrt(p.x * p.x + p.z * p.z);
    if (flat == 0) return {0, std::clamp(p.y, -height, 0.0), 0};  // on the axis, but for numbers whose squares vanish
    const double ux = p.x / flat, uz = p.z / flat;
    if (p.y <= 0 && p.y >= -height && height * flat <= -radius * p.y) return p;
    // On the disc or on the line from the apex to the rim.
    const double disc = std::min(flat, radius);
    const double along = std::clamp((flat * radius - p.y * height) / (radius * radius + height * height), 0.0, 1.0);
    const auto squared = [](double x, double y) { return x * x + y * y; };
    const bool on_disc = squared(flat - disc, p.y + height) < squared(flat - along * radius, p.y + along * height);
    const double rho = on_disc ? disc : along * radius;
    return {rho * ux, on_disc ? -height : -along * height, rho * uz};
}

V3<double> nearest_of_shape(Kind kind, const V3<double>& s, const V3<double>& p) {
    const auto ball = [](const V3<double>& v, double r) {
        const double size = length(v);
        return size > r ? scaled(v, r / size) : v;
    };
    switch (kind) {
        case Kind::sphere:
            return ball(p, s.x);
        case Kind::ellipsoid:
            return nearest_of_ellipsoid(s, p);
        case Kind::capsule: {
            const V3<double> middle{0, std::clamp(p.y, -s.y, s.y), 0};
            return middle + ball(p - middle, s.x);
        }
        case Kind::box:
            return {std::clamp(p.x, -s.x, s.x), std::clamp(p.y, -s.y, s.y), std::clamp(p.z, -s.z, s.z)};
        case Kind::cylinder: {
            const V3<double> flat = ball({p.x, 0, p.z}, s.x);
            return {flat.x, std::clamp(p.y, -s.y, s.y), flat.z};
        }
        case Kind::cone:
            break;
    }
    return nearest_of_cone(s.x, s.y, p);
}

/// Drawn in by a few ulps, so that rounding cannot leave it outside. (A box needs none: clamping is exact.)
V3<double> drawn_in(Kind kind, const V3<double>& s, const V3<double>& k) {
    constexpr double less = 1 - 4e-15;
    switch (kind) {
        case Kind::sphere:
        case Kind::ellipsoid:
            return scaled(k, less);
        case Kind::capsule: {
            const V3<double> middle{0, std::clamp(k.y, -s.y, s.y), 0};
            const double slender = std::max(1.0, s.y / s.x);  // k.y is rounded to an ulp of the height
            return middle + scaled(k - middle, 1 - 4e-15 * slender);
        }
        case Kind::box:
            return k;
        case Kind::cylinder:
        case Kind::cone:
            break;
    }
    return {k.x * less, k.y, k.z * less};
}

/// The weights of b and c, such that with that of a they are exactly three weights >= 0 that add up to one.
void clamp_weights(double& b, double& c) {
    b = b > 0 ? std::min(b, 1.0) : 0;
    c = c > 0 ? std::min(c, 1.0) : 0;
    const double sum = b + c;
    if (sum <= 1 - 0x1p-52 || b == 0 || c == 0) return;
    b = b / sum * (1 - 0x1p-50);
    c = c / sum * (1 - 0x1p-50);
}

template <class N>
V3<N> blend(const V3<N>* w, const N& b, const N& c) {
    return w[0] + scaled(w[1] - w[0], b) + scaled(w[2] - w[0], c);
}

}  // namespace

double Examination::reach(double t, double weight_b, double weight_c) {
    clamp_weights(weight_b, weight_c);
    const Query& q = query_;
    const V3<double> near = blend(local_.w, weight_b, weight_c) + scaled(local_.d, t);
    const V3<double> k = drawn_in(q.kind, local_.size, nearest_of_shape(q.kind, local_.size, near));
    const auto lifted = [&](auto zero) {
        using N = decltype(zero);
        return V3<N>{N(k.x), N(k.y), N(k.z)};
    };
    if (!(std::isfinite(k.x) && std::isfinite(k.y) && std::isfinite(k.z))) {
        return std::numeric_limits<double>::infinity();
    }
    if (inside(q.kind, lift<Interval>(q.size), lifted(Interval(0.0))) != 1 &&
        inside(q.kind, lift<Dyadic>(q.size), lifted(Dyadic(0.0))) != 1)
        return std::numeric_limits<double>::infinity();
    const Frame<Interval>& frame = intervals();
    const V3<Interval> apart = blend(frame.w, Interval(weight_b), Interval(weight_c)) + scaled(frame.d, Interval(t)) -
                               scaled(lifted(Interval(0.0)), frame.turn.s);
    const Interval squared = square(apart.x) + square(apart.y) + square(apart.z);
    return std::sqrt(squared.high()) / frame.turn.s.low() * (1 + 1e-15);
}

template <class F>
double Examination::reach_by_search(const Local<F>& local, double t, int steps) {
    Local<F> there = local;
    for (V3<F>& w : there.w) w = w + scaled(there.d, F(t));
    const Nearest<F> found = Gjk<F>(there, there.w, 3).run(steps, 1e-15);
    double weights[3] = {0, 0, 0};
    double total = 0;
    for (int i = 0; i < found.count; ++i) {
        weights[found.corner[i]] += to_double(found.weight[i]);
        total += to_double(found.weight[i]);
    }
    if (!(total > 0)) weights[0] = total = 1;
    return reach(t, weights[1] / total, weights[2] / total);
}

double Examination::reach(double t, double allowed) {
    const double quick = reach_by_search(local_, t, 60);
    return quick <= allowed ? quick : std::min(quick, reach_by_search(Local<Quad>(query_), t, 200));
}

bool Examination::overlaps_within(double t) {
    // The point that a search finds may lie on the very surface; in a slightly smaller shape it lies well inside.
    for (const double shrink : {0.5, 0.99, 0.999999, 1.0}) {
        Local<double> local = local_;
        local.size = scaled(local.size, shrink);
        V3<double> corners[6];
        for (int i = 0; i < 3; ++i) {
            corners[i] = local.w[i];
            corners[i + 3] = local.w[i] + scaled(local.d, t);
        }
        const Nearest<double> found = Gjk<double>(local, corners, 6).run(60, 1e-15);
        double weights[3] = {0, 0, 0};
        double total = 0, late = 0;
        for (int i = 0; i < found.count; ++i) {
            weights[found.corner[i] % 3] += found.weight[i];
            total += found.weight[i];
            if (found.corner[i] >= 3) late += found.weight[i];
        }
        if (!(total > 0)) continue;
        double b = weights[1] / total, c = weights[2] / total;
        clamp_weights(b, c);
        const double when = std::clamp(late / total, 0.0, 1.0) * t;
        const Frame<Dyadic>& frame = exactly();
        const V3<Dyadic> meet = blend(frame.w, Dyadic(b), Dyadic(c)) + scaled(frame.d, Dyadic(when));
        if (inside(query_.kind, frame.size, meet) == 1) return true;
    }
    return false;
}

}  // namespace judge
