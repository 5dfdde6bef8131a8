#include "playtest/bots/passages.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "game/route.hpp"
#include "playtest/bots/foresight.hpp"
#include "playtest/vectors.hpp"

namespace surefoot::playtest {
namespace {

constexpr double between_spots = 0.45;   // on a body [m]
constexpr double between_borders = 1.2;  // along the mesh [m]
constexpr double farthest_gap = 6;       // by two jumps [m]
constexpr double deepest_drop = 16;      // that is jumped down [m]

// What a hop costs by what has to be done for it [s].
double effort(double gap, double rise) {
    return 0.4 + 0.3 * gap + (gap > 3 || rise > 1.2 ? 2.5 : 0) + 0.5 * std::max(0.0, rise);
}

}  // namespace

bool is_in_reach(double gap, double rise) {
    if (rise < -deepest_drop || rise > 3.4) return false;
    return gap <= (rise <= 0.8 ? farthest_gap : rise <= 2.2 ? 4.6 : 2.2);
}

Passages::Passages(const Atlas& atlas, NavigationMesh mesh)
    : atlas_(&atlas),
      mesh_(std::make_unique<NavigationMesh>(std::move(mesh))),
      query_(std::make_unique<NavigationQuery>(*mesh_)) {}

Expected<Passages> Passages::make(const Atlas& atlas) {
    auto mesh = atlas.mesh();
    if (!mesh) return tl::unexpected(mesh.error());
    Passages made(atlas, std::move(*mesh));
    made.outlines_.resize(made.mesh_->outlines({}));
    (void)made.mesh_->outlines(made.outlines_);
    made.find_islands();
    made.find_spots();
    made.find_rides();
    made.find_transfers();
    made.find_ways();
    made.find_banks();
    made.add_leaps();
    return made;
}

std::uint32_t Passages::island_of(NavigationPolygon polygon) const {
    const auto at =
        std::ranges::lower_bound(island_by_polygon_, polygon.id, {}, &std::pair<std::uint32_t, std::uint32_t>::first);
    return at != island_by_polygon_.end() && at->first == polygon.id ? at->second
                                                                     : std::numeric_limits<std::uint32_t>::max();
}

// Pieces of ground that are one on foot, and where they end.
void Passages::find_islands() {
    const std::span<const NavigationArea> areas = mesh_->areas();
    const auto is_open = [&](const NavigationOutline& outline) {
        return !outline.taken_out && !areas[outline.area].closed;
    };
    std::vector<std::pair<std::uint32_t, std::uint32_t>> place;
    for (std::uint32_t i = 0; i < outlines_.size(); ++i) place.push_back({outlines_[i].polygon.id, i});
    std::ranges::sort(place);
    std::vector<std::uint32_t> parent(outlines_.size());
    std::iota(parent.begin(), parent.end(), 0U);
    const auto root = [&](std::uint32_t i) {
        while (parent[i] != i) i = parent[i] = parent[parent[i]];
        return i;
    };
    for (std::uint32_t i = 0; i < outlines_.size(); ++i) {
        if (!is_open(outlines_[i])) continue;
        for (std::uint32_t side = 0; side < outlines_[i].corners; ++side) {
            const auto at = std::ranges::lower_bound(place, outlines_[i].beside[side].id, {},
                                                     &std::pair<std::uint32_t, std::uint32_t>::first);
            if (at != place.end() && at->first == outlines_[i].beside[side].id && is_open(outlines_[at->second]))
                parent[root(i)] = root(at->second);
        }
    }
    islands_ = std::uint32_t(outlines_.size());
    island_by_polygon_.clear();
    for (std::uint32_t i = 0; i < outlines_.size(); ++i)
        island_by_polygon_.push_back({outlines_[i].polygon.id, root(i)});
    std::ranges::sort(island_by_polygon_);

    borders_.clear();
    for (std::uint32_t i = 0; i < outlines_.size(); ++i) {
        const NavigationOutline& outline = outlines_[i];
        if (!is_open(outline)) continue;
        for (std::uint32_t side = 0; side < outline.corners; ++side) {
            if (outline.beside[side]) continue;
            const dvec3 a = outline.corner[side];
            const dvec3 b = outline.corner[(side + 1) % outline.corners];
            const int steps = std::max(1, int(length(b - a) / between_borders));
            for (int k = 0; k < steps; ++k) borders_.push_back({a + (b - a) * ((k + 0.5) / steps), root(i)});
        }
    }
    links_.clear();
    for (const NavigationLink& link : mesh_->links()) {
        const auto from = query_->nearest(link.from, 0.5, 0.6);
        const auto to = query_->nearest(link.to, 0.5, 0.6);
        if (!from || !to) continue;
        links_.push_back({link.from, link.to, island_of(from->polygon), island_of(to->polygon), link.seconds});
    }
    for (Passage& passage : all_)
        for (Stand* stand : {&passage.from, &passage.to})
            if (stand->body == on_ground)
                if (const auto at = stand_at(stand->place)) stand->island = at->island;
}

void Passages::open_door(std::uint32_t area) {
    (void)mesh_->set_area(area, false);
    find_islands();
}

std::optional<Stand> Passages::stand_at(const dvec3& feet, double aside, double vertical) const {
    auto at = query_->nearest(feet, 0.4, 0.6);
    if (!at) at = query_->nearest(feet, aside, vertical);
    if (!at) return std::nullopt;
    return Stand{.place = at->position, .island = island_of(at->polygon)};
}

// Rays from above on to each body that can be stood on.
void Passages::find_spots() {
    const std::vector<game::BodyPlan>& bodies = atlas_->level().bodies;
    spots_.resize(bodies.size());
    rims_.resize(bodies.size());
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        if (bodies[i].kind == game::BodyKind::door || bodies[i].kind == game::BodyKind::hazard) continue;
        const Bounds box = bodies[i].mesh.bounds();
        const auto top = [&](double x, double z) -> std::optional<dvec3> {
            const auto hit = bodies[i].mesh.ray({{x, box.max.y + 1, z}, {x, box.min.y - 1, z}});
            if (!hit || hit->normal.y < 0.75) return std::nullopt;
            return hit->point;
        };
        const int wide = std::clamp(int((box.max.x - box.min.x) / between_spots), 1, 40);
        const int deep = std::clamp(int((box.max.z - box.min.z) / between_spots), 1, 40);
        for (int x = 0; x < wide; ++x)
            for (int z = 0; z < deep; ++z) {
                const auto spot = top(box.min.x + (box.max.x - box.min.x) * (x + 0.5) / wide,
                                      box.min.z + (box.max.z - box.min.z) * (z + 0.5) / deep);
                if (!spot) continue;
                int held = 0;
                int held_far = 0;
                for (const dvec3 aside : {dvec3{1, 0, 0}, dvec3{-1, 0, 0}, dvec3{0, 0, 1}, dvec3{0, 0, -1}}) {
                    const auto near = top(spot->x + 0.35 * aside.x, spot->z + 0.35 * aside.z);
                    const auto far = top(spot->x + 0.9 * aside.x, spot->z + 0.9 * aside.z);
                    if (near && std::abs(near->y - spot->y) < 0.3) ++held;
                    if (far && std::abs(far->y - spot->y) < 0.3) ++held_far;
                }
                if (held < 4) continue;
                spots_[i].push_back(*spot);
                if (held_far < 4) rims_[i].push_back(*spot);
            }
        if (spots_[i].empty())
            if (const auto spot = top((box.min.x + box.max.x) / 2, (box.min.z + box.max.z) / 2))
                spots_[i].push_back(*spot);
        if (rims_[i].empty()) rims_[i] = spots_[i];
    }
}

