// Surefoot in an engine that has everything already: its own vectors and quaternions, Z up, entities with components
// and a broad phase that it will keep. None of it changes: the grid becomes a triangle source by four small functions,
// Z up is said in the input, and a system of the engine steps the characters. The whole game is then played again on
// meshes of the same triangles, and every tick has to come out as the same bits. Explained in docs/sources.md.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <utility>
#include <vector>

#include <surefoot/surefoot.hpp>

namespace engine {

// What the engine calls a vector and a turn. Nothing of Surefoot is known here.
struct Vec3 {
    float x = 0, y = 0, z = 0;
};
struct Quat {
    float x = 0, y = 0, z = 0, w = 1;
};
struct Triangle {
    Vec3 corners[3];
    std::uint32_t material = 0;
};

/// The broad phase: a grid of square cells, seen from above, each with the triangles whose boxes reach into it.
class Grid {
public:
    struct Cells {
        int x0, y0, x1, y1;
    };

    explicit Grid(std::vector<Triangle> triangles) : triangles_(std::move(triangles)) {
        low_ = high_ = triangles_[0].corners[0];
        for (const Triangle& one : triangles_) {
            for (const Vec3& v : one.corners) {
                low_ = {std::min(low_.x, v.x), std::min(low_.y, v.y), std::min(low_.z, v.z)};
                high_ = {std::max(high_.x, v.x), std::max(high_.y, v.y), std::max(high_.z, v.z)};
            }
        }
        cells_.resize(columns() * columns());
        for (std::uint32_t id = 0; id < triangles_.size(); ++id) {
            const Cells cells = cells_of(id);
            for (int y = cells.y0; y <= cells.y1; ++y) {
                for (int x = cells.x0; x <= cells.x1; ++x) cells_[index(x, y)].push_back(id);
            }
        }
    }

    const Vec3& low() const { return low_; }
    const Vec3& high() const { return high_; }
    const Triangle& triangle(std::uint32_t id) const { return triangles_[id]; }
    std::size_t size() const { return triangles_.size(); }

    Cells cells_between(double x0, double y0, double x1, double y1) const {
        return {cell(x0, low_.x, high_.x), cell(y0, low_.y, high_.y), cell(x1, low_.x, high_.x),
                cell(y1, low_.y, high_.y)};
    }
    Cells cells_of(std::uint32_t id) const {
        const auto& [a, b, c] = triangles_[id].corners;
        return cells_between(std::min({a.x, b.x, c.x}), std::min({a.y, b.y, c.y}), std::max({a.x, b.x, c.x}),
                             std::max({a.y, b.y, c.y}));
    }
    const std::vector<std::uint32_t>& in_cell(int x, int y) const { return cells_[index(x, y)]; }

private:
    static constexpr int side = 32;  // cells
    static constexpr std::size_t columns() { return side; }
    static std::size_t index(int x, int y) { return static_cast<std::size_t>(y * side + x); }
    static int cell(double at, double low, double high) {
        const double share = (at - low) / (high - low);  // grows with `at`: no cell between two is left out
        return static_cast<int>(std::clamp(share * side, 0.0, side - 1.0));
    }

    std::vector<Triangle> triangles_;
    Vec3 low_, high_;
    std::vector<std::vector<std::uint32_t>> cells_;
};

/// A component: values, and whose they are.
using Entity = std::uint32_t;
template <typename Component>
struct Column {
    std::vector<std::pair<Entity, Component>> rows;

    void add(Entity entity, Component value) { rows.emplace_back(entity, std::move(value)); }
    Component& of(Entity entity) {
        for (auto& [owner, value] : rows) {
            if (owner == entity) return value;
        }
        std::abort();  // the caller knows what has which component
    }
};

struct Transform {
    Vec3 position;
    Quat turn;
};
struct Rail {  // goes to and fro
    Vec3 from, to;
    int ticks;
};

}  // namespace engine

namespace {

// [convert]
surefoot::dvec3 to_surefoot(const engine::Vec3& v) {
    return {v.x, v.y, v.z};
}
engine::Vec3 to_engine(const surefoot::dvec3& v) {  // to draw with: the game goes on with the doubles
    return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}
surefoot::Pose to_surefoot(const engine::Transform& transform) {
    const engine::Quat& q = transform.turn;
    return {.position = to_surefoot(transform.position), .orientation = surefoot::dquat(q.w, q.x, q.y, q.z)};
}
// [/convert]

// [source]
/// The grid as a triangle source: a box around all, the triangles near a box, and each by its number.
struct GridSource {
    const engine::Grid& grid;

