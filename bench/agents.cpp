#include "agents.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <vector>

#include <surefoot/navigation_crowd.hpp>
#include <surefoot/surefoot.hpp>

#include "clock.hpp"

namespace surefoot::bench {
namespace {

constexpr double dt = 1.0 / 60;
constexpr double apart = 8;       // houses, from middle to middle [m]
constexpr double half_house = 2;  // [m]

/// A square with houses in rows.
Mesh town(std::size_t blocks) {
    std::vector<vec3> corners;
    std::vector<std::uint32_t> triangles;
    const auto quad = [&](const vec3& a, const vec3& b, const vec3& c, const vec3& d) {
        const auto first = static_cast<std::uint32_t>(corners.size());
        corners.insert(corners.end(), {a, b, c, d});
        for (const std::uint32_t corner : {0U, 1U, 2U, 0U, 2U, 3U}) triangles.push_back(first + corner);
    };
    const auto half = static_cast<float>(apart * static_cast<double>(blocks) / 2);
    quad({-half, 0, -half}, {-half, 0, half}, {half, 0, half}, {half, 0, -half});
    for (std::size_t i = 0; i < blocks; ++i) {
        for (std::size_t k = 0; k < blocks; ++k) {
            const auto x = static_cast<float>(apart * (static_cast<double>(i) + 0.5)) - half;
            const auto z = static_cast<float>(apart * (static_cast<double>(k) + 0.5)) - half;
            const auto h = static_cast<float>(half_house);
            const float top = 3;
            quad({x - h, 0, z - h}, {x - h, 0, z + h}, {x - h, top, z + h}, {x - h, top, z - h});
            quad({x + h, 0, z + h}, {x + h, 0, z - h}, {x + h, top, z - h}, {x + h, top, z + h});
            quad({x - h, 0, z + h}, {x + h, 0, z + h}, {x + h, top, z + h}, {x - h, top, z + h});
            quad({x + h, 0, z - h}, {x - h, 0, z - h}, {x - h, top, z - h}, {x + h, top, z - h});
        }
    }
    const auto mesh = Mesh::build({.vertices = corners, .indices = triangles});
    if (!mesh) throw std::runtime_error(mesh.error().text);
    return *mesh;
}

double quantile(std::vector<double> values, double share) {
    if (values.empty()) return 0;
    std::sort(values.begin(), values.end());
    return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1) + 0.5)];
}

class Town {
public:
    explicit Town(const AgentsOptions& options)
        : blocks_(options.blocks),
          world_(made(options.blocks)),
          mesh_(built(world_, settings_)),
          worker_(mesh_),
          crowd_(mesh_, options.agents,
                 {.avoidance = static_cast<NavigationAvoidance>(options.avoidance), .range = options.range}),
          states_(options.agents),
          inputs_(options.agents) {
        for (std::size_t i = 0; i < options.agents; ++i)
            states_[i].position = place(i) + dvec3{0, mesh_.agent().feet + settings_.skin, 0};
        if (!feet_.reserve(options.agents)) throw std::runtime_error("no memory for the crowd");
        for (std::size_t i = 0; i < options.agents; ++i) send(i);
    }

    void tick() {
        for (std::size_t i = 0; i < states_.size(); ++i) {
            const NavigationFollower& follower = crowd_.follower(i);
            if (follower.status() == NavigationFollowStatus::following) continue;
            arrivals += follower.status() == NavigationFollowStatus::arrived ? 1 : 0;
            gave_up += follower.status() == NavigationFollowStatus::gave_up ? 1 : 0;
            plans += follower.plans();
            send(i);
        }
        const double begin = thread_seconds();
        if (!crowd_.gather(states_)) throw std::runtime_error("the crowd does not fit");
        crowd_.steer(worker_, settings_, dt, inputs_);
        const double steered = thread_seconds();
        const Characters all{.settings = {&settings_, 1}, .inputs = inputs_, .before = states_, .after = states_};
        if (!feet_.gather(all, dt)) throw std::runtime_error("no memory for the crowd");
        step_all(world_, feet_, all, dt);
        const double end = thread_seconds();
        steering.push_back(steered - begin);
        stepping.push_back(end - steered);
        ticks.push_back(end - begin);
    }

