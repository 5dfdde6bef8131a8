#include "judge.hpp"

#include <algorithm>
#include <cmath>

#include "separation.hpp"
#include "start.hpp"

namespace judge {
namespace {

bool is_finite(const Vec& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

bool is_zero(const Vec& v) {
    return v.x == 0 && v.y == 0 && v.z == 0;
}

template <class N>
int sign_of_side(const Query& q) {
    const V3<N> a = lift<N>(q.a);
    return sign_of(dot(cross(lift<N>(q.b) - a, lift<N>(q.c) - a), lift<N>(q.to) - lift<N>(q.from)));
}

/// The exact sign of d . N: -1 if the motion is against the front of the triangle.
int sign_of_side(const Query& q) {
    const int quick = sign_of_side<Interval>(q);
    return quick == unsure ? sign_of_side<Dyadic>(q) : quick;
}

/// The point of the triangle nearest to p, as weights of b and c, and which parts of the triangle p lies within
/// `reach` of. In floats, relative to a corner.
struct Placement {
    double b = 0, c = 0, distance = 0;
    bool on_edge = false, on_vertex = false;
};

template <class F>
Placement place_in(const Query& q, const Vec& point, double reach) {
    const V3<F> corners[3] = {lift<F>(q.a), lift<F>(q.b), lift<F>(q.c)};
    const V3<F> p = lift<F>(point);
    Placement best;
    best.distance = INFINITY;
    const auto offer = [&](const F& b, const F& c) {
        const V3<F> off = (p - corners[0]) - scaled(corners[1] - corners[0], b) - scaled(corners[2] - corners[0], c);
        const double distance = to_double(length(off));
        if (distance < best.distance) best = {to_double(b), to_double(c), distance, best.on_edge, best.on_vertex};
    };
    constexpr double weights[3][2] = {{0, 0}, {1, 0}, {0, 1}};
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3;
        const F b(weights[i][0]), c(weights[i][1]), b_step(weights[j][0] - weights[i][0]),
            c_step(weights[j][1] - weights[i][1]);
        if (to_double(length(p - corners[i])) <= reach) best.on_vertex = best.on_edge = true;
        offer(b, c);
        const V3<F> e = corners[j] - corners[i];
        const F ee = dot(e, e);
        if (!(ee > F(0))) continue;
        const F u = std::clamp(F(dot(p - corners[i], e) / ee), F(0), F(1));
        if (to_double(length((p - corners[i]) - scaled(e, u))) <= reach) best.on_edge = true;
        offer(b + u * b_step, c + u * c_step);
    }
    const V3<F> e1 = corners[1] - corners[0], e2 = corners[2] - corners[0], r = p - corners[0];
    const V3<F> n = cross(e1, e2);
    const F nn = dot(n, n);
    if (nn > F(0)) {
        const F b = dot(n, cross(r, e2)) / nn, c = dot(n, cross(e1, r)) / nn;
        if (b >= F(0) && c >= F(0) && b + c <= F(1)) offer(b, c);
    }
    return best;
}

/// Doubles are good to far better than the bound, except across a sliver: its weights take more digits.
Placement place(const Query& q, const Vec& point, double bound) {
    const Placement quick = place_in<double>(q, point, 2 * bound);
    return quick.distance <= bound ? quick : place_in<Quad>(q, point, 2 * bound);
}

class Hearing {
public:
    Hearing(const Query& query, const Answer& answer)
        : query_(query),
          answer_(answer),
          examination_(query),
          bound_(allowed_gap * largest(query)),
          reach_(largest_dimension(query)) {}

    Judgement run() {
        const Answer& a = answer_;
        if (!std::isfinite(a.t) || !is_finite(a.normal) || !is_finite(a.point))
            return {Verdict::bad_status, 0, "the answer holds numbers that are not finite"};
        if (!a.hit) return no_hit();
        if (a.status != Status::ok) return {Verdict::bad_status, 0, "a query within the limits was not answered"};
        if (!(a.t >= 0 && a.t <= 1)) return {Verdict::bad_status, 0, "t is not within [0, 1]"};
        if (is_zero(minus(query_.to, query_.from))) return {Verdict::false_hit, 0, "a shape that stands still hit"};
        if (query_.one_sided && sign_of_side(query_) != -1)
            return {Verdict::false_hit, 0, "a one-sided triangle was hit from behind or along its plane"};
        const Placement placement = place(query_, a.point, bound_);
        Judgement judgement = a.t == 0 ? start(placement) : later(placement);
        if (judgement.verdict != Verdict::right) return judgement;
        if (const Judgement contact = judge_contact(placement); contact.verdict != Verdict::right)
            return {contact.verdict, judgement.gap, contact.why};
        return judgement;
    }

private:
    static Vec minus(const Vec& a, const Vec& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }

