/// What can be shown of an incident when its run is played again: frames of the moment and of what led to it, and its
/// last seconds as seen from above.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "game/recording.hpp"
#include "playtest/report/frame.hpp"
#include "playtest/telemetry.hpp"

namespace surefoot::playtest {

struct Still {
    std::uint64_t tick = 0;
    Picture picture;
};

/// A part of the level that moves, or an enemy, while a clip goes on.
struct ClipMover {
    bool is_enemy = false;
    dvec3 half{0, 0, 0};          ///< of its box, about its place [m]
    std::vector<dvec3> places{};  ///< of the middle of that box; below everything while it is not there
    std::vector<double> yaws{};   ///< [rad]
};

/// The last ten seconds, in samples of `clip_every` ticks, all lists equally long.
struct Clip {
    std::uint64_t first_tick = 0;
    std::vector<dvec3> feet{};
    std::vector<double> looks{};  ///< the yaw of the player's look [degrees]
    std::vector<ClipMover> movers{};
};

inline constexpr std::uint64_t clip_every = 4;    ///< ticks
inline constexpr std::uint64_t clip_ticks = 600;  ///< of play

struct Exhibit {
    std::vector<Still> stills{};  ///< in the order of time
    std::size_t moment = 0;       ///< the largest of them: the moment itself or, of a fall, where it began
    Clip clip{};
};

/// Plays the recording once to see what happened and once more to draw it: one exhibit for each of the incidents, which
/// are of this run. Where the hero is nowhere there are no stills. Fails as
/// `game::start_of` does.
[[nodiscard]] Expected<std::vector<Exhibit>> exhibits_of(const std::shared_ptr<const game::Level>& level,
                                                         const game::Recording& recording,
                                                         std::span<const Incident> incidents,
                                                         const FramePainter& painter);

}  // namespace surefoot::playtest
