#include "playground/course_room/race.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace surefoot::playground {
namespace {

/// A window stands still while a program is waited for, so that is not long [s].
constexpr double patience = 5;

Racer walk(const Rival& who, const course::Run& run) {
    Racer racer{who.name(), {}};
    try {
        racer.outing = course::walk_run(run, *who.make());
    } catch (const course::MoverFailure& failure) {
        racer.outing.run = &run;
        racer.outing.spots.push_back({.time = 0, .position = run.start, .grounded = false, .input = {}});
        racer.outing.failure = failure.text;
    }
    return racer;
}

/// The place of the last spot at or before a time.
std::size_t place_at(const course::Outing& outing, double time) {
    const double ticks = (time - outing.spots.front().time) / outing.run->dt();
    // A hair more, so that the time of a spot is not the one before it by rounding.
    const auto last = static_cast<double>(outing.spots.size() - 1);
    return static_cast<std::size_t>(std::clamp(std::floor(ticks + 1e-6), 0.0, last));
}

}  // namespace

std::unique_ptr<course::Mover> Rival::make() const {
    if (!command.empty()) return course::make_external_mover(command, patience);
    auto made = course::make_mover(mover);
    if (!made) throw course::MoverFailure{"this build has no such mover"};
    return made;
}

const course::Spot& Racer::spot_at(double time) const {
    return outing.spots[place_at(outing, time)];
}

dvec3 Racer::position_at(double time) const {
    const std::size_t i = place_at(outing, time);
    const course::Spot& spot = outing.spots[i];
    if (i + 1 == outing.spots.size()) return spot.position;
    const double share = std::clamp((time - spot.time) / outing.run->dt(), 0.0, 1.0);
    return spot.position + (outing.spots[i + 1].position - spot.position) * share;
}

Race::Race(const course::Run& run, const Rival& other) : run_(&run), ours_(walk({.mover = "ours"}, run)) {
    if (!other.is_nobody()) other_ = walk(other, run);
}

double Race::begin() const {
    return ours_.outing.spots.front().time;
}

double Race::end() const {
    const double own = ours_.outing.last().time;
    return other_ ? std::max(own, other_->outing.last().time) : own;
}

double Race::gap_at(double time) const {
    return other_ ? glm::length(other_->position_at(time) - ours_.position_at(time)) : 0;
}

Measuring::Measuring(const course::Scene& scene, const Rival& who) : scene_(&scene), name_(who.name()) {
    score_.scene = &scene;
    try {
        mover_ = who.make();
    } catch (const course::MoverFailure& failure) {
        score_.failure = failure.text;
    }
}

bool Measuring::go_on() {
    if (is_done()) return false;
    const course::Run& run = scene_->runs[outings_.size()];
    outings_.push_back(course::walk_run(run, *mover_));
    if (!outings_.back().failure.empty()) {
        score_.failure = run.name + ": " + outings_.back().failure;
        return false;
    }
    if (!is_done()) return true;
    for (const course::Bar& bar : scene_->bars) score_.marks.push_back({&bar, bar.measure(outings_)});
    return false;
}

}  // namespace surefoot::playground
