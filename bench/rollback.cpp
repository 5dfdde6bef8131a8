#include "rollback.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <vector>

#include <surefoot/surefoot.hpp>

#include "clock.hpp"

namespace surefoot::bench {
namespace {

constexpr double dt = 1.0 / 60;
constexpr double half_side = 2.5;       // of a lift [m]
constexpr double apart = 8;             // lifts, from middle to middle [m]
constexpr double standing = 0.91;       // of the reference point over the ground [m]
constexpr std::size_t up_or_down = 90;  // frames in each direction
constexpr std::uint64_t still_layer = 1;
constexpr std::uint64_t lift_layer = 2;

Mesh plate(float half, float thick) {
    const float low = -thick;
    const std::array<vec3, 8> corners{{{-half, 0, -half},
                                       {half, 0, -half},
                                       {half, 0, half},
                                       {-half, 0, half},
                                       {-half, low, -half},
                                       {half, low, -half},
                                       {half, low, half},
                                       {-half, low, half}}};
    const std::array<std::uint32_t, 36> triangles{0, 2, 1, 0, 3, 2, 4, 5, 6, 4, 6, 7, 0, 1, 5, 0, 5, 4,
                                                  1, 2, 6, 1, 6, 5, 2, 3, 7, 2, 7, 6, 3, 0, 4, 3, 4, 7};
    const auto mesh = Mesh::build({.vertices = corners, .indices = triangles});
    if (!mesh) throw std::runtime_error(mesh.error().text);
    return *mesh;
}

/// All that changes from frame to frame. What can be computed from the number of the frame is not in it.
struct Snapshot {
    std::vector<CharacterState> states;
    std::vector<BodyPose> poses;
    std::uint64_t hash = 0;
};

class Game {
public:
    explicit Game(const RollbackOptions& options) : options_(options) {
        place(plate(100, 1), {.pose = {.position = {0, -3, 0}}, .body = 0, .layers = still_layer});
        const Mesh deck = plate(half_side, 0.3F);
        for (std::size_t i = 0; i < options.lifts; ++i) {
            const dvec3 middle{apart * static_cast<double>(i), 0, 0};
            lifts_.push_back(place(
                deck, {.pose = {.position = middle}, .body = static_cast<std::uint32_t>(1 + i), .layers = lift_layer}));
        }
        for (std::size_t i = 0; i < options.characters; ++i) {
            const std::size_t place = i / options.lifts;
            states_.push_back({.position = {apart * static_cast<double>(i % options.lifts) +
                                                0.9 * static_cast<double>(place % 4) - 1.35,
                                            standing, 0.9 * static_cast<double>(place / 4) - 0.9}});
        }
        inputs_.resize(states_.size());
        poses_.resize(lifts_.size());
        if (!crowd_.reserve(states_.size())) throw std::runtime_error("no memory for the crowd");
    }

    /// One frame. It depends on the poses that the lifts have, so one that begins with other poses goes another way.
    void play(std::size_t frame) {
        world_.begin_tick();
        for (std::size_t i = 0; i < lifts_.size(); ++i) {
            const bool up = (frame / up_or_down + i) % 2 == 0;
            Pose next = world_.poses(lifts_[i]).end;
            next.position.y += (up ? 1.5 : -1.5) * dt;
            if (i % 2 == 1) next.orientation = glm::normalize(next.orientation * dquat(1, 0, 0.004, 0));
            if (!world_.move(lifts_[i], next)) throw std::runtime_error("a lift went where it cannot be");
        }
        for (std::size_t i = 0; i < inputs_.size(); ++i) inputs_[i] = input(frame, i);
        const Characters all{.settings = {&settings_, 1}, .inputs = inputs_, .before = states_, .after = states_};
        if (!crowd_.gather(all, dt)) throw std::runtime_error("no memory for the crowd");
        step_all(world_, crowd_, all, dt);
    }

    void save(Snapshot& to) {
        to.states = states_;
        world_.save_poses(poses_, lift_layer);
        to.poses = poses_;
    }
    void restore(const Snapshot& from) {
        states_ = from.states;
        if (options_.restores_poses && !world_.restore_poses(from.poses)) {
            throw std::runtime_error("the poses could not be put back");
        }
    }

