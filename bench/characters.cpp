#include "characters.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <thread>

#include <surefoot/surefoot.hpp>

#include "clock.hpp"
#include "shelf.hpp"

namespace surefoot::bench {
namespace {

constexpr double dt = 1.0 / 60;
constexpr std::size_t rays_a_round = 2000;

double quantile(std::vector<double>& values, double share) {
    if (values.empty()) return 0;
    std::sort(values.begin(), values.end());
    return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1) + 0.5)];
}

double half_width_of(const Stage& stage) {
    const Bounds bounds = stage.mesh.bounds();
    return 0.5 * std::min(bounds.max.x - bounds.min.x, bounds.max.z - bounds.min.z) - 4;
}

/// What reading the clock twice costs [s].
double clock_cost() {
    std::vector<double> times;
    for (int i = 0; i < 1000; ++i) {
        const double begin = thread_seconds();
        times.push_back(thread_seconds() - begin);
    }
    return quantile(times, 0.5);
}

class Walkers {
public:
    Walkers(const Stage& stage, const World& world, const CharacterOptions& options, std::string name, bool in_crowd,
            bool dense)
        : world_(world),
          places_(make_places(stage, options.count, dense)),
          half_width_(dense ? 22 : half_width_of(stage)),
          lowest_(stage.mesh.bounds().min.y - 5),
          in_crowd_(in_crowd) {
        row_.name = std::move(name);
        for (std::size_t i = 0; i < places_.size(); ++i) {
            states_.push_back({.position = places_[i]});
            wanderers_.emplace_back(i + 1);
        }
        inputs_.resize(states_.size());
        events_.resize(states_.size());
        if (in_crowd && !crowd_.reserve(states_.size())) throw std::runtime_error("no memory for the crowd");
    }

    void tick(bool timed, bool singly) {
        steer();
        const std::vector<CharacterState> before = states_;
        const Characters all = characters();
        if (singly) {
            update_singly(all);
            return;
        }
        const double begin = thread_seconds();
        if (in_crowd_) gather(all);
        const double gathered = thread_seconds();
        step({});
        const double end = thread_seconds();
        if (!timed) return;
        const auto count = static_cast<double>(states_.size());
        ticks_.push_back(1e9 * (end - begin) / count);
        if (in_crowd_) gathers_.push_back(1e9 * (gathered - begin) / count);
        if (in_crowd_) ask_neighbours();
        for (std::size_t i = 0; i < states_.size(); ++i) {
            const dvec3 way = states_[i].position - before[i].position;
            walked_ += std::sqrt(way.x * way.x + way.z * way.z) / dt;
            grounded_ += states_[i].footing == Footing::ground ? 1 : 0;
            blocked_ += events_[i].has(CharacterEvent::blocked) ? 1 : 0;
            ++updates_;
        }
    }

    /// The same tick again and again, on one thread and on two, by the wall clock.
    void scale() {
        std::vector<double> one, two;
        steer();
        const std::vector<CharacterState> before = states_;
        for (int round = 0; round < 31; ++round) {
            for (const bool both : {false, true}) {
                states_ = before;
                if (in_crowd_) gather(characters());
                const std::size_t half = states_.size() / 2;
                const double begin = wall_seconds();
                if (both) {
                    std::thread other([&] { step({half, states_.size()}); });
                    step({0, half});
                    other.join();
                } else {
                    step({});
                }
                (both ? two : one).push_back(wall_seconds() - begin);
            }
        }
        row_.two_threads = quantile(one, 0.1) / quantile(two, 0.1);
    }

    CharacterRow row() {
        row_.median = quantile(ticks_, 0.5);
        row_.p50 = quantile(singles_, 0.5);
        row_.p99 = quantile(singles_, 0.99);
        row_.p999 = quantile(singles_, 0.999);
        row_.worst = quantile(singles_, 1);
        row_.gather = quantile(gathers_, 0.5);
        row_.neighbours = quantile(finds_, 0.5);
        const auto updates = static_cast<double>(std::max<std::size_t>(updates_, 1));
        row_.walked = walked_ / updates;
        row_.grounded = static_cast<double>(grounded_) / updates;
        row_.blocked = static_cast<double>(blocked_) / updates;
        row_.met = static_cast<double>(met_) / updates;
        return row_;
    }

private:
    Characters characters() {
        return {.settings = {&settings_, 1}, .inputs = inputs_, .before = states_, .after = states_, .events = events_};
    }
    void steer() {
        for (std::size_t i = 0; i < states_.size(); ++i) {
            // Who fell off the edge of the world begins anew.
            if (!(states_[i].position.y > lowest_)) states_[i] = {.position = places_[i]};
            inputs_[i].wish =
                wanderers_[i].wish(states_[i].position, half_width_, events_[i].has(CharacterEvent::blocked));
        }
    }
    void gather(const Characters& all) {
        if (!crowd_.gather(all, dt)) throw std::runtime_error("no memory for the crowd");
    }
    void step(StepRange range) {
        if (in_crowd_) {
            step_all(world_, crowd_, characters(), dt, range);
        } else {
            step_all(world_, characters(), dt, range);
        }
    }
    void update_singly(const Characters& all) {
        if (in_crowd_) gather(all);
        const double cost = clock_cost();
        for (std::size_t i = 0; i < states_.size(); ++i) {
            const double begin = thread_seconds();
            step({i, i + 1});
            singles_.push_back(1e9 * std::max(0.0, thread_seconds() - begin - cost));
        }
    }
    void ask_neighbours() {
        std::array<Neighbour, most_met_in_crowd> room;
        const double begin = thread_seconds();
        for (std::size_t i = 0; i < states_.size(); ++i) met_ += crowd_.neighbours(i, room);
        finds_.push_back(1e9 * (thread_seconds() - begin) / static_cast<double>(states_.size()));
    }

