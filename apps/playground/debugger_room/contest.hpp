/// Five shapes on the same course, and a clock that can be stopped, stepped and turned back. All places are worked out
/// when the course or its settings change; a moment is no more than a number among them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "debugger/side_by_side.hpp"

namespace surefoot::playground {

enum class Course : std::uint8_t { slope, stairs, ledge };

class Contest {
public:
    static constexpr std::size_t count = 5;
    static constexpr double sink = 0.05;  ///< by which a foot has to be below a ledge to have sunk [m]
    static constexpr double flattest = 0, steepest = 1.0471975511965976;  ///< slopes [rad]
    static constexpr double slowest = 0.25, fastest = 4;                  ///< [m/s]

    Contest();

    void choose(Course course);
    void set_angle(double angle);  ///< of the slope [rad, flattest to steepest]
    void set_speed(double speed);  ///< on the course that is shown [m/s, slowest to fastest]

    [[nodiscard]] Course course() const { return course_; }
    [[nodiscard]] double angle() const { return angle_; }
    [[nodiscard]] double speed() const { return course_ == Course::ledge ? ledge_speed_ : stairs_speed_; }
    [[nodiscard]] const debugger::Contestant& contestant(std::size_t i) const { return contestants_[i]; }

    /// On a slope nothing moves: everybody stands there, at tick 0 of 0.
    [[nodiscard]] int tick() const { return tick_; }
    [[nodiscard]] int last_tick() const;
    [[nodiscard]] bool plays() const { return plays_; }
    void play();  ///< from the start, if it is at the end
    void pause() { plays_ = false; }
    void step(int by = 1) { go_to(tick_ + by); }
    void restart() { go_to(0); }
    void go_to(int tick);  ///< and stops there; out of range is the nearest that is in range

    /// A tick of 1/60 s; true while it plays.
    bool update();

    /// Over the ledge, everybody at the first tick at which its own foot has sunk, whatever the clock says.
    void show_sunk(bool shown);
    [[nodiscard]] bool shows_sunk() const { return sunk_ && course_ == Course::ledge; }

    /// At which tick a contestant is shown, and where it is then.
    [[nodiscard]] int tick_of(std::size_t i) const;
    [[nodiscard]] const dvec3& position(std::size_t i) const;
    [[nodiscard]] dvec3 foot(std::size_t i) const;

    /// The highest that a foot came to until now [m].
    [[nodiscard]] double climbed(std::size_t i) const;

    /// Where its foot was, tick by tick, up to now.
    [[nodiscard]] std::vector<dvec3> footprints(std::size_t i) const;

    [[nodiscard]] const debugger::SlopeReading& slope(std::size_t i) const { return slopes_[i]; }
    [[nodiscard]] const debugger::LedgeReading& ledge(std::size_t i) const { return ledges_[i]; }

private:
    [[nodiscard]] const std::vector<CharacterState>& places(std::size_t i) const;
    void read();

    std::array<debugger::Contestant, count> contestants_ = debugger::contestants();
    Course course_ = Course::slope;
    double angle_ = steepest / 2;
    double stairs_speed_ = 2;
    double ledge_speed_ = 0.5;
    int tick_ = 0;
    bool plays_ = false;
    bool sunk_ = false;
    std::array<debugger::SlopeReading, count> slopes_;
    std::array<std::vector<CharacterState>, count> stairs_;
    std::array<debugger::LedgeReading, count> ledges_;
    std::array<int, count> sunk_at_{};
};

}  // namespace surefoot::playground
