/// What is noted down of a run: where somebody died, how long each section took, which jumps failed, where they got
/// stuck, where they stood and looked.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <surefoot/capture_step.hpp>

#include "game/game.hpp"

namespace surefoot::playtest {

/// So wide are the cells in which it is counted where somebody stood and looked, seen from above [m].
inline constexpr double heat_cell = 0.5;

/// Cells by x and z, and how many ticks were counted in each.
using HeatMap = std::map<std::array<int, 2>, std::uint32_t>;

struct Incident {
    enum class Kind : std::uint8_t { death, failed_jump, stuck, escape, not_a_number, overflow } kind = Kind::death;
    game::Cause cause = game::Cause::none;  ///< of a death
    std::uint32_t section = 0;              ///< of `Level::checkpoints`: the one reached last
    std::uint64_t tick = 0;
    dvec3 place{0, 0, 0};
    std::vector<dvec3> trail{};            ///< of the feet, the last five seconds of it
    std::optional<StepCapture> capture{};  ///< of a stuck moment: the step, to be made again
    std::string note{};
};

[[nodiscard]] std::string_view name_of(Incident::Kind kind);

struct Telemetry {
    std::string level{};   ///< `Level::id`
    std::string player{};  ///< a name, or a bot's
    bool won = false;
    double seconds = 0;
    std::uint32_t begun_in = 0;             ///< the section that it began in
    std::uint32_t section = 0;              ///< the last that was reached
    std::vector<double> section_seconds{};  ///< by section
    std::vector<std::uint32_t> section_deaths{};
    std::vector<bool> section_reached{};
    std::vector<std::uint32_t> taken{};  ///< pickups, of `Level::pickups`
    std::uint64_t jumps = 0;
    std::uint64_t presses = 0;
    std::vector<Incident> incidents{};
    HeatMap stood{};
    HeatMap looked{};
    std::string gave_up{};  ///< why, if it did

    [[nodiscard]] std::size_t count(Incident::Kind kind) const;
};

/// Watches a game being played: to be told after every tick.
class Observer {
public:
    /// `checkpoint`: at which the game was started.
    Observer(const game::Level& level, std::string player, std::uint32_t checkpoint = 0);

    void tick(const game::HeroInput& input, const game::Game& game);

    [[nodiscard]] const Telemetry& telemetry() const { return told_; }
    [[nodiscard]] Telemetry& telemetry() { return told_; }

private:
    void add(Incident::Kind kind, const game::Game& game, game::Cause cause = game::Cause::none, std::string note = {});
    void watch_events(const game::Game& game);
    void watch_jump(const game::Game& game);
    void watch_stuck(const game::HeroInput& input, const game::Game& game);
    void watch_sanity(const game::Game& game);
    void watch_look(const game::HeroInput& input, const game::Game& game);

    Telemetry told_;
    std::deque<dvec3> trail_;
    std::optional<std::uint64_t> jump_at_;
    dvec3 jump_from_{0, 0, 0};
    dvec3 stuck_from_{0, 0, 0};
    dvec3 stuck_wish_{0, 0, 0};
    int wishes_for_ = 0;             ///< ticks
    int stood_for_ = 0;              ///< of these, on something
    int turned_for_ = 0;             ///< it has tried the other way for so many ticks
    bool lets_go_ = false;           ///< it has held crouch since it wanted to go
    std::uint64_t quiet_until_ = 0;  ///< of the same kind of trouble, so that one place is one incident
    std::uint8_t buttons_ = 0;
};

/// As one object of JSON, without the steps of stuck moments, and back. Reading fails with `unreadable`.
[[nodiscard]] std::string to_json(const Telemetry& telemetry);
[[nodiscard]] Expected<Telemetry> telemetry_of(const std::string& json, const std::string& file);

}  // namespace surefoot::playtest
