#include "course/runner.hpp"

#include <algorithm>
#include <cmath>

namespace surefoot::course {

bool Score::passes() const {
    return failure.empty() && !marks.empty() &&
           std::all_of(marks.begin(), marks.end(), [](const Mark& mark) { return mark.passes(); });
}

Outing walk_run(const Run& run, Mover& mover) {
    Outing outing;
    outing.run = &run;
    const double dt = run.dt();
    const auto ticks = [&](double seconds) { return static_cast<int>(std::lround(seconds * run.rate)); };
    const int settling = ticks(run.settle);
    const int all = settling + ticks(run.seconds);
    Spot now{.time = -settling * dt, .position = run.start, .grounded = false, .input = {}};
    outing.spots.push_back(now);
    if (!mover.takes(run.settings.volume.shape)) {
        outing.failure = "it moves no body of this shape";
        return outing;
    }
    try {
        mover.load(run);
        for (int tick = 0; tick < all; ++tick) {
            now.input = tick < settling ? Input{} : run.script((tick - settling) * dt, now);
            // The bodies' clock begins with the script too: they stand while the character settles.
            const double end = std::max(0, tick + 1 - settling) * dt;
            const Answer answer = mover.tick(now.input, dt, poses_at(*run.level, end));
            now.position = answer.position;
            now.grounded = answer.grounded;
            now.time = (tick + 1 - settling) * dt;
            outing.spots.push_back(now);
        }
    } catch (const MoverFailure& failure) {
        outing.failure = failure.text;
    }
    return outing;
}

Score run_scene(const Scene& scene, Mover& mover, const std::function<void(double)>& progress) {
    Score score;
    score.scene = &scene;
    std::vector<Outing> outings;
    for (const Run& run : scene.runs) {
        outings.push_back(walk_run(run, mover));
        if (!outings.back().failure.empty()) {
            score.failure = run.name + ": " + outings.back().failure;
            return score;
        }
        if (progress) progress(static_cast<double>(outings.size()) / static_cast<double>(scene.runs.size()));
    }
    for (const Bar& bar : scene.bars) score.marks.push_back({&bar, bar.measure(outings)});
    return score;
}

bool fails_scene(const Scene& scene, Mover& mover) {
    std::vector<Outing> outings;
    const auto misses = [&](std::span<const Outing> some) {
        return std::any_of(scene.bars.begin(), scene.bars.end(), [&](const Bar& bar) {
            return !Mark{&bar, bar.measure(some)}.passes();
        });
    };
    for (const Run& run : scene.runs) {
        outings.push_back(walk_run(run, mover));
        if (!outings.back().failure.empty() || misses({&outings.back(), 1})) return true;
    }
    return misses(outings);
}

}  // namespace surefoot::course