bool Passages::is_one_way(std::uint32_t surface) const {
    const std::vector<SurfaceRule>& rules = atlas_->level().rules;
    return surface < rules.size() && rules[surface].one_way;
}

bool Passages::is_walled(const dvec3& from, const dvec3& to) const {
    const auto is_solid = [&](std::uint32_t, std::uint32_t, std::uint32_t surface) { return !is_one_way(surface); };
    const auto is_blocked = [&](const dvec3& a, const dvec3& b) {
        return atlas_->ground().ray_any({a, b}, {.triangles = is_solid});
    };
    for (const double lift : {0.9, 2.2, 3.4}) {
        const dvec3 up{0, lift, 0};
        const double over = std::max(from.y, to.y);
        const dvec3 a{from.x, lift < 1 ? from.y : over, from.z};
        const dvec3 b{to.x, lift < 1 ? to.y : over, to.z};
        if (!is_blocked(a + up, b + up) && !is_blocked(from + dvec3{0, 0.9, 0}, a + up) &&
            !is_blocked(b + up, to + dvec3{0, 0.9, 0}))
            return false;
    }
    return true;
}

void Passages::find_rides() {
    for (std::size_t i = 0; i < spots_.size(); ++i)
        if (!spots_[i].empty()) find_rides_of(i);
}

