/// The normals along which a cylinder or cone can be nearest to a polytope, all in closed form but one: a rim against
/// an edge needs the roots of a quartic, which are bracketed and polished. K' is the mirrored shape: the cylinder
/// itself, or a cone with its apex up and its disc at y = -height.
#pragma once

#include <algorithm>
#include <vector>

#include "floats.hpp"

namespace judge {

/// What a normal was proposed as. Normals of two parts may be an ulp of zero apart, and the slopes along them may have
/// opposite signs: it matters which one it is.
struct Origin {
    enum class Part { other, cap, face, across_edge, away_from_axis, at_edge };  // at_edge: perpendicular to it
    Part part = Part::other;
    int index = 0;  ///< of the edge, or of the corner

    friend bool operator==(const Origin&, const Origin&) = default;
};

template <class F>
struct CurvedNormal {
    V3<F> n;   ///< of unit length
    F gap{0};  ///< n.w - h(n): a lower bound on the signed distance
    Origin origin{};
};

template <class F>
class CurvedNormals {
    static constexpr bool is_wide = std::is_same_v<F, Big>;

public:
    struct Edge {
        V3<F> from, along;
    };

    /// `toward`: any direction that an azimuth may be taken from when a corner lies on the axis; the motion.
    CurvedNormals(Kind kind, const V3<F>& size, const V3<F>& toward) : kind_(kind), size_(size), toward_(toward) {}

    void add_corner(const V3<F>& w) { corners_.push_back(w); }
    void add_edge(const V3<F>& from, const V3<F>& to) { edges_.push_back({from, to - from}); }
    void add_face(const V3<F>& normal) { faces_.push_back(normal); }

    [[nodiscard]] F gap(const V3<F>& n) const {
        F low = dot(n, corners_[0]);
        for (const V3<F>& w : corners_) {
            const F here = dot(n, w);
            if (here < low) low = here;
        }
        return low - support(n);
    }

    /// Normals whose gap in doubles is clearly below this are passed over: wide floats are slow.
    void screen(double least_gap) { least_gap_ = least_gap; }

    const std::vector<CurvedNormal<F>>& run() {
        for (const V3<F>& w : corners_) rough_corners_.push_back(to_doubles(w));
        const F zero(0);
        from_ = {Part::face};
        for (const V3<F>& n : faces_) propose_both(n);
        from_ = {Part::cap};
        propose_both({zero, F(1), zero});
        from_ = {};
        propose_both(toward_);
        propose_side(toward_.x, toward_.z);
        for (const V3<F>& w : corners_) {
            from_ = {kind_ == Kind::cylinder ? Part::away_from_axis : Part::other, index_of(w, corners_)};
            propose_side(w.x, w.z);
            from_ = {};
            if (kind_ == Kind::cone) propose_both(w);
            propose_rims(w);
        }
        for (const Edge& e : edges_) {
            from_ = {Part::across_edge, index_of(e, edges_)};
            propose_both({-e.along.z, zero, e.along.x});  // against a line of the mantle of a cylinder
            from_.part = Part::at_edge;
            propose_edge(e);
        }
        return found_;
    }

private:
    using Part = Origin::Part;

    template <class T>
    static int index_of(const T& one, const std::vector<T>& all) {
        return static_cast<int>(&one - all.data());
    }

    [[nodiscard]] F support(const V3<F>& n) const {
        const F flat = size_.x * root_of(n.x * n.x + n.z * n.z);
        if (kind_ == Kind::cylinder) return size_.y * magnitude(n.y) + flat;
        const F disc = flat - size_.y * n.y;
        return disc < F(0) ? F(0) : disc;
    }

    [[nodiscard]] bool is_hopeless(const V3<double>& n) const {
        const double size = length(n);
        if (least_gap_ == -HUGE_VAL || !(size > 0)) return false;
        double low = HUGE_VAL;
        for (const V3<double>& w : rough_corners_) low = std::min(low, dot(n, w));
        const double flat = to_double(size_.x) * std::sqrt(n.x * n.x + n.z * n.z), tall = to_double(size_.y);
        const double support =
            kind_ == Kind::cylinder ? flat + tall * std::fabs(n.y) : std::max(0.0, flat - tall * n.y);
        return (low - support) / size < least_gap_;
    }

    void propose(const V3<F>& n) {
        if (is_hopeless(to_doubles(n))) return;
        const F size = length(n);
        if (!(size > F(0))) return;
        const V3<F> unit = scaled(n, F(1) / size);
        found_.push_back({unit, gap(unit), from_});
    }
    void propose_both(const V3<F>& n) {
        propose(n);
        propose(-n);
    }

