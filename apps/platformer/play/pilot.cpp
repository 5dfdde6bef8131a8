#include "platformer/play/pilot.hpp"

#include "playtest/atlas.hpp"
#include "playtest/navigator.hpp"

namespace surefoot::platformer {
namespace {

struct Mind {
    const game::Game* game = nullptr;  // that it plays
    std::shared_ptr<const playtest::Atlas> atlas;
    std::unique_ptr<playtest::Navigator> navigator;
};

void study(Mind& mind, const game::Game& game, std::uint64_t seed) {
    mind.game = &game;
    mind.navigator.reset();
    auto atlas = playtest::Atlas::make(game.level_pointer());
    if (!atlas) return;
    mind.atlas = std::move(*atlas);
    auto navigator = playtest::Navigator::make(mind.atlas, {.seed = seed});
    if (navigator) mind.navigator = std::move(*navigator);
}

}  // namespace

Pilot bot_pilot(std::uint64_t seed) {
    return [mind = std::make_shared<Mind>(), seed](const game::Game& game) -> game::HeroInput {
        if (mind->game != &game || game.ticks() == 0) study(*mind, game, seed);
        if (!mind->navigator || !mind->navigator->gave_up().empty()) return {};
        return mind->navigator->decide(game);
    };
}

}  // namespace surefoot::platformer
