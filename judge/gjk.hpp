/// Proposes the direction in which a polytope (the triangle, or the prism that it sweeps) is nearest to a shape: the
/// algorithm of Gilbert, Johnson and Keerthi. Balls and ellipsoids (squashed to balls) are a point with a radius and
/// capsules a segment with a radius, so the search ends exactly there; discs converge.
#pragma once

#include "floats.hpp"

namespace judge {

template <class F>
struct Nearest {
    V3<F> v{F(0), F(0), F(0)};  ///< from the core of K' to the nearest point of the polytope; squashed for an ellipsoid
    bool overlaps = false;      ///< the polytope meets the core (v means nothing then)
    int count = 0;              ///< of the corners that span the nearest point
    int corner[4] = {};         ///< which corner of the polytope
    int mate[4] = {};           ///< which corner of the core: bit 0: +y; box: bits of x, y, z
    F weight[4] = {};
    V3<F> of_core{F(0), F(0), F(0)};
    V3<F> of_polytope{F(0), F(0), F(0)};
};

template <class F>
class Gjk {
public:
    /// `corners`: in the frame of `Local`, at most 6 of them.
    Gjk(const Local<F>& local, const V3<F>* corners, int count) : kind_(local.kind), size_(local.size), count_(count) {
        for (int i = 0; i < count; ++i) {
            corners_[i] = corners[i];
            if (kind_ == Kind::ellipsoid)
                corners_[i] = {corners[i].x / size_.x, corners[i].y / size_.y, corners[i].z / size_.z};
        }
    }

    Nearest<F> run(int most_steps, double precision) {
        V3<F> v = corners_[0] - centre();
        if (dot(v, v) == F(0)) v = {F(1), F(0), F(0)};
        n_ = 0;
        F best = F(-1);
        for (int step = 0; step < most_steps; ++step) {
            Point p = support(v);
            const F vv = dot(v, v);
            if (n_ > 0 && (vv - dot(v, p.w) <= F(precision) * vv || known(p))) break;
            points_[n_++] = p;
            v = reduce();
            const F now = dot(v, v);
            if (n_ == 4 || now == F(0)) {
                Nearest<F> met = report(v);
                met.overlaps = true;
                return met;
            }
            if (best >= F(0) && now >= best) break;
            best = now;
        }
        return report(v);
    }

private:
    struct Point {
        V3<F> w, on_core, on_polytope;
        int corner = 0, mate = 0;
        F weight{};
    };

    V3<F> centre() const {
        return kind_ == Kind::cone ? V3<F>{F(0), -size_.y * F(0.5), F(0)} : V3<F>{F(0), F(0), F(0)};
    }

    /// The point of the core of K' furthest along v.
    V3<F> core(const V3<F>& v, int& mate) const {
        const F zero(0);
        mate = 0;
        switch (kind_) {
            case Kind::sphere:
            case Kind::ellipsoid:
                return {zero, zero, zero};
            case Kind::capsule:
                mate = v.y > zero ? 1 : 0;
                return {zero, mate ? size_.y : -size_.y, zero};
            case Kind::box:
                mate = (v.x > zero ? 1 : 0) | (v.y > zero ? 2 : 0) | (v.z > zero ? 4 : 0);
                return {mate & 1 ? size_.x : -size_.x, mate & 2 ? size_.y : -size_.y, mate & 4 ? size_.z : -size_.z};
            case Kind::cylinder:
            case Kind::cone:
                break;
        }
        mate = -1;
        const F flat = root_of(v.x * v.x + v.z * v.z);
        V3<F> rim{zero, zero, zero};
        if (flat > zero) rim = {size_.x * v.x / flat, zero, size_.x * v.z / flat};
        if (kind_ == Kind::cylinder) {
            rim.y = v.y > zero ? size_.y : -size_.y;
            return rim;
        }
        if (size_.x * flat - size_.y * v.y < zero) return {zero, zero, zero};
        rim.y = -size_.y;
        return rim;
    }

    Point support(const V3<F>& v) const {
        Point p;
        F least = dot(v, corners_[0]);
        for (int i = 1; i < count_; ++i) {
            const F here = dot(v, corners_[i]);
            if (here < least) least = here, p.corner = i;
        }
        p.on_polytope = corners_[p.corner];
        p.on_core = core(v, p.mate);
        p.w = p.on_polytope - p.on_core;
        return p;
    }

