#include "platformer/play/pilot.hpp"

#include "playtest/bots/atlas.hpp"
#include "playtest/bots/navigator.hpp"

namespace surefoot::platformer {
namespace {

struct Mind {
    std::shared_ptr<const playtest::Atlas> atlas;
    std::unique_ptr<playtest::Navigator> navigator;
};

void study(Mind& mind, const game::Game& game, std::uint64_t seed) {
    mind.navigator.reset();
    auto atlas = playtest::Atlas::make(game.level_pointer());
    if (!atlas) return;
    mind.atlas = std::move(*atlas);
    auto navigator = playtest::Navigator::make(mind.atlas, {.seed = seed});
    if (navigator) mind.navigator = std::move(*navigator);
}

}  // namespace

Pilot bot_pilot(std::uint64_t seed) {
    const auto mind = std::make_shared<Mind>();
    return {.study = [mind, seed](const game::Game& game) { study(*mind, game, seed); },
            .decide = [mind](const game::Game& game) -> game::HeroInput {
                if (!mind->navigator || !mind->navigator->gave_up().empty()) return {};
                return mind->navigator->decide(game);
            }};
}

}  // namespace surefoot::platformer
