#include "playtest/report/frame_figures.hpp"

#include <cmath>
#include <string_view>
#include <vector>

#include "playtest/vectors.hpp"

namespace surefoot::playtest {
namespace {

constexpr double pi = 3.14159265358979323846;
constexpr double enemy_feet = 0.6;  // below the middle of an enemy [m]

enum Surface : std::uint32_t {
    fur,
    cream,
    dark,
    white,
    gold,
    pale_gold,
    red,
    iron,
    lamp,
    frog,
    petal,
    clay,
    post,
    grey_cloth,
    green_cloth,
    light,
    flame,
    trace_dot,
    key_red,
    key_blue,
    key_green,
    key_yellow,
    key_violet,
    key_white,
};

constexpr std::array<Paint, 24> paints{{
    {{0.95, 0.47, 0.13}, 0.15}, {{1.00, 0.93, 0.80}, 0.15}, {{0.16, 0.10, 0.12}, 0},    {{1.00, 1.00, 1.00}, 0.2},
    {{0.94, 0.66, 0.13}, 0.3},  {{1.00, 0.89, 0.54}, 0.3},  {{0.79, 0.18, 0.27}, 0},    {{0.36, 0.23, 0.55}, 0},
    {{1.00, 0.82, 0.35}, 0.7},  {{0.49, 0.77, 0.23}, 0},    {{0.24, 0.44, 0.84}, 0.1},  {{0.71, 0.38, 0.24}, 0},
    {{0.88, 0.90, 0.92}, 0},    {{0.54, 0.59, 0.64}, 0},    {{0.18, 0.71, 0.42}, 0.15}, {{0.21, 0.83, 0.88}, 0.6},
    {{1.00, 0.42, 0.23}, 0.8},  {{0.90, 0.15, 0.55}, 0.7},  {{0.89, 0.28, 0.24}, 0.25}, {{0.24, 0.51, 0.90}, 0.25},
    {{0.29, 0.72, 0.35}, 0.25}, {{0.95, 0.76, 0.19}, 0.25}, {{0.61, 0.36, 0.90}, 0.25}, {{0.95, 0.94, 0.90}, 0.25},
}};

Surface key_surface(const std::string& door) {
    static constexpr std::array<std::string_view, 6> names{"red", "blue", "green", "yellow", "violet", "white"};
    std::uint32_t sum = 0;
    for (std::uint32_t i = 0; i < names.size(); ++i)
        if (names[i] == door) return Surface(key_red + i);
    for (const char letter : door) sum = sum * 31 + static_cast<unsigned char>(letter);
    return Surface(key_red + sum % names.size());
}

// Puts a figure together out of balls, drums and boxes about its own origin, which faces -Z.
class Modeller {
public:
    Modeller& ball(const dvec3& at, const dvec3& radii, Surface surface, int around = 14) {
        const int rings = around * 2 / 3;
        return rings_of(rings, around, surface, [&](double ring, double turn) {
            const double tilt = pi * (ring - 0.5);
            return at + dvec3{radii.x * std::cos(tilt) * std::cos(turn), radii.y * std::sin(tilt),
                              radii.z * std::cos(tilt) * std::sin(turn)};
        });
    }

    /// Upright; narrower on top by `taper`, so that 0 is a cone.
    Modeller& drum(const dvec3& at, double radius, double half_height, Surface surface, double taper = 1) {
        return rings_of(3, 16, surface, [&](double ring, double turn) {
            const double wide = ring == 0 || ring == 1 ? 0 : ring < 0.5 ? radius : radius * taper;
            return at + dvec3{wide * std::cos(turn), ring < 0.5 ? -half_height : half_height, wide * std::sin(turn)};
        });
    }

    Modeller& box(const dvec3& at, const dvec3& half, Surface surface) {
        const auto first = std::uint32_t(vertices_.size());
        for (int i = 0; i < 8; ++i)
            vertices_.push_back(vec3(at + dvec3{(i & 1) != 0 ? half.x : -half.x, (i & 2) != 0 ? half.y : -half.y,
                                                (i & 4) != 0 ? half.z : -half.z}));
        for (const std::uint32_t corner : {0U, 2U, 1U, 1U, 2U, 3U, 4U, 5U, 6U, 5U, 7U, 6U, 0U, 1U, 4U, 1U, 5U, 4U,
                                           2U, 6U, 3U, 3U, 6U, 7U, 0U, 4U, 2U, 2U, 4U, 6U, 1U, 3U, 5U, 3U, 7U, 5U})
            indices_.push_back(first + corner);
        surfaces_.resize(indices_.size() / 3, surface);
        return *this;
    }

