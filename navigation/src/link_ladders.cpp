#include "link_ladders.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace surefoot::navigation {
namespace {

/// Triangles of one ladder face one way to this cosine, and lie in one plane to this distance [m].
constexpr double same_way = 0.98;
constexpr double same_plane = 0.05;
/// What is steeper counts as a face to climb: its normal's part along up is less.
constexpr double steep = 0.7;

/// A face that is climbed.
struct Ladder {
    dvec3 normal{0, 0, 0};  ///< level, unit
    dvec3 aside{0, 0, 0};   ///< level, unit, along its width
    double plane = 0;       ///< along the normal
    double left = 0;        ///< along `aside`
    double right = 0;
    double low = 0;  ///< along up
    double high = 0;

    [[nodiscard]] bool touches(const Ladder& other) const {
        return std::abs(dot(normal, other.normal)) > same_way &&
               std::abs(plane - std::copysign(1.0, dot(normal, other.normal)) * other.plane) < same_plane &&
               overlaps(other);
    }
    [[nodiscard]] bool overlaps(const Ladder& other) const {
        const bool turned = dot(normal, other.normal) < 0;
        const double others_left = turned ? -other.right : other.left;
        const double others_right = turned ? -other.left : other.right;
        return left <= others_right + same_plane && right >= others_left - same_plane &&
               low <= other.high + same_plane && high >= other.low - same_plane;
    }
    void take(const Ladder& other) {
        const bool turned = dot(normal, other.normal) < 0;
        left = std::min(left, turned ? -other.right : other.left);
        right = std::max(right, turned ? -other.left : other.right);
        low = std::min(low, other.low);
        high = std::max(high, other.high);
    }
};

std::vector<Ladder> faces(const LinkGround& ground) {
    const MeshState& state = ground.mesh.state();
    const Plan& plan = state.plan;
    const Bounds all = bounds_out(plan.frame, {0, plan.low, 0},
                                  {plan.tile_size * plan.tiles_x, plan.high, plan.tile_size * plan.tiles_z});
    const auto climbed = [&](std::uint32_t, std::uint32_t, std::uint32_t surface) {
        return ground.settings.surfaces[surface].ladder;
    };
    const WorldQuery query{.layers = plan.layers, .triangles = climbed};
    std::vector<SourceTriangle> found(1024);
    for (std::size_t count = 0; (count = ground.world.gather(all, found, query)) > found.size();) found.resize(count);
    found.resize(ground.world.gather(all, found, query));
    std::vector<Ladder> ladders;
    const dvec3 up = ground.mesh.up();
    for (const SourceTriangle& source : found) {
        const Triangle& triangle = source.triangle;
        const dvec3 normal = cross(triangle.b - triangle.a, triangle.c - triangle.a);
        const dvec3 level = normal - up * dot(normal, up);
        const double size = length(level);
        if (!ground.settings.surfaces[source.surface].ladder || !(size > 0) ||
            std::abs(dot(normal, up)) > steep * length(normal))
            continue;
        Ladder ladder;
        ladder.normal = level / size;
        ladder.aside = cross(up, ladder.normal);
        ladder.plane = dot(triangle.a, ladder.normal);
        ladder.left = ladder.low = 1e300;
        ladder.right = ladder.high = -1e300;
        for (const dvec3& corner : {triangle.a, triangle.b, triangle.c}) {
            ladder.left = std::min(ladder.left, dot(corner, ladder.aside));
            ladder.right = std::max(ladder.right, dot(corner, ladder.aside));
            ladder.low = std::min(ladder.low, dot(corner, up));
            ladder.high = std::max(ladder.high, dot(corner, up));
        }
        ladders.push_back(ladder);
    }
    return ladders;
}

/// Faces that touch become one, until none do.
std::vector<Ladder> whole(const std::vector<Ladder>& faces) {
    std::vector<Ladder> ladders;
    for (Ladder ladder : faces) {
        for (std::size_t i = 0; i < ladders.size();) {
            if (!ladder.touches(ladders[i])) {
                ++i;
                continue;
            }
            ladder.take(ladders[i]);
            ladders.erase(ladders.begin() + static_cast<std::ptrdiff_t>(i));
            i = 0;
        }
        ladders.push_back(ladder);
    }
    return ladders;
}

}  // namespace

std::vector<LinkProposal> ladder_proposals(const LinkGround& ground) {
    std::vector<LinkProposal> proposals;
    if (!(ground.settings.ladder_speed > 0) ||
        std::none_of(ground.settings.surfaces.all().begin(), ground.settings.surfaces.all().end(),
                     [](const SurfaceRule& rule) { return rule.ladder; }))
        return proposals;
    const NavigationQuery query(ground.mesh, 16, NavigationDoors::open);
    const NavigationAgent& agent = ground.mesh.agent();
    const dvec3 up = ground.mesh.up();
    const double vertical = agent.climb + 0.3;
    for (const Ladder& ladder : whole(faces(ground))) {
        const double width = ladder.right - ladder.left;
        const int count = std::max(1, static_cast<int>(width / ground.options.spacing));
        for (int i = 0; i < count; ++i) {
            const double at = ladder.left + width * (i + 0.5) / count;
            for (const double side : {1.0, -1.0}) {
                const dvec3 foot = ladder.normal * ladder.plane + ladder.aside * at + up * ladder.low;
                const dvec3 head = foot + up * (ladder.high - ladder.low);
                const dvec3 towards = ladder.normal * side;
                const auto from = query.nearest(foot + towards * agent.radius, agent.radius, vertical);
                const auto to = query.nearest(head - towards * (2 * agent.radius), 2 * agent.radius, vertical);
                if (!from || !to || !(dot(to->position - from->position, up) > agent.climb)) continue;
                LinkProposal proposal{.link = {},
                                      .from_island = ground.islands.of(from->polygon.id),
                                      .to_island = ground.islands.of(to->polygon.id)};
                NavigationLink& link = proposal.link;
                link.from = link.takeoff = from->position;
                link.to = to->position;
                link.kind = NavigationLinkKind::ladder;
                link.speed = ground.options.run_speed;
                link.seconds = (ladder.high - ladder.low) / ground.settings.ladder_speed + 1;
                proposals.push_back(proposal);
                std::swap(proposal.from_island, proposal.to_island);
                std::swap(link.from, link.to);
                link.takeoff = link.from;
                link.seconds += 1;
                proposals.push_back(proposal);
            }
        }
    }
    return proposals;
}

}  // namespace surefoot::navigation
