#include "playground/debugger_room/contest.hpp"

#include <algorithm>
#include <cmath>

namespace surefoot::playground {

namespace {

constexpr double stairs_way = 8;         // what is wished for, all in all [m]
constexpr double ledge_way = 1.5;        // the start is a metre before the ledge
constexpr double ledge_fall_time = 0.7;  // all of the fall, and a moment to look at it [s]
constexpr double ticks_a_second = 1 / debugger::contest_tick;

}  // namespace

Contest::Contest() {
    read();
}

void Contest::choose(Course course) {
    if (course == course_) return;
    course_ = course;
    sunk_ = false;
    read();
    go_to(0);
}

void Contest::set_angle(double angle) {
    angle_ = std::clamp(angle, flattest, steepest);
    read();
}

void Contest::set_speed(double speed) {
    (course_ == Course::ledge ? ledge_speed_ : stairs_speed_) = std::clamp(speed, slowest, fastest);
    read();
    tick_ = std::min(tick_, last_tick());
}

void Contest::read() {
    for (std::size_t i = 0; i < count; ++i) {
        const Shape& shape = contestants_[i].shape;
        switch (course_) {
            case Course::slope:
                slopes_[i] = debugger::read_slope(shape, angle_);
                break;
            case Course::stairs: {
                const int ticks = static_cast<int>(std::ceil(ticks_a_second * stairs_way / stairs_speed_));
                stairs_[i] = debugger::read_stairs(shape, {}, stairs_speed_, ticks).places;
                break;
            }
            case Course::ledge: {
                const double seconds = ledge_way / ledge_speed_ + ledge_fall_time;
                const int ticks = static_cast<int>(std::ceil(ticks_a_second * seconds));
                ledges_[i] = debugger::read_ledge(shape, sink, ledge_speed_, ticks);
                const auto& all = ledges_[i].places;
                const double foot = debugger::foot_of(shape);
                const auto first = std::find_if(all.begin(), all.end(), [&](const CharacterState& state) {
                    return state.position.y + foot <= -sink;
                });
                sunk_at_[i] = static_cast<int>(std::min(first, all.end() - 1) - all.begin());
                break;
            }
        }
    }
}

const std::vector<CharacterState>& Contest::places(std::size_t i) const {
    return course_ == Course::ledge ? ledges_[i].places : stairs_[i];
}

int Contest::last_tick() const {
    return course_ == Course::slope ? 0 : static_cast<int>(places(0).size()) - 1;
}

void Contest::play() {
    sunk_ = false;
    if (tick_ >= last_tick()) tick_ = 0;
    plays_ = last_tick() > 0;
}

void Contest::go_to(int tick) {
    plays_ = false;
    sunk_ = false;
    tick_ = std::clamp(tick, 0, last_tick());
}

bool Contest::update() {
    if (!plays_) return false;
    ++tick_;
    if (tick_ >= last_tick()) plays_ = false;
    return true;
}

void Contest::show_sunk(bool shown) {
    sunk_ = shown;
    if (shown) plays_ = false;
}

int Contest::tick_of(std::size_t i) const {
    return shows_sunk() ? sunk_at_[i] : tick_;
}

const dvec3& Contest::position(std::size_t i) const {
    return course_ == Course::slope ? slopes_[i].position : places(i)[static_cast<std::size_t>(tick_of(i))].position;
}

dvec3 Contest::foot(std::size_t i) const {
    return position(i) + dvec3(0, debugger::foot_of(contestants_[i].shape), 0);
}

double Contest::climbed(std::size_t i) const {
    double highest = foot(i).y;
    for (const dvec3& print : footprints(i)) highest = std::max(highest, print.y);
    return highest;
}

std::vector<dvec3> Contest::footprints(std::size_t i) const {
    std::vector<dvec3> prints;
    if (course_ == Course::slope) return prints;
    const dvec3 down(0, debugger::foot_of(contestants_[i].shape), 0);
    for (int k = 0; k <= tick_of(i); ++k) prints.push_back(places(i)[static_cast<std::size_t>(k)].position + down);
    return prints;
}

}  // namespace surefoot::playground