    [[nodiscard]] Mesh mesh() const {
        return Mesh::build({.vertices = vertices_, .indices = indices_, .surfaces = surfaces_}).value();
    }

private:
    template <typename Place>
    Modeller& rings_of(int rings, int around, Surface surface, const Place& place) {
        const auto first = std::uint32_t(vertices_.size());
        for (int ring = 0; ring <= rings; ++ring)
            for (int i = 0; i < around; ++i)
                vertices_.push_back(vec3(place(double(ring) / rings, 2 * pi * i / around)));
        const auto at = [&](int ring, int i) { return first + std::uint32_t(ring * around + i % around); };
        for (int ring = 0; ring < rings; ++ring)
            for (int i = 0; i < around; ++i)
                for (const std::uint32_t corner : {at(ring, i), at(ring + 1, i), at(ring + 1, i + 1), at(ring, i),
                                                   at(ring + 1, i + 1), at(ring, i + 1)})
                    indices_.push_back(corner);
        surfaces_.resize(indices_.size() / 3, surface);
        return *this;
    }

    std::vector<vec3> vertices_;
    std::vector<std::uint32_t> indices_;
    std::vector<std::uint32_t> surfaces_;
};

// The volume itself, as it meets the world, with a face to see which way it looks and feet to see where they are.
Mesh hero_mesh(const dvec3& radii) {
    Modeller made;
    made.ball({0, 0, 0}, radii, fur, 32);
    for (const double side : {-1.0, 1.0}) {
        const dvec3 brow = radii * dvec3{0.36 * side, 0.55, -0.76};
        made.ball(brow, {0.07, 0.10, 0.05}, white).ball(brow + dvec3{0, -0.01, -0.035}, {0.04, 0.06, 0.03}, dark);
        made.ball(radii * dvec3{0.55 * side, 0.92, 0}, {0.09, 0.16, 0.05}, fur);
    }
    made.ball(radii * dvec3{0, -0.05, -0.25}, radii * dvec3{0.72, 0.62, 0.79}, cream, 24);
    made.ball(radii * dvec3{0, -0.35, 1.1}, {0.11, 0.11, 0.2}, cream);
    return made.mesh();
}

Mesh enemy_mesh(game::EnemyKind kind) {
    Modeller made;
    const auto eyes = [&](double apart, double high, double ahead, double size) {
        for (const double side : {-1.0, 1.0}) {
            made.ball({side * apart, high, -ahead}, {size, size, size * 0.7}, white);
            made.ball({side * apart, high, -ahead - size * 0.5}, {size * 0.5, size * 0.5, size * 0.35}, dark);
        }
    };
    switch (kind) {
        case game::EnemyKind::chaser:
            made.ball({0, 0.36, 0}, {0.44, 0.34, 0.46}, red, 18).ball({0, 0.34, -0.38}, {0.26, 0.23, 0.18}, dark);
            eyes(0.115, 0.43, 0.5, 0.09);
            break;
        case game::EnemyKind::patroller:
            made.drum({0, 0.5, 0}, 0.36, 0.42, iron, 0.8).ball({0, 0.95, 0}, {0.28, 0.24, 0.28}, iron);
            made.ball({0, 0.95, -0.2}, {0.16, 0.12, 0.12}, lamp);
            break;
        case game::EnemyKind::jumper:
            made.ball({0, 0.45, 0}, {0.4, 0.4, 0.4}, frog, 18).drum({0, 0.08, 0}, 0.26, 0.08, post);
            eyes(0.2, 0.82, 0.12, 0.12);
            break;
        case game::EnemyKind::shooter:
            made.drum({0, 0.2, 0}, 0.26, 0.2, clay, 1.25).ball({0, 0.75, 0}, {0.42, 0.42, 0.18}, petal, 18);
            made.ball({0, 0.75, -0.12}, {0.22, 0.22, 0.2}, lamp);
            eyes(0.09, 0.8, 0.3, 0.06);
            break;
    }
    return made.mesh();
}

Mesh pickup_mesh(game::PickupKind kind) {
    Modeller made;
    if (kind == game::PickupKind::coin) made.ball({0, 0, 0}, {0.26, 0.26, 0.06}, gold, 16);
    if (kind == game::PickupKind::star)
        for (int i = 0; i < 5; ++i) {
            const double turn = 2 * pi * i / 5;
            for (const double out : {0.12, 0.24, 0.34, 0.42})
                made.ball({out * std::sin(turn), out * std::cos(turn), 0},
                          {0.21 - 0.42 * out, 0.21 - 0.42 * out, 0.12 - 0.2 * out}, pale_gold, 10);
        }
    if (kind == game::PickupKind::heart)
        for (const double side : {-1.0, 1.0})
            made.ball({side * 0.11, 0.08, 0}, {0.16, 0.18, 0.12}, red)
                .ball({side * 0.06, -0.06, 0}, {0.13, 0.16, 0.11}, red)
                .ball({0, -0.18, 0}, {0.06, 0.12, 0.08}, red);
    return made.mesh();
}

Mesh key_mesh(Surface surface) {
    return Modeller()
        .ball({0, 0.24, 0}, {0.18, 0.18, 0.06}, surface)
        .box({0, -0.1, 0}, {0.05, 0.22, 0.05}, surface)
        .box({0.1, -0.25, 0}, {0.08, 0.04, 0.04}, surface)
        .mesh();
}

Mesh flag_mesh(bool is_reached) {
    Modeller made;
    made.drum({0, 0.05, 0}, 0.28, 0.05, grey_cloth).box({0, 1.15, 0}, {0.04, 1.1, 0.04}, post);
    made.box({0.48, is_reached ? 1.9 : 0.45, 0}, {0.45, 0.24, 0.02}, is_reached ? green_cloth : grey_cloth);
    return made.ball({0, 2.28, 0}, {0.08, 0.08, 0.08}, is_reached ? gold : grey_cloth).mesh();
}

Mesh goal_mesh(double radius) {
    Modeller made;
    made.drum({0, 0.06, 0}, radius, 0.06, post).drum({0, 0.1, 0}, radius * 0.82, 0.05, light);
    for (int i = 0; i < 4; ++i) {
        const double turn = pi / 4 + pi / 2 * i;
        made.box({radius * std::sin(turn), 0.45, radius * std::cos(turn)}, {0.09, 0.45, 0.09}, post);
        made.ball({radius * std::sin(turn), 1.0, radius * std::cos(turn)}, {0.14, 0.14, 0.14}, gold);
    }
    return made.ball({0, 1.75, 0}, {0.45, 0.45, 0.2}, pale_gold).mesh();
}

dvec3 radii_of(const Volume& volume) {
    if (const auto* body = std::get_if<Ellipsoid>(&volume.shape)) return body->radii;
    return {0.35, 0.8, 0.35};
}

// Turned so that -Z is the way that is faced.
Pose facing_pose(const dvec3& place, const dvec3& facing) {
    const double half = std::atan2(-facing.x, -facing.z) / 2;
    return {place, dquat{std::cos(half), 0, std::sin(half), 0}};
}

}  // namespace

const Paint& paint_of(std::uint32_t surface) {
    return paints[surface < paints.size() ? surface : 0];
}

Figures::Figures(const game::Level& level)
    : hero_{hero_mesh(radii_of(game::hero_settings({}).volume)),
            hero_mesh(radii_of(game::hero_settings({}).crouched.value_or(game::hero_settings({}).volume)))},
      enemies_{enemy_mesh(game::EnemyKind::chaser), enemy_mesh(game::EnemyKind::patroller),
               enemy_mesh(game::EnemyKind::jumper), enemy_mesh(game::EnemyKind::shooter)},
      pickups_{pickup_mesh(game::PickupKind::coin), pickup_mesh(game::PickupKind::star),
               pickup_mesh(game::PickupKind::heart)},
      flags_{flag_mesh(false), flag_mesh(true)},
      goal_(goal_mesh(level.goal_radius)),
      bullet_(Modeller().ball({0, 0, 0}, {0.12, 0.12, 0.12}, flame).mesh()),
      dot_(Modeller().ball({0, 0, 0}, {0.06, 0.06, 0.06}, trace_dot, 8).mesh()) {
    for (const game::PickupPlan& plan : level.pickups)
        if (plan.kind == game::PickupKind::key) keys_.insert_or_assign(plan.door, key_mesh(key_surface(plan.door)));
}

World Figures::stage(const game::Game& game, std::span<const dvec3> trail) const {
    World world;
    const auto put = [&](const Mesh& mesh, const Pose& pose, std::uint32_t body = lowest_free_body,
                         std::uint64_t layers = solid) {
        // A place that is no number is not to be seen.
        static_cast<void>(world.add(mesh, {.pose = pose, .body = body, .layers = layers}));
    };
    const game::Level& level = game.level();
    const bool crouches = game.hero().body.form == CharacterForm::crouched;
    put(hero_[crouches ? 1 : 0], facing_pose(game.hero().body.position, game.hero().facing), hero);
    for (const game::Pickup& pickup : game.pickups()) {
        const game::PickupPlan& plan = level.pickups[pickup.plan];
        const double turn = game.seconds() * 3 + plan.place.x + plan.place.z;
        put(plan.kind == game::PickupKind::key ? keys_.at(plan.door) : pickups_[std::size_t(plan.kind)],
            facing_pose(plan.place, {std::sin(turn), 0, std::cos(turn)}));
    }
    for (const game::Enemy& enemy : game.enemies())
        put(enemies_[std::size_t(level.enemies[enemy.plan].kind)],
            facing_pose(enemy.body.position - dvec3{0, enemy_feet, 0}, enemy.facing));
    for (const game::Bullet& bullet : game.bullets()) put(bullet_, {bullet.place});
    for (std::size_t i = 1; i < level.checkpoints.size(); ++i)
        put(flags_[i <= game.checkpoint() ? 1 : 0], {level.checkpoints[i].feet});
    put(goal_, {level.goal});
    for (const dvec3& place : trail) put(dot_, {place}, lowest_free_body, marks);
    return world;
}

}  // namespace surefoot::playtest
