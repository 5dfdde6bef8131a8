#include "character/contacts.hpp"

#include "character/tick.hpp"

namespace surefoot::internal {

namespace {

// Those on one triangle are one. Of too many the first are kept: what is met at last is met with what is left.
void add(CharacterContacts& to, const CharacterContact& contact) noexcept {
    for (std::size_t i = 0; i < to.count; ++i) {
        CharacterContact& known = to.all[i];
        if (known.body != contact.body || known.triangle != contact.triangle) continue;
        known.impulse += contact.impulse;
        return;
    }
    if (to.count < to.all.size()) to.all[to.count++] = contact;
}

}  // namespace

void press(Tick& tick, std::span<const Obstacle> met, const Vec& velocity) noexcept {
    for (const Obstacle& one : met) {
        const double taken = -dot(one.normal, velocity - velocity_at(tick, one.body, one.point));
        if (!(taken > 0)) continue;
        add(tick.contacts, {.point = to_dvec3(one.point),
                            .normal = to_dvec3(one.normal),
                            .impulse = to_dvec3(one.normal * -taken),
                            .body = one.body,
                            .triangle = one.triangle});
    }
}

void weigh(Tick& tick) noexcept {
    if (!tick.standing || tick.ground.footing != Footing::ground) return;
    add(tick.contacts, {.point = to_dvec3(tick.ground.point),
                        .normal = to_dvec3(tick.ground.contact_normal),
                        .impulse = to_dvec3(tick.up * -(tick.settings.gravity * tick.dt)),
                        .body = tick.ground.body,
                        .triangle = tick.ground.triangle});
}

CharacterContacts merged(const CharacterContacts& first, const CharacterContacts& second) noexcept {
    CharacterContacts both = first;
    for (std::size_t i = 0; i < second.count; ++i) add(both, second.all[i]);
    return both;
}

}  // namespace surefoot::internal