    [[nodiscard]] double touching() const {
        const Ellipsoid wide{{0.4 + 2 * settings_.skin, 0.9, 0.4 + 2 * settings_.skin}};
        const auto touches = [&](const CharacterState& one) {
            return std::any_of(states_.begin(), states_.end(), [&](const CharacterState& other) {
                return &other != &one && pair_overlap(wide, one.position, settings_.volume, other.position);
            });
        };
        return share(touches);
    }
    [[nodiscard]] double riding() const {
        return share([](const CharacterState& one) { return one.footing == Footing::ground && one.ground_body > 0; });
    }

private:
    BodyHandle place(const Mesh& mesh, const Placement& placement) {
        const auto added = world_.add(mesh, placement);
        if (!added) throw std::runtime_error(added.error().text);
        return *added;
    }
    /// Everybody presses towards a place about the middle of the lift, another one every half second.
    [[nodiscard]] CharacterInput input(std::size_t frame, std::size_t index) const {
        const std::size_t lift = index % options_.lifts;
        const double turn = static_cast<double>((frame / 30 + index) % 4) - 1.5;
        const dvec3 to{apart * static_cast<double>(lift) + 0.3 * turn, 0, 0.2 * turn};
        const dvec3 way = to - states_[index].position;
        return {.wish = {3 * way.x, 0, 3 * way.z}, .jump = (frame + 15 * index) % 960 == 0};
    }
    template <typename Condition>
    [[nodiscard]] double share(const Condition& is_so) const {
        return static_cast<double>(std::count_if(states_.begin(), states_.end(), is_so)) /
               static_cast<double>(states_.size());
    }

    RollbackOptions options_;
    CharacterSettings settings_{};
    World world_;
    std::vector<BodyHandle> lifts_;
    std::vector<CharacterState> states_;
    std::vector<CharacterInput> inputs_;
    std::vector<BodyPose> poses_;
    Crowd crowd_;
};

/// Of every state and every pose, in their order.
std::uint64_t hash_of(const Snapshot& snapshot) {
    std::vector<std::uint64_t> hashes;
    for (const CharacterState& state : snapshot.states) hashes.push_back(hash(state));
    return hash_bytes(std::as_bytes(std::span(hashes)), hash_bytes(std::as_bytes(std::span(snapshot.poses))));
}

double quantile(std::vector<double>& values, double share) {
    if (values.empty()) return 0;
    std::sort(values.begin(), values.end());
    return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1) + 0.5)];
}

/// The game with its last frames.
class Rollback {
public:
    explicit Rollback(const RollbackOptions& options)
        : options_(options), game_(options), kept_(options.frames + 1), again_(options.frames) {
        game_.save(kept_[0]);
    }

    void play() {
        game_.play(frame_++);
        Snapshot& now = kept(frame_);
        game_.save(now);
        now.hash = hash_of(now);
    }

    /// Back by `frames`, and all of them again. Then compares.
    void go_back(RollbackReport& report) {
        const std::size_t first = frame_ - options_.frames;
        const double begin = thread_seconds();
        game_.restore(kept(first));
        const double restored = thread_seconds();
        for (std::size_t i = 0; i < options_.frames; ++i) {
            game_.play(first + i);
            game_.save(again_[i]);  // as a game does, which may have to go back again
        }
        const double end = thread_seconds();
        restores_.push_back(1e9 * (restored - begin));
        frames_.push_back(1e9 * (end - begin) / static_cast<double>(options_.frames));
        for (std::size_t i = 0; i < options_.frames && !report.first_differs; ++i) {
            ++report.compared;
            if (hash_of(again_[i]) != kept(first + i + 1).hash) report.first_differs = first + i;
        }
    }

    void sum_up(RollbackReport& report) {
        report.frame = quantile(frames_, 0.5);
        report.slow_frame = quantile(frames_, 0.9);
        report.character = report.frame / static_cast<double>(options_.characters);
        report.restoring = quantile(restores_, 0.5);
        report.touching = game_.touching();
        report.riding = game_.riding();
    }

private:
    [[nodiscard]] Snapshot& kept(std::size_t frame) { return kept_[frame % kept_.size()]; }

    RollbackOptions options_;
    Game game_;
    std::vector<Snapshot> kept_;   // before each of the last frames, and now
    std::vector<Snapshot> again_;  // after each frame that is played again
    std::vector<double> frames_;
    std::vector<double> restores_;
    std::size_t frame_ = 0;  // how many were played
};

}  // namespace

RollbackReport run_rollback(const RollbackOptions& options) {
    RollbackReport report;
    Rollback rollback(options);
    for (std::size_t i = 0; i < std::max(options.settling, options.frames); ++i) rollback.play();
    for (std::size_t i = 0; i < options.rounds && !report.first_differs; ++i) {
        rollback.go_back(report);
        rollback.play();
    }
    rollback.sum_up(report);
    return report;
}

}  // namespace surefoot::bench