    /// The normals of the mantle at the azimuth (x, z) and opposite.
    void propose_side(const F& x, const F& z) {
        const F flat = root_of(x * x + z * z);
        if (!(flat > F(0))) return;
        for (const F& side : {F(F(1) / flat), F(F(-1) / flat)}) {
            if (kind_ == Kind::cylinder)
                propose({x * side, F(0), z * side});
            else
                propose({size_.y * x * side, size_.x, size_.y * z * side});
        }
    }

    int rims() const { return kind_ == Kind::cylinder ? 2 : 1; }
    F rim_height(int rim) const { return rim == 0 ? -size_.y : size_.y; }

    /// A corner against the rims; and, for a corner that lies on a rim, each edge against the rim's tangent there.
    void propose_rims(const V3<F>& w) {
        const F flat = root_of(w.x * w.x + w.z * w.z);
        if (!(flat > F(0))) return;
        for (int rim = 0; rim < rims(); ++rim)
            propose_both({w.x - size_.x * w.x / flat, w.y - rim_height(rim), w.z - size_.x * w.z / flat});
        for (const Edge& e : edges_) {
            from_ = {Part::at_edge, index_of(e, edges_)};
            propose_both(cross(e.along, {-w.z, F(0), w.x}));
        }
    }

    void propose_edge(const Edge& edge) {
        const F zero(0);
        const V3<F>& e = edge.along;
        const F ee = dot(e, e);
        if (!(ee > zero)) return;
        propose_both(scaled(toward_, ee) - scaled(e, dot(toward_, e)));
        if (kind_ == Kind::cone) {
            propose_both(scaled(edge.from, ee) - scaled(e, dot(edge.from, e)));  // against the apex
            propose_mantle_lines(e);
        }
        const V3<F> along = scaled(e, F(1) / root_of(ee));
        V3<F> u{along.z, zero, -along.x};
        const F level = length(u);
        if (!(level > zero)) return;  // a vertical edge meets the mantle before the rim
        u = scaled(u, F(1) / level);
        const V3<F> v = cross(along, u);
        propose_both(v);  // where three roots meet, on the axes of the ellipse that the rim is, seen along the edge
        for (int rim = 0; rim < rims(); ++rim) propose_rim_edge(edge.from, u, v, rim_height(rim));
    }

    /// Against a line of the cone's mantle: (height c, radius, height s) . e = 0 with c^2 + s^2 = 1.
    void propose_mantle_lines(const V3<F>& e) {
        const F ff = e.x * e.x + e.z * e.z;
        if (!(ff > F(0))) return;
        const F k = -(size_.x * e.y) / size_.y;  // c e.x + s e.z = k
        const F rest = ff - k * k;
        if (rest < F(0)) return;
        for (const F& root : {F(root_of(rest)), F(-root_of(rest))}) {
            const F c = (k * e.x - root * e.z) / ff, s = (k * e.z + root * e.x) / ff;
            propose({size_.y * c, size_.x, size_.y * s});
        }
    }

    /// Half the slope of the gap to a rim as n turns in the plane of u and v; n = u + tau v, or v + tau u.
    struct RimSlope {
        V3<F> w;  // from the rim's centre to the edge
        V3<F> p, q;
        F radius;
        F value(const F& tau, F* derivative) const {
            const V3<F> n = p + scaled(q, tau);
            const F flat2 = n.x * n.x + n.z * n.z, flat = root_of(flat2);
            const V3<F> pull{w.x - radius * n.x / flat, w.y, w.z - radius * n.z / flat};
            if (derivative != nullptr) {
                const F turn = (n.x * q.x + n.z * q.z) / flat2;
                const V3<F> change{-radius * (q.x - n.x * turn) / flat, F(0), -radius * (q.z - n.z * turn) / flat};
                *derivative = dot(change, q) - tau * dot(change, p) - dot(pull, p);
            }
            return dot(pull, q) - tau * dot(pull, p);
        }
    };

