#include <cassert>

#include <surefoot/character.hpp>

#include "character/body.hpp"
#include "character/form.hpp"
#include "character/many.hpp"

namespace surefoot {
inline namespace v0 {

void step_all(const World& world, const Characters& characters, double dt, StepRange range) noexcept {
    if (!internal::fit_together(characters)) {
        assert(false && "step_all: one of settings and inputs for all or one each, and room for every answer");
        return;
    }
    internal::each_in(characters, range, [&](std::size_t i) noexcept {
        internal::answer(characters, i,
                         step(world, internal::one_of(characters.settings, i), internal::one_of(characters.inputs, i),
                              dt, characters.before[i]));
    });
}

Neighbour neighbour_of(const CharacterSettings& settings, const CharacterInput& input, const CharacterState& state,
                       std::uint32_t id) noexcept {
    const internal::Vec up = internal::to_vec(input.up);
    Neighbour neighbour;
    neighbour.volume = internal::turned_to(internal::volume_of(settings, state.form), up / internal::length(up));
    neighbour.position = state.position;
    neighbour.velocity = state.velocity;
    neighbour.id = id;
    neighbour.carrier = state.ground_body;
    neighbour.is_carried = state.footing != Footing::air;
    neighbour.firmness = settings.firmness;
    return neighbour;
}

}  // namespace v0
}  // namespace surefoot
