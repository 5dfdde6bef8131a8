#include "playtest/report/exhibit.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "playtest/vectors.hpp"

namespace surefoot::playtest {
namespace {

constexpr std::uint64_t shortest_fall = 20;  // ticks in the air that are worth to be shown
constexpr std::uint64_t longest_fall = 480;  // longer than this, what led to it is not where it began
constexpr std::uint64_t dots_for = 150;      // ticks of the way there, drawn into a frame
constexpr std::uint64_t dot_every = 6;       // ticks
constexpr double seen_below = 3;             // who has fallen farther than this is out of sight of the place [m]
constexpr double near_by = 16;               // what moves at a greater distance is left out of a clip [m]
constexpr double nowhere = -1e6;             // the height of what is not there
constexpr FrameSize small{240, 135};

// Of each tick of a run, from the first on; what lies between them is the game's.
struct Course {
    std::vector<dvec3> feet;
    std::vector<dvec3> middle;
    std::vector<bool> is_on_ground;
};

struct Moments {
    std::array<std::uint64_t, 3> ticks;
    std::size_t largest;
};

// When the frames of an incident are taken. The tick that notes down a death puts the hero back, too: so it is the one
// before.
Moments moments_of(const Course& course, const Incident& incident) {
    const std::uint64_t end = std::clamp<std::uint64_t>(incident.tick, 2, course.feet.size()) - 1;
    std::uint64_t left = end;
    while (left > 1 && !course.is_on_ground[left - 1]) --left;
    const bool falls = incident.kind == Incident::Kind::failed_jump || incident.cause == game::Cause::fall;
    if (falls && end - left >= shortest_fall && end - left <= longest_fall) {
        std::uint64_t sinks = left;
        while (sinks < end && course.feet[sinks - 1].y > course.feet[left - 1].y - seen_below) ++sinks;
        return {{left, left + (sinks - left) / 2, sinks}, 0};
    }
    const auto before = [&](std::uint64_t ticks) { return end > ticks ? end - ticks : 1; };
    return {{before(90), before(30), end}, 2};
}

// Writes down what the clips of all incidents of a run need, sample by sample.
class Filming {
public:
    Filming(const game::Level& level, std::span<const Incident> incidents) : level_(level) {
        for (const Incident& incident : incidents) {
            Clip clip;
            const std::uint64_t first = incident.tick > clip_ticks ? incident.tick - clip_ticks : 1;
            clip.first_tick = (first + clip_every - 1) / clip_every * clip_every;
            clip.movers.resize(level.bodies.size() + level.enemies.size());
            for (std::size_t i = 0; i < level.bodies.size(); ++i) {
                const Bounds box = level.bodies[i].mesh.bounds();
                clip.movers[i].half = (box.max - box.min) * 0.5;
            }
            for (std::size_t i = 0; i < level.enemies.size(); ++i)
                clip.movers[level.bodies.size() + i] = {
                    .is_enemy = true, .half = {0.4, 0.6, 0.4}, .places = {}, .yaws = {}};
            clips_.push_back(std::move(clip));
            ends_.push_back(incident.tick);
        }
    }

    void tick(const game::Game& game, const game::HeroInput& input) {
        const std::uint64_t tick = game.ticks();
        if (tick % clip_every != 0) return;
        for (std::size_t i = 0; i < clips_.size(); ++i)
            if (tick >= clips_[i].first_tick && tick < ends_[i]) take(clips_[i], game, input);
    }