    surefoot::Bounds bounds() const { return {to_surefoot(grid.low()), to_surefoot(grid.high())}; }
    void visit(const surefoot::Bounds& near, const surefoot::TriangleSink& sink) const {
        const auto asked = grid.cells_between(near.min.x, near.min.y, near.max.x, near.max.y);
        for (int y = asked.y0; y <= asked.y1; ++y) {
            for (int x = asked.x0; x <= asked.x1; ++x) {
                for (const std::uint32_t id : grid.in_cell(x, y)) {
                    // A triangle lies in several cells and may be handed out once: in the first that was asked for.
                    const auto its = grid.cells_of(id);
                    if (x == std::max(its.x0, asked.x0) && y == std::max(its.y0, asked.y0)) {
                        sink(triangle(id), id, surface(id));
                    }
                }
            }
        }
    }
    surefoot::Triangle triangle(std::uint32_t id) const {
        const auto& [a, b, c] = grid.triangle(id).corners;
        return {to_surefoot(a), to_surefoot(b), to_surefoot(c)};
    }
    std::uint32_t surface(std::uint32_t id) const { return grid.triangle(id).material; }
};
// [/source]

struct Solid {  // what characters meet
    explicit Solid(std::vector<engine::Triangle> all) : grid(std::move(all)) {}

    engine::Grid grid;
    GridSource triangles{grid};
    surefoot::VisitedSource source{triangles};  // all queries of it. A world refers to it, so it stays where it is
    surefoot::BodyHandle body;
};
struct Walker {
    surefoot::CharacterSettings settings;
    surefoot::CharacterInput input;
    surefoot::CharacterState state;
};

/// The same triangles as Surefoot's own mesh.
surefoot::Mesh mesh_of(const engine::Grid& grid) {
    std::vector<surefoot::vec3> vertices;
    std::vector<std::uint32_t> indices, surfaces;
    for (std::uint32_t id = 0; id < grid.size(); ++id) {
        for (const engine::Vec3& v : grid.triangle(id).corners) {
            indices.push_back(static_cast<std::uint32_t>(vertices.size()));
            vertices.emplace_back(v.x, v.y, v.z);
        }
        surfaces.push_back(grid.triangle(id).material);
    }
    const auto mesh = surefoot::Mesh::build({.vertices = vertices, .indices = indices, .surfaces = surfaces});
    if (!mesh) std::abort();
    return *mesh;
}

enum class Ground { grids, meshes };

class Game {
public:
    explicit Game(Ground ground) : ground_(ground) {}

    void add_solid(engine::Entity entity, const engine::Transform& transform, std::vector<engine::Triangle> triangles) {
        auto solid = std::make_unique<Solid>(std::move(triangles));
        const surefoot::Placement placement{.pose = to_surefoot(transform), .body = entity};
        const auto added = ground_ == Ground::meshes ? world_.add(mesh_of(solid->grid), placement)
                                                     : world_.add(solid->source, placement);
        if (!added) std::abort();
        solid->body = *added;
        solids_.add(entity, std::move(solid));
        transforms_.add(entity, transform);
    }
    void add_rail(engine::Entity entity, const engine::Rail& rail) { rails_.add(entity, rail); }
    void add_walker(engine::Entity entity, const engine::Vec3& place) {
        Walker walker;
        walker.input.up = {0, 0, 1};  // Z is up in this engine. The body's own Y follows it
        walker.state.position = to_surefoot(place);
        walkers_.add(entity, walker);
        transforms_.add(entity, {place, {}});
    }
    Walker& walker(engine::Entity entity) { return walkers_.of(entity); }
    const engine::Transform& transform(engine::Entity entity) { return transforms_.of(entity); }

