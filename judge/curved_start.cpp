// Cylinder and cone: every normal that can be active is proposed and measured, and those that attain the largest gap
// decide.
#include <optional>

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

template <class F>
struct Placed {
    V3<F> w[3], d, size;
    F largest;

    explicit Placed(const Exactly& at) : size(rounded<F>(at.size)) {
        const F scale = F(1) / RoundedOnce<F>::from(at.s);
        for (int i = 0; i < 3; ++i) w[i] = scaled(rounded<F>(at.w[i]), scale);
        d = scaled(rounded<F>(at.d), scale);
        largest = size.x > size.y ? size.x : size.y;
        for (const V3<F>& corner : w) {
            const F reach = length(corner);
            if (reach > largest) largest = reach;
        }
    }

    /// All the normals that can be active once the shape has moved by t d.
    [[nodiscard]] std::vector<CurvedNormal<F>> normals(Kind kind, const F& t, double least_gap) const {
        CurvedNormals<F> list(kind, size, d);
        list.screen(least_gap);
        V3<F> here[3];
        for (int i = 0; i < 3; ++i) here[i] = w[i] + scaled(d, t);
        for (int i = 0; i < 3; ++i) {
            list.add_corner(here[i]);
            list.add_edge(here[i], here[(i + 1) % 3]);
        }
        list.add_face(cross(here[1] - here[0], here[2] - here[0]));
        return list.run();
    }
};

/// Where a number lies that would be zero but for rounding: beyond `sure` it has a sign, within `zero` it counts as
/// zero, and between the two nothing is claimed.
struct Band {
    double zero, sure;
    bool squared = false;  ///< below what doubles have a number for

    template <class F>
    [[nodiscard]] F limit(double number) const {
        return squared ? F(F(number) * F(number)) : F(number);
    }

    template <class F>
    [[nodiscard]] int sign(const F& value, const F& unit) const {
        const F size = magnitude(value);
        if (size > limit<F>(sure) * unit) return value > F(0) ? 1 : -1;
        return size <= limit<F>(zero) * unit ? 0 : unsure;
    }
};

/// Long doubles tell two depths apart by their last digits, but a normal at a rim is good to far fewer (to a third of
/// them where three roots meet), so only plain slopes are theirs to decide.
constexpr Band quick_depth{-1, 1e-13}, quick_slope{-1, 1e-5};
/// In 2560 bits a third of the digits is 2^-853. Where an edge passes the apex by an ulp of zero, 1100 digits are lost
/// on the way there, and a third of what is left is 2^-486.
constexpr Band wide_band{0x1p-360, 0x1p-340};
/// Depths that differ by an ulp of zero (2^-1074) are told apart where there are any: they are good to 2^-1450 even
/// then. Slopes are not: a normal that is turned by an ulp of zero is as near as the nearest.
constexpr Band deep_band{0x1p-650, 0x1p-640, true};

/// Two normals closer than this are one. [rad]
constexpr double same_normal = 0x1p-180;

using Part = Origin::Part;

/// A normal made of whole products: the slope along it is told to the last bit, so that an ulp of zero counts there.
struct FlatNormal {
    V3<Big> n;  ///< of unit length
    int slope;
    Origin origin;
};

/// Of caps, face, a side against an edge that it stands along, and a side or rim against a corner or an upright edge.
std::vector<FlatNormal> flat_normals(const Exactly& at) {
    std::vector<FlatNormal> flats;
    const Dyadic zero;
    const auto unit = [](const V3<Dyadic>& v) {
        const V3<Big> n = rounded<Big>(v);
        const Big largest = std::max({magnitude(n.x), magnitude(n.y), magnitude(n.z)});
        if (!(largest > Big(0))) return n;
        const V3<Big> scaled_n = scaled(n, Big(1) / largest);
        return scaled(scaled_n, Big(1) / length(scaled_n));
    };
    const auto add_both = [&](const V3<Dyadic>& normal, const Origin& origin) {
        const V3<Big> n = unit(normal);
        if (!(length(n) > Big(0))) return;
        const int slope = sign_of(dot(normal, at.d));
        flats.push_back({n, slope, origin});
        flats.push_back({-n, -slope, origin});
    };
    add_both({zero, Dyadic(1), zero}, {Part::cap});
    add_both(cross(at.w[1] - at.w[0], at.w[2] - at.w[0]), {Part::face});
    for (int i = 0; i < 3; ++i) {
        const V3<Dyadic> edge = at.w[(i + 1) % 3] - at.w[i];
        add_both({-edge.z, zero, edge.x}, {Part::across_edge, i});
        add_both({at.w[i].x, zero, at.w[i].z}, {Part::away_from_axis, i});
    }
    return flats;
}