    const World& world_;
    std::vector<dvec3> places_;
    double half_width_;
    double lowest_;
    bool in_crowd_;
    CharacterSettings settings_{};
    std::vector<CharacterState> states_;
    std::vector<CharacterInput> inputs_;
    std::vector<CharacterEvents> events_;
    std::vector<Wanderer> wanderers_;
    Crowd crowd_;
    CharacterRow row_;
    std::vector<double> ticks_, singles_, gathers_, finds_;
    double walked_ = 0;
    std::size_t grounded_ = 0, blocked_ = 0, updates_ = 0, met_ = 0;
};

}  // namespace

double Wanderer::random() {
    state_ = state_ * 6364136223846793005ULL + 1442695040888963407ULL;
    return static_cast<double>(state_ >> 11) * 0x1p-53;
}

dvec3 Wanderer::wish(const dvec3& at, double half_width, bool was_blocked) {
    heading_ += 0.06 * (random() - 0.5);
    if (was_blocked && random() < 0.1) heading_ += 2 + 2 * random();
    dvec3 wish(speed_asked * std::cos(heading_), 0, speed_asked * std::sin(heading_));
    if (std::abs(at.x) > half_width || std::abs(at.z) > half_width) {
        const double away = std::hypot(at.x, at.z);
        wish = dvec3(-at.x, 0, -at.z) * (speed_asked / away);
        heading_ = std::atan2(wish.z, wish.x);
    }
    return wish;
}

std::vector<dvec3> make_places(const Stage& stage, std::size_t count, bool dense) {
    std::vector<dvec3> places;
    if (!dense) {
        for (const Motion& motion : make_motions(stage.scene, stage.mesh, Body::ellipsoid, Path::brief, count))
            places.push_back(motion.from);
        return places;
    }
    const auto side = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(count))));
    const Bounds bounds = stage.mesh.bounds();
    for (std::size_t i = 0; i < count; ++i) {
        const double spacing = 1.4;
        const double x = spacing * (static_cast<double>(i % side) - 0.5 * static_cast<double>(side));
        const double z = spacing * (static_cast<double>(i / side) - 0.5 * static_cast<double>(side));
        const auto hit = stage.mesh.ray({.from = {x, bounds.max.y + 1, z}, .to = {x, bounds.min.y - 1, z}});
        places.emplace_back(x, (hit ? hit->point.y : 0) + 1.3, z);
    }
    return places;
}

CharacterReport run_characters(const Stage& stage, const CharacterOptions& options) {
    World world;
    if (!world.add(stage.mesh)) throw std::runtime_error("no memory for the world");
    std::vector<Walkers> walkers;
    walkers.reserve(3);
    walkers.emplace_back(stage, world, options, "alone", false, false);
    walkers.emplace_back(stage, world, options, "in a crowd", true, false);
    if (stage.scene.name == "terrain") walkers.emplace_back(stage, world, options, "in a dense crowd", true, true);

    for (std::size_t i = 0; i < options.settling; ++i)
        for (Walkers& each : walkers) each.tick(false, false);
    const Motions rays = make_motions(stage.scene, stage.mesh, Body::sphere, Path::distant, 16384);
    std::vector<double> ray_times;
    for (std::size_t i = 0; i < options.ticks; ++i) {
        if (stage.embree && rays.size() > rays_a_round) {
            const std::span<const Motion> some =
                std::span(rays).subspan(i * rays_a_round % (rays.size() - rays_a_round), rays_a_round);
            (void)stage.embree->rays(some.first(rays_a_round / 4));
            const double begin = thread_seconds();
            (void)stage.embree->rays(some);
            ray_times.push_back(1e9 * (thread_seconds() - begin) / static_cast<double>(some.size()));
        }
        for (Walkers& each : walkers) {
            each.tick(true, false);
            if (i % 4 == 0) each.tick(false, true);
        }
    }
    CharacterReport report;
    report.ray = quantile(ray_times, 0.5);
    for (Walkers& each : walkers) {
        each.scale();
        report.rows.push_back(each.row());
    }
    for (CharacterRow& row : run_bullet_characters(stage, options, make_places(stage, options.bullets, false)))
        report.rows.push_back(std::move(row));
    return report;
}

}  // namespace surefoot::bench