    Judgement no_hit() {
        if (is_zero(minus(query_.to, query_.from))) return {Verdict::right, 0, "it stands still"};
        if (query_.one_sided && sign_of_side(query_) != -1) return {Verdict::right, 0, "not against the front"};
        if (examination_.find_quickly(nullptr, 1, true)) return {Verdict::right, 0, "a plane separates"};
        const StartSigns signs = start_signs(query_, 0);
        if (signs.depth == 0 || signs.depth == -1) {
            if (signs.slope == 0 || signs.slope == 1) return {Verdict::right, 0, "in touch, and not going deeper"};
            if (signs.slope == -1) return {Verdict::miss, 0, "in touch at the start and going deeper"};
            return {Verdict::unproved, 0, "in touch at the start; the slope is not decided"};
        }
        // g is convex: apart and not approaching, it stays apart. The same read backwards from the end.
        if (signs.depth == 1 && (signs.slope == 0 || signs.slope == 1))
            return {Verdict::right, 0, "apart, and not approaching"};
        if (examination_.find_thoroughly(1, true)) return {Verdict::right, 0, "a plane separates"};
        const StartSigns end = start_signs(query_, 1);
        if (end.depth == 1 && (end.slope == 0 || end.slope == -1))
            return {Verdict::right, 0, "apart at the end, and approaching until then"};
        if (is_curved()) {
            const Pass pass = curved_pass(query_);
            if (pass.meets == 1) return {Verdict::miss, 0, "the shape reaches the triangle by less than a hair"};
            for (int i = 0; i < pass.count; ++i)
                if (examination_.separates_exactly(pass.planes[i], 1, true))
                    return {Verdict::right, 0, "a plane separates by less than a hair"};
        }
        if (end.depth <= 0 || examination_.overlaps_within(1))
            return {Verdict::miss, 0, "the shape reaches the triangle"};
        return {Verdict::unproved, 0, "no hit, and no plane that separates was found"};
    }

    [[nodiscard]] bool is_curved() const { return query_.kind == Kind::cylinder || query_.kind == Kind::cone; }
    [[nodiscard]] bool comes_closer() const { return is_curved() && curved_comes_closer(query_); }

    bool is_exact_miss() {
        return examination_.find_quickly(nullptr, 1, true) || examination_.find_thoroughly(1, true);
    }

    /// The gap at t, by the reported point or else by the nearest points that a search finds.
    double gap_at(const Placement& placement) {
        const double reported = examination_.reach(answer_.t, placement.b, placement.c);
        point_is_near_ = reported <= bound_ && placement.distance <= bound_;
        return reported <= bound_ ? reported : std::min(reported, examination_.reach(answer_.t, bound_));
    }

    Judgement start(const Placement& placement) {
        const double gap = gap_at(placement) / bound_;
        if (!(gap <= 1)) {
            if (is_exact_miss()) return {Verdict::false_hit, gap, "there is no contact"};
            return {Verdict::early, gap, "not in touch at the start"};
        }
        const StartSigns signs = start_signs(query_, 0);
        start_gap_ = signs.g;
        if (signs.slope == -1) return {Verdict::right, gap, "in touch and going deeper"};
        if (comes_closer()) return {Verdict::right, gap, "nearer later than at the start, if by an ulp of zero"};
        if (signs.slope == unsure) return {Verdict::unproved, gap, "the slope at the start is not decided"};
        return {Verdict::false_hit, gap, "in touch at the start, but not going deeper"};
    }

    Judgement later(const Placement& placement) {
        const V3<double> n = examination_.into_frame(answer_.normal);
        if (!examination_.find_quickly(&n, answer_.t, false) && !examination_.find_thoroughly(answer_.t, false)) {
            if (examination_.overlaps_within(answer_.t) || start_signs(query_, answer_.t).depth == -1)
                return {Verdict::late, 0, "the shape cuts into the triangle"};
            return {Verdict::unproved, 0, "no plane was found that separates up to the hit"};
        }
        const double gap = gap_at(placement) / bound_;
        if (!(gap <= 1)) {
            if (is_exact_miss()) return {Verdict::false_hit, gap, "there is no contact"};
            return {Verdict::early, gap, "too far away at the hit"};
        }
        // A false hit within the bound is allowed, but only if the shape approaches. Clear cases need no proof; along
        // a grazing motion t may lie a hair beyond the closest approach, so what counts is the approach from the start.
        if (along_normal() < -1e-6) return {Verdict::right, gap, "a hit"};
        if (start_signs(query_, 0).slope == -1 || comes_closer())
            return {Verdict::right, gap, "a hit, approaching slowly"};
        if (is_exact_miss())
            return {Verdict::false_hit, gap, "it passes near the triangle without ever approaching it"};
        return {Verdict::right, gap, "a grazing hit"};
    }

    /// Normal, point and feature of a hit whose time is right.
    Judgement judge_contact(const Placement& placement) {
        const Vec& n = answer_.normal;
        if (std::fabs(n.x * n.x + n.y * n.y + n.z * n.z - 1) > 1e-12)
            return {Verdict::bad_normal, 0, "the normal is not of unit length"};
        const V3<double> local = examination_.into_frame(n);
        if (!is_of_contact(local)) return {Verdict::bad_normal, 0, "the normal is not that of the contact"};
        if (along_normal() > angle) return {Verdict::bad_normal, 0, "the shape goes along the normal, not against it"};
        if (!point_is_near_) return {Verdict::bad_point, 0, "the point is not on both triangle and shape"};
        if (is_deep() ? !supports(local) : !is_on_feature(placement, local))
            return {Verdict::bad_feature, 0, "the contact is not on the feature"};
        return {Verdict::right, 0, ""};
    }

