// Coins, and the places where one begins again: things that come and go, in pools.
#pragma once

#include "level.hpp"

namespace day {

// [pools]
struct Coin {
    dvec3 place;
};
struct Checkpoint {
    dvec3 place;
    bool is_reached = false;
};

struct Pickups {
    surefoot::Slab<Coin> coins{64};
    surefoot::Slab<Checkpoint> checkpoints{16};
    surefoot::Slab<Checkpoint>::Handle last;  // the one that was reached last; at first it names nothing

    explicit Pickups(const Level& level) {
        for (const dvec3& place : places(level, "coin")) (void)coins.insert(place);
        for (const dvec3& place : places(level, "checkpoint")) (void)checkpoints.insert(place);
    }
};

/// Erases what `is_gone` says yes to. The iterator has left an object before it dies.
template <typename T, typename IsGone>
void erase_if(surefoot::Slab<T>& slab, const IsGone& is_gone) {
    for (auto at = slab.begin(); at != slab.end();) {
        const auto handle = at.handle();
        ++at;
        if (is_gone(slab[handle])) slab.erase(handle);
    }
}
// [/pools]

// [touch]
inline bool is_near(const dvec3& feet, const dvec3& place, double radius) {
    return glm::distance(feet, place) < radius;
}

/// Takes what the feet are at.
inline void touch(Pickups& pickups, const dvec3& feet) {
    erase_if(pickups.coins, [&](const Coin& coin) { return is_near(feet, coin.place, 0.8); });
    for (auto at = pickups.checkpoints.begin(); at != pickups.checkpoints.end(); ++at) {
        if (at->is_reached || !is_near(feet, at->place, 2)) continue;
        at->is_reached = true;
        pickups.last = at.handle();
    }
}

/// Where the hero begins again.
inline dvec3 restart_place(const Pickups& pickups, const Level& level) {
    const Checkpoint* const checkpoint = pickups.checkpoints.get(pickups.last);
    return checkpoint != nullptr ? checkpoint->place : places(level, "spawn").at(0);
}
// [/touch]

}  // namespace day
