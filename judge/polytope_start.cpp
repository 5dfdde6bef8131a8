// Sphere, ellipsoid (squashed), capsule and box: the shape is a core polytope and a ball, so the signed distance to
// M = T + core + ball is that to the polytope Q = T + core, less the radius. Outside Q the one active normal points
// from the nearest point of Q, which is checked, not searched, in exact numbers: a set of up to three corners of Q
// proposes it, and no corner may lie beyond the plane. Inside Q the active normals are those of the nearest facets.
#include <optional>

#include "frame.hpp"
#include "gjk.hpp"
#include "interval.hpp"
#include "start.hpp"

namespace judge {
namespace {

struct Ids {
    int count = 0;
    int id[4] = {};
};

template <class N>
class Polytope {
public:
    Polytope(const Query& query, double t) : frame_(query), radius_(0.0) {
        for (V3<N>& w : frame_.w) w = w + scaled(frame_.d, N(t));
        direction_ = frame_.d;
        const V3<N> r = lift<N>(query.size);
        const V3<N> squash{r.y * r.z, r.x * r.z, r.x * r.y};
        if (frame_.kind == Kind::ellipsoid) direction_ = times(direction_, squash);
        for (int i = 0; i < 3; ++i) {
            V3<N> w = frame_.w[i];
            if (frame_.kind == Kind::ellipsoid) w = times(w, squash);
            for (int mate = 0; mate < mates(); ++mate) corners_[i * mates() + mate] = w - core(mate);
        }
        if (frame_.kind == Kind::sphere || frame_.kind == Kind::capsule) radius_ = frame_.size.x;
        if (frame_.kind == Kind::ellipsoid) radius_ = frame_.turn.s * r.x * r.y * r.z;
        unit_ = frame_.turn.s * (frame_.kind == Kind::ellipsoid ? r.x * r.y * r.z : N(1.0));
        count_ = 3 * mates();
    }

    [[nodiscard]] int mates() const { return frame_.kind == Kind::box ? 8 : (frame_.kind == Kind::capsule ? 2 : 1); }
    [[nodiscard]] int count() const { return count_; }

    /// The point of the core (mirrored, which changes nothing) with these bits.
    [[nodiscard]] V3<N> core(int mate) const {
        const V3<N>& s = frame_.size;
        if (frame_.kind == Kind::capsule) return {N(0.0), mate ? s.y : -s.y, N(0.0)};
        if (frame_.kind == Kind::box) return {mate & 1 ? s.x : -s.x, mate & 2 ? s.y : -s.y, mate & 4 ? s.z : -s.z};
        return {N(0.0), N(0.0), N(0.0)};
    }

    /// Is the nearest point of Q to the reference point spanned by these corners? 1: yes, and `signs` is the answer.
    int nearest(const Ids& ids, StartSigns& signs) const {
        V3<N> n = corners_[ids.id[0]];
        N over = dot(n, n), under = N(1.0);  // distance^2 = over / under^2
        if (ids.count == 2) {
            const V3<N>& a = corners_[ids.id[0]];
            const V3<N> e = corners_[ids.id[1]] - a;
            const N ee = dot(e, e), ae = dot(a, e);
            const int between = least_sign(sign_of(-ae), sign_of(dot(corners_[ids.id[1]], e)));
            if (between != 1) return between == unsure ? unsure : 0;
            n = scaled(a, ee) - scaled(e, ae);
            over = dot(n, n);
            under = ee;
        } else if (ids.count == 3) {
            const V3<N>&a = corners_[ids.id[0]], &b = corners_[ids.id[1]], &c = corners_[ids.id[2]];
            n = cross(b - a, c - a);
            const int within = least_sign(sign_of(dot(n, cross(b, c))),
                                          least_sign(sign_of(dot(n, cross(c, a))), sign_of(dot(n, cross(a, b)))));
            if (within != 1) return within == unsure ? unsure : 0;
            const N height = dot(n, a);
            const int side = sign_of(height);
            if (side == unsure || side == 0) return side;
            if (side < 0) n = -n;
            under = dot(n, n);
            over = square(height) * under;  // (h / |n|)^2 = h^2 |n|^2 / (|n|^2)^2
        }
        const int apart = sign_of(over);
        if (apart != 1) return apart;
        const N level = dot(n, corners_[ids.id[0]]);
        for (int j = 0; j < count_; ++j) {
            if (is_one_of(ids, j)) continue;
            const int beyond = sign_of(dot(n, corners_[j]) - level);
            if (beyond == unsure) return unsure;
            if (beyond < 0) return 0;
        }
        signs.depth = sign_of(over - square(radius_ * under));
        signs.slope = sign_of(dot(n, direction_));
        const double unit = to_double(unit_);
        signs.g = (std::sqrt(to_double(over)) / to_double(under) - to_double(radius_)) / unit;
        return signs.depth == unsure || signs.slope == unsure ? unsure : 1;
    }

