/// Trying a hop in thought, with hands as late as the real ones.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "playtest/bots/foresight.hpp"
#include "playtest/bots/hop.hpp"
#include "playtest/bots/stand.hpp"

namespace surefoot::playtest {

/// Where exactly to come down: on a body not quite at its nearest edge. `spots` are the body's own (`Passages::spots`).
[[nodiscard]] HopAim aim_at(const Foresight& foresight, std::span<const dvec3> spots, const Stand& to,
                            const dvec3& feet);

[[nodiscard]] bool stands_on(const Foresight& foresight, std::span<const dvec3> spots, const game::Hero& hero,
                             const dvec3& feet, const Stand& to);

/// Does the hop end on its feet where it should, however late the hands are? `reset` puts foresight to where it begins.
/// `throws`: to touch what is aimed at is enough.
[[nodiscard]] bool rehearse(Foresight& foresight, const std::function<void()>& reset, const CharacterSettings& settings,
                            std::span<const dvec3> spots, const HopStyle& style, const Stand& to, bool throws);

/// How it might be done, the easiest first.
[[nodiscard]] std::vector<HopStyle> styles_for(double gap, double rise, bool dashes);

}  // namespace surefoot::playtest