    bool known(const Point& p) const {
        for (int i = 0; i < n_; ++i)
            if (points_[i].w.x == p.w.x && points_[i].w.y == p.w.y && points_[i].w.z == p.w.z) return true;
        return false;
    }

    /// Keeps the points that span the nearest point to the origin, and returns it.
    V3<F> reduce() {
        V3<F> best_v{F(0), F(0), F(0)};
        F best(-1);
        int best_ids[3] = {}, best_n = 0;
        F best_weights[3] = {};
        const auto offer = [&](const V3<F>& v, int n, const int* ids, const F* weights) {
            const F size = dot(v, v);
            if (best >= F(0) && size >= best) return;
            best = size, best_v = v, best_n = n;
            for (int i = 0; i < n; ++i) best_ids[i] = ids[i], best_weights[i] = weights[i];
        };
        for (int i = 0; i < n_; ++i) {
            const F one(1);
            offer(points_[i].w, 1, &i, &one);
            for (int j = i + 1; j < n_; ++j) {
                offer_edge(i, j, offer);
                for (int k = j + 1; k < n_; ++k) offer_face(i, j, k, offer);
            }
        }
        if (n_ == 4 && holds_origin()) return {F(0), F(0), F(0)};
        Point kept[3];
        for (int i = 0; i < best_n; ++i) {
            kept[i] = points_[best_ids[i]];
            kept[i].weight = best_weights[i];
        }
        for (int i = 0; i < best_n; ++i) points_[i] = kept[i];
        n_ = best_n;
        return best_v;
    }

    template <class Offer>
    void offer_edge(int i, int j, const Offer& offer) {
        const V3<F> e = points_[j].w - points_[i].w;
        const F ee = dot(e, e);
        if (!(ee > F(0))) return;
        const F u = -dot(points_[i].w, e) / ee;
        if (!(u > F(0) && u < F(1))) return;
        const int ids[2] = {i, j};
        const F weights[2] = {F(1) - u, u};
        offer(points_[i].w + scaled(e, u), 2, ids, weights);
    }

    template <class Offer>
    void offer_face(int i, int j, int k, const Offer& offer) {
        const V3<F>&a = points_[i].w, &b = points_[j].w, &c = points_[k].w;
        const V3<F> n = cross(b - a, c - a);
        const F nn = dot(n, n);
        if (!(nn > F(0))) return;
        const F wa = dot(n, cross(b, c)) / nn, wb = dot(n, cross(c, a)) / nn;
        const F wc = F(1) - wa - wb;
        if (!(wa > F(0) && wb > F(0) && wc > F(0))) return;
        const int ids[3] = {i, j, k};
        const F weights[3] = {wa, wb, wc};
        offer(scaled(n, dot(n, a) / nn), 3, ids, weights);
    }

    bool holds_origin() {
        F total(0);
        for (int skip = 0; skip < 4; ++skip) {
            const V3<F>&a = points_[(skip + 1) % 4].w, &b = points_[(skip + 2) % 4].w, &c = points_[(skip + 3) % 4].w;
            const V3<F> n = cross(b - a, c - a);
            const F origin = -dot(n, a), inner = dot(n, points_[skip].w - a);
            if (!(inner > F(0) ? origin >= F(0) : (inner < F(0) && origin <= F(0)))) return false;
            points_[skip].weight = origin / inner;
            total = total + points_[skip].weight;
        }
        for (Point& p : points_) p.weight = p.weight / total;
        return true;
    }

    Nearest<F> report(const V3<F>& v) const {
        Nearest<F> result;
        result.v = v;
        result.count = n_;
        for (int i = 0; i < n_; ++i) {
            result.corner[i] = points_[i].corner;
            result.mate[i] = points_[i].mate;
            result.weight[i] = points_[i].weight;
            result.of_core = result.of_core + scaled(points_[i].on_core, points_[i].weight);
            result.of_polytope = result.of_polytope + scaled(points_[i].on_polytope, points_[i].weight);
        }
        return result;
    }

    Kind kind_;
    V3<F> size_;
    V3<F> corners_[6];
    int count_ = 0;
    Point points_[4];
    int n_ = 0;
};

}  // namespace judge