    /// The facets of Q, if it has an inside (a triangle alone has none). 1: the reference point is within Q, and
    /// `signs` is the answer; 0: it is not, or Q is flat.
    int within(StartSigns& signs) const {
        if (frame_.kind != Kind::box && frame_.kind != Kind::capsule) return 0;
        const V3<N> ab = frame_.w[1] - frame_.w[0], bc = frame_.w[2] - frame_.w[1], ca = frame_.w[0] - frame_.w[2];
        const V3<N> axes[3] = {{N(1.0), N(0.0), N(0.0)}, {N(0.0), N(1.0), N(0.0)}, {N(0.0), N(0.0), N(1.0)}};
        V3<N> normals[13];
        int n = 0;
        normals[n++] = cross(ab, bc);
        if (frame_.kind == Kind::capsule) {
            const int flat = sign_of(normals[0].y);
            if (flat == 0 || flat == unsure) return flat;
            for (const V3<N>& e : {ab, bc, ca}) normals[n++] = cross(e, axes[1]);
        } else {
            for (const V3<N>& axis : axes) {
                normals[n++] = axis;
                for (const V3<N>& e : {ab, bc, ca}) normals[n++] = cross(e, axis);
            }
        }
        std::optional<N> best_gap, best_size;
        int slope = -1;
        for (int i = 0; i < 2 * n; ++i) {
            const V3<N> normal = i < n ? normals[i] : -normals[i - n];
            const N size = dot(normal, normal);
            const int real = sign_of(size);
            if (real == 0) continue;
            if (real == unsure) return unsure;
            N gap = dot(normal, frame_.w[0]);
            for (int j = 1; j < 3; ++j) {
                const N here = dot(normal, frame_.w[j]);
                const int less = sign_of(here - gap);
                if (less == unsure) return unsure;
                if (less < 0) gap = here;
            }
            const V3<N>& s = frame_.size;
            const N tall = s.y * abs(normal.y);
            gap = gap - (frame_.kind == Kind::box ? s.x * abs(normal.x) + tall + s.z * abs(normal.z) : tall);
            const int apart = sign_of(gap);
            if (apart == unsure) return unsure;
            if (apart > 0) return 0;
            // gap / |normal| is at most 0: the nearest facet is the one with the smallest square.
            const int order = best_gap ? sign_of(square(*best_gap) * size - square(gap) * *best_size) : 1;
            if (order == unsure) return unsure;
            if (order < 0) continue;
            const int here = sign_of(dot(normal, direction_));
            if (here == unsure) return unsure;
            slope = order > 0 || here > slope ? here : slope;
            best_gap = gap;
            best_size = size;
        }
        signs.depth = frame_.kind == Kind::box ? sign_of(*best_gap) : -1;
        signs.slope = slope;
        signs.g = (to_double(*best_gap) / std::sqrt(to_double(*best_size)) - to_double(radius_)) / to_double(unit_);
        return 1;
    }

private:
    static V3<N> times(const V3<N>& a, const V3<N>& b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
    static bool is_one_of(const Ids& ids, int j) {
        for (int i = 0; i < ids.count; ++i)
            if (ids.id[i] == j) return true;
        return false;
    }

    Frame<N> frame_;
    V3<N> direction_;
    V3<N> corners_[24];
    N radius_, unit_;
    int count_ = 0;
};

template <class F>
Ids propose(const Query& query, double t, int mates) {
    Local<F> local(query);
    for (V3<F>& w : local.w) w = w + scaled(local.d, F(t));
    const Nearest<F> nearest = Gjk<F>(local, local.w, 3).run(64, sizeof(F) > 8 ? 1e-30 : 1e-15);
    Ids ids;
    for (int i = 0; i < nearest.count; ++i) ids.id[ids.count++] = nearest.corner[i] * mates + nearest.mate[i];
    return ids;
}

/// Every set of up to three of the proposed corners.
template <class N>
int try_subsets(const Polytope<N>& polytope, const Ids& from, StartSigns& signs) {
    bool doubt = false;
    for (int set = (1 << from.count) - 1; set > 0; --set) {
        Ids ids;
        for (int i = 0; i < from.count; ++i)
            if (set >> i & 1) ids.id[ids.count++] = from.id[i];
        if (ids.count > 3) continue;
        const int found = polytope.nearest(ids, signs);
        if (found == 1) return 1;
        doubt = doubt || found == unsure;
    }
    return doubt ? unsure : 0;
}

template <class N>
int try_all(const Polytope<N>& polytope, StartSigns& signs) {
    const int n = polytope.count();
    for (int i = 0; i < n; ++i) {
        if (polytope.nearest({1, {i}}, signs) == 1) return 1;
        for (int j = i + 1; j < n; ++j) {
            if (polytope.nearest({2, {i, j}}, signs) == 1) return 1;
            for (int k = j + 1; k < n; ++k)
                if (polytope.nearest({3, {i, j, k}}, signs) == 1) return 1;
        }
    }
    return 0;
}

}  // namespace

StartSigns polytope_start(const Query& query, double t) {
    StartSigns signs;
    Ids ids;
    {
        const Polytope<Interval> quick(query, t);
        const int inside = quick.within(signs);
        if (inside == 1 && signs.depth != unsure && signs.slope != unsure) return signs;
        ids = propose<double>(query, t, quick.mates());
        if (inside == 0 && try_subsets(quick, ids, signs) == 1) return signs;
    }
    const Polytope<Dyadic> polytope(query, t);
    if (polytope.within(signs) == 1) return signs;
    if (try_subsets(polytope, ids, signs) == 1) return signs;
    if (try_subsets(polytope, propose<Quad>(query, t, polytope.mates()), signs) == 1) return signs;
    if (try_all(polytope, signs) == 1) return signs;
    if (query.kind == Kind::box) return {};  // cannot be: its Q has an inside, so one of the above decided
    // The reference point lies on a Q without an inside: normals of both signs are active, so it cannot go deeper.
    signs.depth = -1;
    signs.slope = 1;
    signs.g = -(query.kind == Kind::ellipsoid ? 1.0 : query.size.x);
    return signs;
}

}  // namespace judge