/// The slope along the flat normal that c is, or else along the nearest of those that it is one of but for rounding.
/// What is perpendicular to an edge is the one across it, turned up, or the face's or the cap's: where an edge along a
/// rim's tangent has its corner on the rim, the one away from the axis is by an ulp of zero as near, and may have a
/// slope of the other sign.
int slope_along_flat(const std::vector<FlatNormal>& flats, const CurvedNormal<Big>& c, int otherwise) {
    Big nearest(same_normal);
    bool is_own = false;
    for (const FlatNormal& flat : flats) {
        const Big apart = length(c.n - flat.n);
        if (!(apart < Big(same_normal))) continue;
        if (flat.origin == c.origin) return flat.slope;
        const bool is_perpendicular =
            c.origin.part == Part::at_edge && (flat.origin.part == Part::face || flat.origin.part == Part::cap ||
                                               flat.origin == Origin{Part::across_edge, c.origin.index});
        if (is_own && !is_perpendicular) continue;
        if (is_own == is_perpendicular && !(apart < nearest)) continue;
        is_own = is_perpendicular;
        nearest = apart;
        otherwise = flat.slope;
    }
    return otherwise;
}

template <class F>
StartSigns decide(Kind kind, const Exactly& exactly, const Placed<F>& at, const Band& depth, const Band& slope,
                  double least_gap) {
    const auto found = at.normals(kind, F(0), least_gap);
    F best = found.front().gap;
    for (const auto& c : found)
        if (c.gap > best) best = c.gap;
    const F speed = length(at.d);

    std::vector<FlatNormal> flats;
    if constexpr (std::is_same_v<F, Big>) flats = flat_normals(exactly);

    // Of those that certainly are active, and of those that may be; what may be is no matter if all say the same.
    int certain = -2, highest = -2, lowest = 2;
    bool doubtful = false;
    for (const auto& c : found) {
        const int behind = depth.sign(F(best - c.gap), at.largest);
        if (behind == 1) continue;
        int here = slope.sign(dot(c.n, at.d), speed);
        if constexpr (std::is_same_v<F, Big>) {
            if (here == 0 || here == unsure) here = slope_along_flat(flats, c, here);
        }
        if (here == unsure) {
            doubtful = true;
            continue;
        }
        highest = std::max(highest, here);
        lowest = std::min(lowest, here);
        if (behind == 0) certain = std::max(certain, here);
    }
    // Nothing is higher than 1; anything else a slope in doubt may change.
    StartSigns signs;
    signs.g = to_double(best);
    signs.depth = depth.sign(best, at.largest);
    const bool is_told = certain == 1 || (!doubtful && (certain == highest || lowest == highest));
    signs.slope = is_told ? highest : unsure;
    return signs;
}

double largest_in_doubles(const Query& query, const Exactly& at) {
    double largest_here = std::fmax(query.size.x, query.size.y);
    for (const V3<Dyadic>& w : at.w)
        largest_here = std::fmax(largest_here,
                                 length(V3<double>{to_double(w.x), to_double(w.y), to_double(w.z)}) / to_double(at.s));
    return largest_here;
}

/// Is there a coordinate next to zero, beside others that are not?
const Band& depth_band(const Query& query) {
    double least = HUGE_VAL, largest = 0;
    for (const Vec& v : {query.from, query.to, query.a, query.b, query.c}) {
        for (const double coordinate : {v.x, v.y, v.z}) {
            const double size = std::fabs(coordinate);
            if (size != 0) least = std::min(least, size);
            largest = std::max(largest, size);
        }
    }
    return least < largest * 0x1p-340 ? deep_band : wide_band;
}

}  // namespace