    /// The cosine between motion and reported normal: less than 0 if the shape goes against it.
    double along_normal() const {
        const Vec d = minus(query_.to, query_.from);
        const double size = std::max({std::fabs(d.x), std::fabs(d.y), std::fabs(d.z)});
        const Vec u{d.x / size, d.y / size, d.z / size};  // an ulp of zero has no square
        const Vec& n = answer_.normal;
        return (n.x * u.x + n.y * u.y + n.z * u.z) / std::sqrt(u.x * u.x + u.y * u.y + u.z * u.z);
    }

    /// Every normal's gap is a lower bound on the distance; that of the contact attains it.
    bool is_of_contact(const V3<double>& n) const {
        double gap = examination_.gap(n, answer_.t), best = 0, allowed = 2 * bound_;
        if (is_deep()) {  // the shortest way out
            best = start_gap_;
            allowed += angle * reach_;
            if (query_.kind == Kind::ellipsoid) {
                const V3<double>& r = examination_.local().size;
                gap /= length(V3<double>{r.x * n.x, r.y * n.y, r.z * n.z});
                allowed /= std::min({r.x, r.y, r.z});
            }
            return gap >= best - allowed;
        }
        if (gap >= best - allowed) return true;
        // A slight turn of the normal costs a gap far out on a large triangle. What counts is near the contact: there
        // the triangle must lie behind the plane, and the shape before it.
        const V3<double> apart = examination_.into_frame(minus(at(answer_.t), answer_.point));
        const bool round = query_.kind == Kind::sphere || query_.kind == Kind::ellipsoid;
        const double slack = (round ? angle * angle : angle) * reach_;  // a turn moves what supports a ball by little
        if (dot(n, apart) < examination_.support(n) - allowed - slack) return false;
        return above(n, 1) <= allowed + angle * reach_;
    }

    /// How far the triangle, as far as it is within the shape's size of the contact, rises above the plane through the
    /// reported point; with `sides` 2, or falls below it.
    double above(const V3<double>& n, int sides) const {
        double most = 0;
        for (const Vec* corner : {&query_.a, &query_.b, &query_.c}) {
            const V3<double> v = examination_.into_frame(minus(*corner, answer_.point));
            const double rise = dot(n, v) * std::min(1.0, reach_ / std::max(length(v), reach_));
            most = std::max(most, sides == 2 ? std::fabs(rise) : rise);
        }
        return most;
    }

    /// By more than the bound, in the units of `start_gap_`.
    [[nodiscard]] bool is_deep() const {
        return answer_.t == 0 && start_gap_ < -bound_ / (query_.kind == Kind::ellipsoid ? reach_ : 1);
    }

    bool is_on_feature(const Placement& placement, const V3<double>& n) const {
        if (answer_.feature == Feature::vertex) return placement.on_vertex;
        if (answer_.feature == Feature::edge) return placement.on_edge;
        return above(n, 2) <= 2 * bound_ + angle * reach_;  // the normal is that of the triangle's plane
    }

    /// Deep inside, the part of the triangle that lies deepest along the normal may well be outside the shape, so the
    /// feature cannot be told from the point: as many corners as it has must lie deepest.
    bool supports(const V3<double>& n) const {
        const V3<double>* w = examination_.local().w;
        const double low = std::min({dot(n, w[0]), dot(n, w[1]), dot(n, w[2])});
        int deepest = 0;
        for (int i = 0; i < 3; ++i) deepest += dot(n, w[i]) - low <= 2 * bound_ + angle * reach_ ? 1 : 0;
        return deepest >= (answer_.feature == Feature::face ? 3 : (answer_.feature == Feature::edge ? 2 : 1));
    }

    Vec at(double t) const {
        const Vec d = minus(query_.to, query_.from);
        return {query_.from.x + t * d.x, query_.from.y + t * d.y, query_.from.z + t * d.z};
    }

    /// How much a reported normal may be turned from a true one. [rad]
    static constexpr double angle = 1e-5;

    const Query& query_;
    const Answer& answer_;
    Examination examination_;
    double bound_;
    double reach_;
    double start_gap_ = 0;
    bool point_is_near_ = false;
};

}  // namespace

const char* name_of(Verdict verdict) noexcept {
    constexpr const char* names[verdict_count] = {"right",      "miss",      "late",        "false hit",  "early",
                                                  "bad normal", "bad point", "bad feature", "bad status", "unproved"};
    return names[static_cast<int>(verdict)];
}

Judgement judge(const Query& query, const Answer& answer) {
    if (!is_valid(query)) {
        const bool blocked = answer.hit && answer.status == Status::invalid && answer.t == 0 &&
                             is_zero(answer.normal) && is_finite(answer.point);
        if (blocked) return {Verdict::right, 0, "blocked as invalid"};
        return {Verdict::bad_status, 0, "data outside the limits were not blocked as invalid"};
    }
    return Hearing(query, answer).run();
}

}  // namespace judge
