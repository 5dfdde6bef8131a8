// Sphere and ellipsoid: a ball against the nearest edge or corner of the triangle, in the space where the shape is a
// ball.
#include "sweep/one_feature.hpp"
#include "sweep/round_features.hpp"

namespace surefoot::internal {

namespace {

class BallGuess {
public:
    struct Part {
        unsigned corners = 7;
        friend bool operator==(const Part&, const Part&) = default;
    };

    BallGuess(const SweepQuery& query, const Ball& ball) noexcept
        : query_(query), ball_(ball), along_(divide_each(query.along, ball.squash)) {
        for (int i = 0; i < 3; ++i) {
            corners_[i] = divide_each(query.corners[i], ball.squash);
            edges_[i] = divide_each(query.edge_direction(i), ball.squash);
        }
    }

    [[nodiscard]] static Part none() noexcept { return {}; }
    [[nodiscard]] Part nearest(double t) const noexcept { return {nearest_feature(corners_, along_ * t)}; }

    [[nodiscard]] Proposal propose(const Part& part) const noexcept {
        const RoundNormals normals = normals_of(part.corners);
        const bool passes = normals.entry == Vec{};
        return {unit(divide_each(passes ? normals.passing : normals.entry, ball_.squash)), passes};
    }

    // The plane between a ball that stands at `from` and the feature.
    [[nodiscard]] Vec standing(const Part& part) const noexcept {
        Vec nearest = corners_[0];
        if (std::has_single_bit(part.corners)) {
            nearest = corners_[std::countr_zero(part.corners)];
        } else {
            const int i = edge_of(part.corners);
            const Vec& start = corners_[i == 2 ? 0 : i];
            nearest = start - edges_[i] * (dot(start, edges_[i]) / dot(edges_[i], edges_[i]));
        }
        return unit(divide_each(-nearest, ball_.squash));
    }

    [[nodiscard]] Place place(const Part& part, double t, const Vec&) const noexcept {
        const Vec centre = along_ * t;
        return std::has_single_bit(part.corners) ? on_corner(part.corners, centre) : on_edge(part.corners, centre);
    }

private:
    [[nodiscard]] RoundNormals normals_of(unsigned feature) const noexcept {
        Ball ball = ball_;
        if (std::has_single_bit(feature)) {
            const int corner = std::countr_zero(feature);
            ball.hairs = query_.corner_hairs(corner);
            return ball_against_point(corners_[corner], along_, ball);
        }
        const int i = edge_of(feature);
        ball.hairs = query_.edge_hairs(i);
        return ball_against_line(corners_[i == 2 ? 0 : i], edges_[i], along_, ball);
    }

    [[nodiscard]] Place on_corner(unsigned feature, const Vec& centre) const noexcept {
        const int corner = std::countr_zero(feature);
        const double clearly = clearly_beyond * ball_.radius;
        for (int i = 0; i < 3; ++i) {
            if ((ends_of[i] & feature) == 0) continue;
            const bool is_start = (i == 2 ? 0 : i) == corner;
            const double beyond = (is_start ? -1 : 1) * dot(edges_[i], centre - corners_[corner]);
            if (!(beyond > 0 && beyond * beyond > clearly * clearly * dot(edges_[i], edges_[i]))) return {};
        }
        return {true, outside(corners_[corner] - centre), query_.corners[corner]};
    }

    [[nodiscard]] Place on_edge(unsigned feature, const Vec& centre) const noexcept {
        const int i = edge_of(feature);
        const Vec& start = corners_[i == 2 ? 0 : i];
        const double share = dot(centre - start, edges_[i]) / dot(edges_[i], edges_[i]);
        return {share >= 0 && share <= 1, outside(start + edges_[i] * share - centre),
                query_.edge_start(i) + query_.edge_direction(i) * share};
    }

    [[nodiscard]] double outside(const Vec& from_centre) const noexcept {
        return (length(from_centre) - ball_.radius) * largest(ball_.squash);
    }

    const SweepQuery& query_;
    const Ball ball_;
    Vec corners_[3];
    Vec edges_[3];  // the query's directions squashed, as the full search has them: not differences of these corners
    Vec along_;
};

// How far from the feature, in hairs, a ball may be at the start and touch it.
constexpr double ball_touching_hairs = 8;

RoundFirst touching(const SweepQuery& query, const Ball& ball) noexcept {
    RoundFirst found;
    const BallGuess guess(query, ball);
    const BallGuess::Part part = guess.nearest(0);
    if (part.corners == 7) return found;
    const Vec normal = guess.standing(part);
    if (normal == Vec{}) return found;
    found.plane = judged(query, normal);
    if (!(absolute(found.plane.gap) <= ball_touching_hairs * query.triangle_hair())) return found;
    const Place place = guess.place(part, 0, normal);
    if (!place.is_clear || touched_corners(query, normal) != part.corners) return found;
    found.point = place.point;
    found.corners = part.corners;
    found.verdict = found.plane.approach < 0 ? RoundFirst::Verdict::hit : RoundFirst::Verdict::free;
    return found;
}

}  // namespace

RoundFirst ask_touching_feature(const SweepQuery& query, const Sphere& sphere) noexcept {
    return touching(query, {.radius = sphere.radius, .hairs = {}});
}

RoundFirst ask_touching_feature(const SweepQuery& query, const Ellipsoid& ellipsoid) noexcept {
    return touching(query, {.radius = 1, .hairs = {}, .squash = to_vec(ellipsoid.radii)});
}

RoundFirst ask_round_first(const SweepQuery& query, const Sphere& sphere, const FaceFirst& face,
                           double limit) noexcept {
    return settle_one_feature(query, BallGuess(query, {.radius = sphere.radius, .hairs = {}}), face, limit);
}

RoundFirst ask_round_first(const SweepQuery& query, const Ellipsoid& ellipsoid, const FaceFirst& face,
                           double limit) noexcept {
    const Ball ball{.radius = 1, .hairs = {}, .squash = to_vec(ellipsoid.radii)};
    return settle_one_feature(query, BallGuess(query, ball), face, limit);
}

}  // namespace surefoot::internal