StartSigns curved_start(const Query& query, double t) {
    const Exactly at(query, t);
    const StartSigns quick = decide(query.kind, at, Placed<long double>(at), quick_depth, quick_slope, -HUGE_VAL);
    if (quick.depth != unsure && quick.slope != unsure) return quick;
    return decide(query.kind, at, Placed<Big>(at), depth_band(query), wide_band,
                  quick.g - 1e-9 * largest_in_doubles(query, at));
}

namespace {

/// Followed in wide floats. Long doubles see which normals may be the nearest; only those are asked.
struct Followed {
    Kind kind;
    Placed<Big> at;
    Placed<long double> rough;
    double slack;

    Followed(const Query& query, const Exactly& exactly) : kind(query.kind), at(exactly), rough(exactly) {
        slack = 1e-9 * (to_double(rough.largest) + to_double(length(rough.d)));
    }

    /// Along which the gap is the largest once the shape has moved by t d, if any was found.
    [[nodiscard]] std::optional<CurvedNormal<Big>> nearest(const Big& t) const {
        double least_gap = -HUGE_VAL;
        for (const auto& c : rough.normals(kind, to_double(t), -HUGE_VAL))
            least_gap = std::max(least_gap, to_double(c.gap) - slack);
        std::optional<CurvedNormal<Big>> best;
        for (const auto& c : at.normals(kind, t, least_gap))
            if (!best || c.gap > best->gap) best = c;
        return best;
    }
};

}  // namespace

bool curved_comes_closer(const Query& query) {
    if (&depth_band(query) != &deep_band) return false;  // no slope is that slight
    const Followed motion(query, Exactly(query, 0));
    const auto start = motion.nearest(Big(0));
    if (!start || !(dot(start->n, motion.at.d) < Big(0))) return false;
    // Normals good to 2^-1250 give gaps that are good to 2^-2500, as a turn costs its square.
    const Big least = motion.at.largest * Big(0x1p-1000) * Big(0x1p-1000) * Big(0x1p-300);
    // A slope of an ulp of zero may be lost to curvature after as little of the motion.
    Big t(1);
    for (int tries = 0; tries < 35; ++tries, t = t * Big(0x1p-32)) {
        const auto later = motion.nearest(t);
        if (later && start->gap - later->gap > least) return true;
    }
    return false;
}

Pass curved_pass(const Query& query) {
    const Followed motion(query, Exactly(query, 0));
    const Placed<Big>& at = motion.at;
    const Band& depth = depth_band(query);
    const Big speed = length(at.d), flat = Big(wide_band.zero) * speed;
    const Big touching = depth.limit<Big>(depth.zero) * at.largest;
    struct Side {
        V3<Big> n;
        Big rate;
        bool known = false;
    } closing, opening;
    Big low(0), high(1), t(0);
    Pass pass;
    for (int round = 0; round < 250; ++round) {
        const auto best = motion.nearest(t);
        if (!best) return pass;
        if (best->gap <= touching) {
            pass.meets = 1;
            return pass;
        }
        // The gap along one normal is linear in time: where it gives way bounds the times that are left.
        const Big rate = dot(best->n, at.d);
        const bool comes = rate<-flat, goes = rate> flat;
        if (comes) {
            closing = {best->n, rate, true};
            low = t - best->gap / rate;
        } else if (goes) {
            opening = {best->n, rate, true};
            high = t - best->gap / rate;
        }
        if ((comes || goes) && low <= high) {
            t = round % 2 == 1 ? (low + high) * Big(0.5) : (comes ? low : high);
            continue;
        }
        pass.meets = -1;
        pass.planes[pass.count++] = exact(best->n);
        if (closing.known && opening.known)
            pass.planes[pass.count++] = exact(scaled(closing.n, opening.rate) - scaled(opening.n, closing.rate));
        return pass;
    }
    return pass;
}

StartSigns start_signs(const Query& query, double t) {
    return query.kind == Kind::cylinder || query.kind == Kind::cone ? curved_start(query, t) : polytope_start(query, t);
}

}  // namespace judge