// Ground close around a body, or a little below or above its rim: of what stands in the middle of an island, too.
std::vector<Passages::Border> Passages::beside_body(const std::vector<dvec3>& rims, const dvec3& middle) const {
    constexpr std::size_t directions = 10;
    std::vector<Border> found;
    for (std::size_t i = 0; i < rims.size(); i += 1 + rims.size() / directions) {
        const dvec3 out = unit(flat(rims[i] - middle));
        if (const auto at = query_->nearest(rims[i] + out * 1.0, 0.3, 1.3))
            found.push_back({at->position, island_of(at->polygon)});
    }
    return found;
}

// For each island the place from which it is the shortest hop on, and on to which the shortest off.
void Passages::find_rides_of(std::size_t body) {
    const game::BodyPlan& plan = atlas_->level().bodies[body];
    const bool throws = plan.kind == game::BodyKind::bounce;
    struct Best {
        std::uint32_t island = 0;
        Passage on;
        Passage off;
        double on_cost = std::numeric_limits<double>::max();
        double off_cost = std::numeric_limits<double>::max();
    };
    std::vector<Best> best;
    const double round = game::round_time(plan.route);
    for (const double clock : clocks_of(plan)) {
        const Pose pose = pose_at(plan, clock);
        Bounds around{{1e300, 1e300, 1e300}, {-1e300, -1e300, -1e300}};
        std::vector<dvec3> rims;
        for (const dvec3& rim : rims_[body]) {
            rims.push_back(to_world(pose, rim));
            for (int i = 0; i < 3; ++i) {
                around.min[i] = std::min(around.min[i], rims.back()[i]);
                around.max[i] = std::max(around.max[i], rims.back()[i]);
            }
        }
        std::vector<Border> beside = beside_body(rims, (around.min + around.max) * 0.5);
        beside.insert(beside.end(), borders_.begin(), borders_.end());
        for (const Border& border : beside) {
            if (border.place.x < around.min.x - farthest_gap - 1 || border.place.x > around.max.x + farthest_gap + 1 ||
                border.place.z < around.min.z - farthest_gap - 1 || border.place.z > around.max.z + farthest_gap + 1 ||
                std::abs(border.place.y - around.min.y) > 20)
                continue;
            double gap = std::numeric_limits<double>::max();
            dvec3 nearest = rims.front();
            for (const dvec3& rim : rims)
                if (const double far = flat_length(rim - border.place); far < gap) {
                    gap = far;
                    nearest = rim;
                }
            gap = std::max(0.0, gap - 0.5);  // from edge to edge
            const double rise = nearest.y - border.place.y;
            const bool gets_on = is_in_reach(gap, rise);
            const bool gets_off = throws ? false : is_in_reach(gap, -rise);
            if (!gets_on && !gets_off) continue;
            auto found = std::ranges::find(best, border.island, &Best::island);
            if (found == best.end())
                found = best.insert(best.end(), Best{.island = border.island, .on = {}, .off = {}});
            const double on_cost = effort(gap, rise);
            const double off_cost = effort(gap, -rise);
            const bool better_on = gets_on && on_cost < found->on_cost - 1e-3;
            const bool better_off = gets_off && off_cost < found->off_cost - 1e-3;
            if ((!better_on && !better_off) || is_walled(border.place, nearest)) continue;
            const Stand there{.place = border.place, .island = border.island};
            const Stand here{.body = std::uint32_t(body), .place = nearest};
            if (better_on) {
                found->on_cost = on_cost;
                found->on = {Passage::How::board, there, here, game::Manoeuvre::ride, gap, rise, on_cost + round / 2};
            }
            if (better_off) {
                found->off_cost = off_cost;
                found->off = {Passage::How::alight, here, there, game::Manoeuvre::ride, gap, -rise,
                              off_cost + round / 2};
            }
        }
    }
    for (const Best& of : best) {
        if (of.on_cost < 1e300) all_.push_back(of.on);
        if (of.off_cost < 1e300) all_.push_back(of.off);
    }
}

