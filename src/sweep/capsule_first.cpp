// Capsule: its core, a segment, against the nearest part of the triangle. An end of the core against an edge or a
// corner is a ball against one; its middle against a corner is a ball against the core's line; against an edge it is a
// flat side of the prism that the triangle makes, drawn out along the core.
#include "sweep/one_feature.hpp"
#include "sweep/round_features.hpp"

namespace surefoot::internal {

namespace {

enum class Core : std::uint8_t { low_end, high_end, middle };

class CapsuleGuess {
public:
    struct Part {
        unsigned corners = 7;
        Core core = Core::middle;
        friend bool operator==(const Part&, const Part&) = default;
    };

    CapsuleGuess(const SweepQuery& query, const Capsule& capsule) noexcept : query_(query), capsule_(capsule) {}

    [[nodiscard]] static Part none() noexcept { return {}; }

    [[nodiscard]] Part nearest(double t) const noexcept {
        const Vec centre = query_.along * t;
        Part best;
        double least = 1e300;
        const auto keep_nearer = [&](double distance, const Part& part) {
            if (!(distance < least)) return;
            least = distance;
            best = part;
        };
        for (const Core end : {Core::low_end, Core::high_end}) {
            const Vec point = centre + end_of(end);
            const unsigned feature = nearest_feature(query_.corners, point);
            keep_nearer(squared_distance(point, feature), {feature, end});
        }
        for (int i = 0; i < 3; ++i) {
            const Crossing crossing = cross_edge(i, centre);
            if (crossing.is_within) keep_nearer(dot(crossing.apart, crossing.apart), {ends_of[i], Core::middle});
            const Vec& corner = query_.corners[i];
            const double up = corner.y - centre.y;
            if (absolute(up) > capsule_.half_height) continue;
            const Vec apart{corner.x - centre.x, 0, corner.z - centre.z};
            // Where one of its edges is nearer, that has been kept.
            keep_nearer(dot(apart, apart), {1U << i, Core::middle});
        }
        return best;
    }

    [[nodiscard]] Proposal propose(const Part& part) const noexcept {
        if (part.core == Core::middle && !std::has_single_bit(part.corners)) {
            const Vec side = unit(cross(scaled_to_one(query_.edge_direction(edge_of(part.corners))), Vec{0, 1, 0}));
            return {dot(side, query_.along) > 0 ? -side : side};
        }
        const RoundNormals normals = normals_of(part);
        const bool passes = normals.entry == Vec{};
        return {unit(passes ? normals.passing : normals.entry), passes};
    }

    [[nodiscard]] Place place(const Part& part, double t, const Vec& normal) const noexcept {
        const Vec centre = query_.along * t;
        if (!std::has_single_bit(part.corners)) {
            const int i = edge_of(part.corners);
            if (part.core == Core::middle) {
                const Crossing crossing = cross_edge(i, centre);
                return {crossing.is_within, length(crossing.apart) - capsule_.radius, crossing.on_edge};
            }
            const Vec edge = query_.edge_direction(i);
            const Vec point = centre + end_of(part.core);
            const double share = dot(point - query_.edge_start(i), edge) / dot(edge, edge);
            const Vec on_edge = query_.edge_start(i) + edge * share;
            return {share >= 0 && share <= 1, length(on_edge - point) - capsule_.radius, on_edge};
        }
        const int corner = std::countr_zero(part.corners);
        const Vec& at = query_.corners[corner];
        for (int i = 0; i < 3; ++i) {
            if ((ends_of[i] & part.corners) == 0) continue;
            const bool is_start = (i == 2 ? 0 : i) == corner;
            const Vec edge = query_.edge_direction(i);
            const double below = (is_start ? -1 : 1) * dot(edge, normal);
            if (!(below > 0 && below * below > clearly_beyond * clearly_beyond * dot(edge, edge))) return {};
        }
        const double up = smaller(capsule_.half_height, larger(-capsule_.half_height, at.y - centre.y));
        return {true, length(at - centre - Vec{0, up, 0}) - capsule_.radius, at};
    }

private:
    // Where the lines of the core and of an edge are nearest to each other (Ericson, "Real-Time Collision Detection",
    // 5.1.8).
    struct Crossing {
        bool is_within = false;  // both segments
        Vec on_edge;
        Vec apart;
    };
    [[nodiscard]] Crossing cross_edge(int i, const Vec& centre) const noexcept {
        const Vec start = query_.edge_start(i) - centre;
        const Vec edge = query_.edge_direction(i);
        // Seen along the core, the edge is nearest to the origin at this share.
        const double flat = edge.x * edge.x + edge.z * edge.z;
        if (!(flat > 0)) return {};
        const double share = -(start.x * edge.x + start.z * edge.z) / flat;
        const Vec at = start + edge * share;
        return {share >= 0 && share <= 1 && absolute(at.y) <= capsule_.half_height, at + centre, {at.x, 0, at.z}};
    }

    [[nodiscard]] Vec end_of(Core core) const noexcept {
        return {0, core == Core::low_end ? -capsule_.half_height : capsule_.half_height, 0};
    }

    [[nodiscard]] double squared_distance(const Vec& point, unsigned feature) const noexcept {
        Vec apart;
        if (feature == 7) {
            const Vec normal = cross(query_.edge_direction(0), query_.edge_direction(1));
            const double along = dot(point - query_.corners[0], normal);
            return along * along / larger(dot(normal, normal), 1e-300);
        }
        if (std::has_single_bit(feature)) {
            apart = query_.corners[std::countr_zero(feature)] - point;
        } else {
            const int i = edge_of(feature);
            const Vec edge = query_.edge_direction(i);
            const Vec start = query_.edge_start(i) - point;
            apart = start - edge * (dot(start, edge) / larger(dot(edge, edge), 1e-300));
        }
        return dot(apart, apart);
    }

    // As src/sweep/capsule.cpp proposes them.
    [[nodiscard]] RoundNormals normals_of(const Part& part) const noexcept {
        Ball ball{.radius = capsule_.radius, .hairs = {}};
        if (std::has_single_bit(part.corners)) {
            const int corner = std::countr_zero(part.corners);
            ball.hairs = query_.corner_hairs(corner);
            const Vec& at = query_.corners[corner];
            if (part.core == Core::middle) return ball_against_line(at, {0, 1, 0}, query_.along, ball);
            return ball_against_point(at - end_of(part.core), query_.along, ball);
        }
        const int i = edge_of(part.corners);
        ball.hairs = query_.edge_hairs(i);
        return ball_against_line(query_.edge_start(i) - end_of(part.core), query_.edge_direction(i), query_.along,
                                 ball);
    }

    const SweepQuery& query_;
    const Capsule& capsule_;
};

}  // namespace

RoundFirst ask_round_first(const SweepQuery& query, const Capsule& capsule, const FaceFirst& face,
                           double limit) noexcept {
    return settle_one_feature(query, CapsuleGuess(query, capsule), face, limit);
}

}  // namespace surefoot::internal