    // [systems]
    /// The engine's systems, in the order of a tick.
    void tick(int number) {
        world_.begin_tick();
        for (auto& [entity, rail] : rails_.rows) {
            const int phase = number % (2 * rail.ticks);
            const float share = static_cast<float>(phase < rail.ticks ? phase : 2 * rail.ticks - phase) /
                                static_cast<float>(rail.ticks);
            engine::Transform& transform = transforms_.of(entity);
            transform.position = {rail.from.x + share * (rail.to.x - rail.from.x),
                                  rail.from.y + share * (rail.to.y - rail.from.y),
                                  rail.from.z + share * (rail.to.z - rail.from.z)};
            if (!world_.move(solids_.of(entity)->body, to_surefoot(transform))) std::abort();
        }
        for (auto& [entity, walker] : walkers_.rows) {
            walker.state = step(world_, walker.settings, walker.input, 1.0 / 60, walker.state).state;
            transforms_.of(entity).position = to_engine(walker.state.position);
        }
    }
    // [/systems]

private:
    Ground ground_;
    surefoot::World world_;
    engine::Column<engine::Transform> transforms_;
    engine::Column<engine::Rail> rails_;
    engine::Column<std::unique_ptr<Solid>> solids_;
    engine::Column<Walker> walkers_;
};

void add_quad(std::vector<engine::Triangle>& to, const engine::Vec3& a, const engine::Vec3& b, const engine::Vec3& c,
              const engine::Vec3& d, std::uint32_t material) {
    to.push_back({{a, b, c}, material});
    to.push_back({{a, c, d}, material});
}

/// Rough ground, and stairs on it.
std::vector<engine::Triangle> make_ground() {
    std::vector<engine::Triangle> all;
    const auto at = [](int x, int y) {
        const int bump = (x * 7 + y * 13 + x * y) % 5;
        return engine::Vec3{static_cast<float>(x - 20), static_cast<float>(y - 20), 0.08F * static_cast<float>(bump)};
    };
    for (int y = 0; y < 40; ++y) {
        for (int x = 0; x < 40; ++x) add_quad(all, at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1), 1);
    }
    for (int i = 0; i < 6; ++i) {  // each step a front and a tread, from x = 6 on
        const float x0 = 6 + 0.4F * static_cast<float>(i), x1 = i == 5 ? 12.0F : x0 + 0.4F;
        const float z0 = 0.25F * static_cast<float>(i), z1 = z0 + 0.25F;
        add_quad(all, {x0, 3, z0}, {x0, -3, z0}, {x0, -3, z1}, {x0, 3, z1}, 2);
        add_quad(all, {x0, -3, z1}, {x1, -3, z1}, {x1, 3, z1}, {x0, 3, z1}, 2);
    }
    return all;
}

std::vector<engine::Triangle> make_lift() {
    std::vector<engine::Triangle> all;
    add_quad(all, {-2, -2, 0}, {2, -2, 0}, {2, 2, 0}, {-2, 2, 0}, 3);
    return all;
}

constexpr engine::Entity ground = 1, lift = 2, hero = 10;

std::unique_ptr<Game> make_game(Ground kind) {
    auto game = std::make_unique<Game>(kind);
    game->add_solid(ground, {}, make_ground());
    game->add_solid(lift, {{-8, 0, 0.4F}, {}}, make_lift());
    game->add_rail(lift, {{-8, 0, 0.4F}, {-8, 0, 3}, 240});
    game->add_walker(hero, {0, 0, 2});
    return game;
}

/// Up the stairs, back, on to the lift when it is down, and up with it.
surefoot::dvec3 wish_at(int tick) {
    if (tick < 150) return {5, 0, 0};
    if (tick < 340 || (tick > 465 && tick < 515)) return {-5, 0, 0};
    return {0, 0, 0};
}

}  // namespace

int main() {
    const auto on_grids = make_game(Ground::grids);
    const auto on_meshes = make_game(Ground::meshes);
    float top_of_stairs = 0;
    float highest_ride = 0;
    for (int tick = 0; tick < 900; ++tick) {
        for (const auto& game : {on_grids.get(), on_meshes.get()}) {
            game->walker(hero).input.wish = wish_at(tick);
            game->tick(tick);
        }
        const surefoot::CharacterState& state = on_grids->walker(hero).state;
        if (hash(state) != hash(on_meshes->walker(hero).state)) {
            return std::printf("tick %d: the grid and the mesh differ\n", tick), 1;
        }
        const float height = on_grids->transform(hero).position.z;
        if (state.ground_surface == 2) top_of_stairs = std::max(top_of_stairs, height);
        if (state.ground_surface == 3) highest_ride = std::max(highest_ride, height);
    }
    std::printf("up the stairs to %.2f m, up with the lift to %.2f m; grid and mesh agree in each bit of 900 ticks\n",
                static_cast<double>(top_of_stairs), static_cast<double>(highest_ride));
    const bool up = std::abs(top_of_stairs - (1.5F + 0.91F)) < 0.01F && std::abs(highest_ride - (3 + 0.91F)) < 0.01F;
    return up ? 0 : 1;
}