void Passages::find_transfers() {
    const std::vector<game::BodyPlan>& bodies = atlas_->level().bodies;
    for (std::size_t a = 0; a < bodies.size(); ++a)
        for (std::size_t b = 0; b < bodies.size(); ++b) {
            if (a == b || rims_[a].empty() || rims_[b].empty() || bodies[a].kind == game::BodyKind::bounce) continue;
            // Those that wait can be anywhere when the other comes by; the rest run on one clock.
            const bool independent = bodies[a].route.waits || bodies[b].route.waits;
            double best = std::numeric_limits<double>::max();
            Passage found;
            const auto look = [&](const Pose& pose_a, const Pose& pose_b) {
                if (length(pose_a.position - pose_b.position) > 30) return;
                for (const dvec3& from : rims_[a])
                    for (const dvec3& to : rims_[b]) {
                        const dvec3 begin = to_world(pose_a, from);
                        const dvec3 end = to_world(pose_b, to);
                        const double gap = std::max(0.0, flat_length(end - begin) - 1.0);
                        if (!is_in_reach(gap, end.y - begin.y) || effort(gap, end.y - begin.y) >= best - 1e-3) continue;
                        if (is_walled(begin, end)) continue;
                        best = effort(gap, end.y - begin.y);
                        found = {Passage::How::transfer,
                                 {.body = std::uint32_t(a), .place = begin},
                                 {.body = std::uint32_t(b), .place = end},
                                 game::Manoeuvre::ride,
                                 gap,
                                 end.y - begin.y,
                                 best};
                    }
            };
            if (independent) {
                for (const double clock_a : clocks_of(bodies[a]))
                    for (const double clock_b : clocks_of(bodies[b]))
                        look(pose_at(bodies[a], clock_a), pose_at(bodies[b], clock_b));
            } else {
                const bool moves = game::round_time(bodies[a].route) > 0 || game::round_time(bodies[b].route) > 0 ||
                                   bodies[a].route.deg_per_s != 0 || bodies[b].route.deg_per_s != 0;
                for (int i = 0; i < (moves ? 96 : 1); ++i)
                    look(pose_at(bodies[a], bodies[a].route.phase + i * 0.37),
                         pose_at(bodies[b], bodies[b].route.phase + i * 0.37));
            }
            if (best < 1e300) {
                found.seconds = best + (game::round_time(bodies[a].route) + game::round_time(bodies[b].route)) / 2;
                all_.push_back(found);
            }
        }
}

void Passages::find_ways() {
    const game::Level& level = atlas_->level();
    for (const game::Way& way : level.ways) {
        if (way.how == game::Manoeuvre::ride) continue;
        const auto from = stand_at(way.from, 2, 2);
        const auto to = stand_at(way.to, 2.5, 2.5);
        if (!to) continue;
        const double seconds = 2 + length(way.to - way.from) / 2.5;
        if (way.how == game::Manoeuvre::bounce) {
            const auto is_pad_near = [&](std::size_t body, const dvec3& place, double far) {
                return level.bodies[body].kind == game::BodyKind::bounce && !spots_[body].empty() &&
                       flat_length(level.bodies[body].origin - place) < far &&
                       std::abs(level.bodies[body].origin.y - place.y) < far;
            };
            // From pad to pad it does not come to stand in between.
            Stand end = *to;
            for (std::size_t i = 0; i < level.bodies.size(); ++i)
                if (is_pad_near(i, way.to, 1.5)) end = {.body = std::uint32_t(i), .place = level.bodies[i].origin};
            for (std::size_t i = 0; i < level.bodies.size(); ++i)
                if (is_pad_near(i, way.from, 4))
                    all_.push_back({Passage::How::fly,
                                    {.body = std::uint32_t(i), .place = level.bodies[i].origin},
                                    end,
                                    way.how,
                                    0,
                                    0,
                                    seconds});
            continue;
        }
        if (from) all_.push_back({Passage::How::way, *from, *to, way.how, 0, way.to.y - way.from.y, seconds});
    }
    // What throws leads up to whatever ground is near and in reach, whether or not anybody named it.
    for (std::size_t i = 0; i < level.bodies.size(); ++i) {
        const game::BodyPlan& plan = level.bodies[i];
        if (plan.kind != game::BodyKind::bounce || spots_[i].empty()) continue;
        const dvec3 top = plan.origin + spots_[i][spots_[i].size() / 2];
        const double height = plan.bounce * plan.bounce / (2 * atlas_->settings().gravity);
        std::vector<std::pair<double, Border>> found;
        for (const Border& border : borders_) {
            const double rise = border.place.y - top.y;
            const double far = flat_length(border.place - top);
            if (rise < -2 || rise > height - 0.4 || far > 5 ||
                is_walled(top + dvec3{0, std::max(0.0, rise), 0}, border.place))
                continue;
            const auto same =
                std::ranges::find_if(found, [&](const auto& other) { return other.second.island == border.island; });
            if (same == found.end())
                found.push_back({far, border});
            else if (far < same->first)
                *same = {far, border};
        }
        for (const auto& [far, border] : found)
            all_.push_back({Passage::How::fly,
                            {.body = std::uint32_t(i), .place = top},
                            {.place = border.place, .island = border.island},
                            game::Manoeuvre::bounce,
                            far,
                            border.place.y - top.y,
                            2.5});
    }
}

}  // namespace surefoot::playtest