    [[nodiscard]] double speed() const {
        double sum = 0;
        for (const CharacterState& state : states_) sum += std::hypot(state.velocity.x, state.velocity.z);
        return sum / static_cast<double>(states_.size());
    }
    [[nodiscard]] double touching() const {
        const auto touches = [&](const CharacterState& one) {
            return std::any_of(states_.begin(), states_.end(), [&](const CharacterState& other) {
                return &one != &other && std::hypot(one.position.x - other.position.x,
                                                    one.position.z - other.position.z) < 2 * mesh_.agent().radius;
            });
        };
        return static_cast<double>(std::count_if(states_.begin(), states_.end(), touches)) /
               static_cast<double>(states_.size());
    }
    [[nodiscard]] std::size_t polygons() const { return mesh_.report().polygons; }

    std::vector<double> steering, stepping, ticks;
    std::size_t arrivals = 0, gave_up = 0, plans = 0;

private:
    static World made(std::size_t blocks) {
        World world;
        if (const auto added = world.add(town(blocks)); !added) throw std::runtime_error(added.error().text);
        return world;
    }
    static NavigationMesh built(const World& world, const CharacterSettings& settings) {
        auto mesh = NavigationMesh::build(world, settings, {.threads = 1});
        if (!mesh) throw std::runtime_error(mesh.error().text);
        return std::move(*mesh);
    }
    /// Somewhere in the streets; there is ground inside of the houses as well, but no door.
    [[nodiscard]] dvec3 place(std::uint64_t seed) const {
        for (std::uint64_t i = 0; i < 1000; ++i) {
            const auto found = worker_.query().random(1000 * seed + i);
            if (!found) break;
            const auto from_house = [&](double along) {
                const double cells = along / apart + 0.5 * static_cast<double>(blocks_);
                return apart * std::abs(cells - std::floor(cells) - 0.5);
            };
            if (std::max(from_house(found->position.x), from_house(found->position.z)) > half_house)
                return found->position;
        }
        throw std::runtime_error("the town has no streets");
    }
    void send(std::size_t index) {
        crowd_.stop(index);
        crowd_.go(worker_.query(), index, place(1'000'000 + next_++));
    }

    std::size_t blocks_;
    CharacterSettings settings_{};
    World world_;
    NavigationMesh mesh_;
    NavigationCrowdWorker worker_;
    NavigationCrowd crowd_;
    Crowd feet_;
    std::vector<CharacterState> states_;
    std::vector<CharacterInput> inputs_;
    std::uint64_t next_ = 0;
};

}  // namespace

AgentsReport run_agents(const AgentsOptions& options) {
    Town town(options);
    for (std::size_t i = 0; i < options.settling; ++i) town.tick();
    town.steering.clear();
    town.stepping.clear();
    town.ticks.clear();
    town.arrivals = town.gave_up = town.plans = 0;
    AgentsReport report;
    for (std::size_t i = 0; i < options.ticks; ++i) {
        town.tick();
        report.speed += town.speed() / static_cast<double>(options.ticks);
    }
    report.polygons = town.polygons();
    report.steering = quantile(town.steering, 0.5);
    report.stepping = quantile(town.stepping, 0.5);
    report.tick = quantile(town.ticks, 0.5);
    report.slow_tick = quantile(town.ticks, 0.99);
    report.per_core = static_cast<double>(options.agents) * dt / report.tick;
    report.sure_per_core = static_cast<double>(options.agents) * dt / report.slow_tick;
    report.arrivals = town.arrivals;
    report.gave_up = town.gave_up;
    report.plans = town.plans;
    report.touching = town.touching();
    return report;
}

}  // namespace surefoot::bench