    /// Seen along the edge the rim is an ellipse with the half axes a along u and c along v. At a point of the ellipse
    /// whose normal runs through w, that normal is (w_u / (b + m), w_v / m), b = a^2 - c^2, with
    ///     f(m) = (a w_u / (b + m))^2 + (c w_v / m)^2 = 1.
    /// f falls towards both ends and is convex between its poles -b and 0, so that its roots, four at most, can be
    /// bracketed: one beyond each pole, and one on either side of the least value between them.
    void propose_rim_edge(const V3<F>& from, const V3<F>& u, const V3<F>& v, const F& height) {
        const V3<F> w{from.x, from.y - height, from.z};
        const double wu = to_double(dot(w, u)), wv = to_double(dot(w, v)), a = to_double(size_.x);
        const double c = a * std::sqrt(to_double(v.x * v.x + v.z * v.z)), b = a * a * to_double(v.y * v.y);
        const double au = std::fabs(a * wu), cv = std::fabs(c * wv);
        // `s` counts m from the pole at -b (or its mirror image), `m` from the one at 0.
        const auto value = [&](double s, double m) { return (au / s) * (au / s) + (cv / m) * (cv / m) - 1; };
        const auto offer = [&](double s, double m) {
            if (s != 0 && m != 0) propose_rim_normal(w, u, v, wu / s, wv / m);
        };
        const auto root = [&](double low, double high, const auto& above) {
            for (int i = 0; i < 64; ++i) {
                const double mid = 0.5 * (low + high);
                (above(mid) ? low : high) = mid;
            }
            return 0.5 * (low + high);
        };
        const double outer = root(std::max(cv, au - b), cv + au, [&](double m) { return value(b + m, m) > 0; });
        offer(b + outer, outer);
        const double inner = root(std::max(au, cv - b), cv + au, [&](double s) { return value(s, b + s) > 0; });
        offer(-inner, -b - inner);
        // On an axis of the ellipse one pole is gone, and its two roots lie side by side.
        const auto offer_pair = [&](double share, double half, double other, const auto& offer_one) {
            const double rest = 1 - half * half * share * share;
            if (!(rest >= 0) || !(other > 0)) return;
            for (const double side : {1.0, -1.0}) offer_one(share, side * std::sqrt(rest) / other);
        };
        if (b > 0) {
            offer_pair(wu / b, a, c, [&](double nu, double nv) { propose_rim_normal(w, u, v, nu, nv); });
            offer_pair(-wv / b, c, a, [&](double nv, double nu) { propose_rim_normal(w, u, v, nu, nv); });
        }
        const double up = std::cbrt(au * au), across = std::cbrt(cv * cv);
        if (up + across == 0) return;
        const double least_s = b * up / (up + across), least_m = b * across / (up + across);
        offer(least_s, -least_m);
        if (cv < least_m) {
            const double m = root(cv, least_m, [&](double m_) { return value(b - m_, m_) > 0; });
            offer(b - m, -m);
        }
        if (au < least_s) {
            const double s = root(au, least_s, [&](double s_) { return value(s_, b - s_) > 0; });
            offer(s, s - b);
        }
    }

    /// About (nu, nv) in the plane of u and v, of any length.
    void propose_rim_normal(const V3<F>& w, const V3<F>& u, const V3<F>& v, double nu, double nv) {
        if (!std::isfinite(nu) || !std::isfinite(nv) || (nu == 0 && nv == 0)) return;
        const bool flat = std::fabs(nu) >= std::fabs(nv);
        const F sign((flat ? nu : nv) < 0 ? -1 : 1);
        const RimSlope slope{w, scaled(flat ? u : v, sign), scaled(flat ? v : u, sign), size_.x};
        const double near = flat ? nv / nu : nu / nv;
        if (is_hopeless(to_doubles(slope.p) + scaled(to_doubles(slope.q), near))) return;
        propose_root(slope, near);
    }

    /// Newton's method: a few steps where they only have to propose, as many as it takes in wide floats, where the
    /// slope of the motion along what comes out has to be told from zero. Where m roots meet, each step is 1 - 1/m of
    /// the one before; then m steps are taken at once.
    void propose_root(const RimSlope& slope, double near) {
        F tau(near);
        double last = 0, ratio = 0;
        F noise(0);
        if constexpr (is_wide) {
            const F least(0x1p-1000);
            noise = (magnitude(slope.w.x) + magnitude(slope.w.y) + magnitude(slope.w.z) + slope.radius) * least *
                    least * F(0x1p-480);
        }
        for (int polish = 0; polish < (is_wide ? 100 : 3); ++polish) {
            F derivative(0);
            const F value = slope.value(tau, &derivative);
            if (!(magnitude(derivative) > F(0))) break;
            F step = value / derivative;
            if constexpr (is_wide) {
                if (!(magnitude(value) > noise)) break;
                const double size = to_double(step), now = last != 0 ? size / last : 0;
                const bool steady = now > 0.45 && now < 0.7 && std::fabs(now - ratio) < 0.02;
                if (steady) step = step * F(std::round(1 / (1 - now)));
                last = steady ? 0 : size;
                ratio = now;
            }
            tau = tau - step;
        }
        propose(slope.p + scaled(slope.q, tau));
    }

    static V3<double> to_doubles(const V3<F>& a) { return {to_double(a.x), to_double(a.y), to_double(a.z)}; }

    Kind kind_;
    V3<F> size_, toward_;
    std::vector<V3<F>> corners_;
    std::vector<Edge> edges_;
    std::vector<V3<F>> faces_;
    std::vector<CurvedNormal<F>> found_;
    std::vector<V3<double>> rough_corners_;
    double least_gap_ = -HUGE_VAL;
    Origin from_;
};

}  // namespace judge