    // Without what is far away all the time.
    [[nodiscard]] Clip clip(std::size_t i) {
        Clip& made = clips_[i];
        std::erase_if(made.movers, [&](const ClipMover& mover) {
            for (std::size_t k = 0; k < made.feet.size(); ++k)
                if (mover.places[k].y > nowhere &&
                    flat_length(mover.places[k] - made.feet[k]) < near_by + std::max(mover.half.x, mover.half.z))
                    return false;
            return true;
        });
        return std::move(made);
    }

private:
    void take(Clip& clip, const game::Game& game, const game::HeroInput& input) const {
        clip.feet.push_back(game.feet());
        clip.looks.push_back(double(input.look_yaw_deg));
        for (ClipMover& mover : clip.movers) {
            mover.places.push_back({0, nowhere, 0});
            mover.yaws.push_back(0);
        }
        for (const game::MovingBody& body : game.bodies()) {
            if (!body.is_there) continue;
            const Bounds box = level_.bodies[body.plan].mesh.bounds();
            clip.movers[body.plan].places.back() = to_world(body.now, (box.min + box.max) * 0.5);
            const dquat& turn = body.now.orientation;
            clip.movers[body.plan].yaws.back() = 2 * std::atan2(turn.y, turn.w);
        }
        for (const game::Enemy& enemy : game.enemies())
            clip.movers[level_.bodies.size() + enemy.plan].places.back() = enemy.body.position;
    }

    const game::Level& level_;
    std::vector<Clip> clips_;
    std::vector<std::uint64_t> ends_;
};

bool is_somewhere(const dvec3& place) {
    return std::isfinite(place.x) && std::isfinite(place.y) && std::isfinite(place.z);
}

}  // namespace

Expected<std::vector<Exhibit>> exhibits_of(const std::shared_ptr<const game::Level>& level,
                                           const game::Recording& recording, std::span<const Incident> incidents,
                                           const FramePainter& painter) {
    std::uint64_t last = 0;
    for (const Incident& incident : incidents) last = std::max(last, incident.tick);
    const auto play = [&](const auto& each) -> Expected<void> {
        auto game = game::start_of(level, recording);
        if (!game) return tl::unexpected(game.error());
        game::Player player(recording);
        while (player.ticks() < last && player.tick(**game)) each(**game, recording.inputs[player.ticks() - 1]);
        return {};
    };

    Course course;
    Filming filming(*level, incidents);
    auto played = play([&](const game::Game& game, const game::HeroInput& input) {
        course.feet.push_back(game.feet());
        course.middle.push_back(game.hero().body.position);
        course.is_on_ground.push_back(game.hero().body.footing == Footing::ground);
        filming.tick(game, input);
    });
    if (!played) return tl::unexpected(played.error());

    struct Wish {
        std::uint64_t tick;
        std::size_t incident;
        std::size_t still;
    };
    std::vector<Exhibit> exhibits(incidents.size());
    std::vector<Wish> wishes;
    for (std::size_t i = 0; i < incidents.size(); ++i) {
        exhibits[i].clip = filming.clip(i);
        if (course.feet.empty()) continue;
        const Moments moments = moments_of(course, incidents[i]);
        exhibits[i].moment = moments.largest;
        exhibits[i].stills.resize(moments.ticks.size());
        for (std::size_t k = 0; k < moments.ticks.size(); ++k) wishes.push_back({moments.ticks[k], i, k});
    }
    std::ranges::stable_sort(wishes, {}, &Wish::tick);

    auto next = wishes.begin();
    played = play([&](const game::Game& game, const game::HeroInput& input) {
        for (; next != wishes.end() && next->tick <= game.ticks(); ++next) {
            Still& still = exhibits[next->incident].stills[next->still];
            still.tick = game.ticks();
            if (!is_somewhere(game.hero().body.position)) continue;
            const bool is_the_moment = next->still == exhibits[next->incident].moment;
            std::vector<dvec3> trail;
            const std::uint64_t from = game.ticks() > dots_for ? game.ticks() - dots_for : 0;
            for (std::uint64_t tick = from; tick + dot_every / 2 < game.ticks(); tick += dot_every)
                if (is_somewhere(course.middle[tick])) trail.push_back(course.middle[tick]);
            still.picture = painter.paint(game, frame_camera(game, input), trail, is_the_moment ? FrameSize{} : small);
        }
    });
    if (!played) return tl::unexpected(played.error());
    for (Exhibit& exhibit : exhibits)
        if (std::ranges::any_of(exhibit.stills, [](const Still& still) { return still.picture.rgba.empty(); }))
            exhibit.stills.clear();
    return exhibits;
}

}  // namespace surefoot::playtest
