// How far does a dense crowd get? As far as discs do that know nothing of levels, bodies and steps.
#include <algorithm>
#include <cmath>

#include "crowd_scene.hpp"

namespace surefoot::tests {
namespace {

using Way = glm::dvec2;

constexpr std::size_t side = 20;  ///< of them in a row
constexpr double spacing = 1.4;   ///< at the start [m]: one on every two square metres
constexpr double half_width = 0.5 * spacing * side;
constexpr double speed = 6;
constexpr double dt = 1.0 / 60;
constexpr int settling = 60;
constexpr int ticks = 180;

Way place(std::size_t i) {
    const auto at = [](std::size_t k) { return spacing * (static_cast<double>(k) - 0.5 * side); };
    return {at(i % side), at(i / side)};
}

/// Wanders, turns back at the edge of the yard, and some time after it was kept from going.
class Steersman {
public:
    explicit Steersman(std::uint64_t seed) : random_(seed), heading_(random_.in(0, 6.283)) {}

    Way wish(const Way& at, bool was_blocked) {
        heading_ += random_.in(-0.03, 0.03);
        if (was_blocked && random_.in(0, 1) < 0.1) heading_ += random_.in(2, 4);
        if (std::max(std::abs(at.x), std::abs(at.y)) > half_width) heading_ = std::atan2(-at.y, -at.x);
        return speed * Way{std::cos(heading_), std::sin(heading_)};
    }

private:
    SplitMix random_;
    double heading_;
};

std::vector<Steersman> steersmen() {
    std::vector<Steersman> all;
    for (std::size_t i = 0; i < side * side; ++i) all.emplace_back(i + 1);
    return all;
}

/// No farther than this that way: half-way to another, as seen from the start of the tick.
struct Limit {
    Way normal;
    double most;
};

/// The way nearest to the wish that heeds all limits: the wish, its foot on one of them, or where two of them cross.
Way nearest_allowed(const Way& wish, const std::vector<Limit>& limits) {
    Way best{0, 0};
    double least = 1e300;
    const auto offer = [&](const Way& way) {
        const double off = glm::dot(way - wish, way - wish);
        if (off < least && std::all_of(limits.begin(), limits.end(), [&](const Limit& limit) {
                return glm::dot(way, limit.normal) <= limit.most + 1e-12;
            })) {
            best = way;
            least = off;
        }
    };
    offer(wish);
    for (std::size_t i = 0; i < limits.size() && least > 0; ++i) {
        const Limit& a = limits[i];
        offer(wish - a.normal * (glm::dot(wish, a.normal) - a.most));
        for (std::size_t k = 0; k < i; ++k) {
            const Limit& b = limits[k];
            const double across = a.normal.x * b.normal.y - a.normal.y * b.normal.x;
            if (std::abs(across) < 1e-9) continue;
            offer(Way{a.most * b.normal.y - b.most * a.normal.y, a.normal.x * b.most - b.normal.x * a.most} / across);
        }
    }
    return best;
}

struct Disc {
    Way at;
    Way velocity{0, 0};
    bool was_blocked = false;
};

std::vector<Limit> limits_of(const std::vector<Disc>& discs, std::size_t i, double width) {
    std::vector<Limit> limits;
    for (const Disc& other : discs) {
        const Way between = other.at - discs[i].at;
        const double distance = glm::length(between);
        if (distance == 0 || distance > width + 2.5 * speed * dt) continue;
        const Way normal = between / distance;
        const double gap = distance - width;
        const double mine = std::max(0.0, glm::dot(discs[i].velocity, normal)) * dt;
        const double theirs = std::max(0.0, -glm::dot(other.velocity, normal)) * dt;
        if (gap < 0) {
            limits.push_back({normal, 0.5 * gap});
        } else if (mine + theirs > gap) {
            limits.push_back({normal, gap * mine / (mine + theirs)});
        }
    }
    return limits;
}

/// The mean speed of discs as wide as a body and its skin, with its acceleration.
double speed_of_discs() {
    const CharacterSettings settings;
    std::vector<Steersman> steered = steersmen();
    std::vector<Disc> discs;
    for (std::size_t i = 0; i < steered.size(); ++i) discs.push_back({place(i)});
    double walked = 0;
    for (int tick = 0; tick < settling + ticks; ++tick) {
        for (std::size_t i = 0; i < discs.size(); ++i) {
            Disc& disc = discs[i];
            const Way change = steered[i].wish(disc.at, disc.was_blocked) - disc.velocity;
            const double size = glm::length(change);
            disc.velocity += change * std::min(1.0, settings.acceleration * dt / std::max(size, 1e-9));
        }
        std::vector<Disc> after = discs;
        for (std::size_t i = 0; i < discs.size(); ++i) {
            const Way wish = discs[i].velocity * dt;
            const Way way = nearest_allowed(wish, limits_of(discs, i, 0.8 + settings.skin));
            after[i] = {discs[i].at + way, way / dt, way != wish};
            if (tick >= settling) walked += glm::length(way) / dt;
        }
        discs = after;
    }
    return walked / static_cast<double>(ticks * discs.size());
}

double speed_of_crowd() {
    Scene scene;
    scene.floor(-2 * half_width, 2 * half_width, -2 * half_width, 2 * half_width, 0, 8);
    const World world = scene.world();
    std::vector<Steersman> steered = steersmen();
    Many many;
    for (std::size_t i = 0; i < steered.size(); ++i) many.add({place(i).x, 0.95, place(i).y});
    double walked = 0;
    const auto seen_from_above = [](const CharacterState& state) { return Way{state.position.x, state.position.z}; };
    for (int tick = 0; tick < settling + ticks; ++tick) {
        const std::vector<CharacterState> before = many.states;
        for (std::size_t i = 0; i < before.size(); ++i) {
            const bool was_blocked = many.events[i].has(CharacterEvent::blocked);
            const Way wish = steered[i].wish(seen_from_above(before[i]), was_blocked);
            many.inputs[i].wish = {wish.x, 0, wish.y};
        }
        many.tick(world);
        for (std::size_t i = 0; i < before.size() && tick >= settling; ++i)
            walked += glm::length(seen_from_above(many.states[i]) - seen_from_above(before[i])) / dt;
    }
    return walked / static_cast<double>(ticks * many.states.size());
}

// Broken variants: those who meet stop instead of sliding past each other; nobody meets anybody.
TEST(CrowdDiscs, ADenseCrowdGetsAsFarAsDiscsThatSlidePastEachOther) {
    const double discs = speed_of_discs();
    EXPECT_LT(discs, 0.75 * speed) << "they are in each other's way";
    EXPECT_NEAR(speed_of_crowd(), discs, 0.05 * discs);
}

}  // namespace
}  // namespace surefoot::tests
