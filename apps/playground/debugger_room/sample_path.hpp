/// The places at which somebody looks who moves a step and then looks, and how a step follows from a frame rate.
#pragma once

#include <cstddef>
#include <vector>

#include "debugger/arena.hpp"

namespace surefoot::playground {

/// How fast something moves, and how often it is looked at.
struct Pace {
    double speed = 12;  ///< [m/s]
    double rate = 6;    ///< frames a second

    [[nodiscard]] double step() const { return speed / rate; }
    /// Keeps the speed.
    void set_step(double metres) { rate = speed / metres; }
};

struct Sample {
    dvec3 position{0, 0, 0};
    double along = 0;      ///< from START [m]
    bool touches = false;  ///< it overlaps something
    bool looked = true;    ///< no earlier sample touched, so the strategy came as far as this
};

/// At every step, and at END; those after a touch too, at which the strategy does not look any more. No more than
/// `most`. Requires: step > 0.
[[nodiscard]] std::vector<Sample> samples_along(const debugger::Arena& arena, const Volume& volume,
                                                const Motion& motion, double step, bool one_sided = false,
                                                std::size_t most = 400);

}  // namespace surefoot::playground
