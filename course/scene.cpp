#include "course/scene.hpp"

#include <cmath>

namespace surefoot::course {

std::span<const Spot> Outing::scripted() const {
    std::size_t first = 0;
    while (first + 1 < spots.size() && spots[first].time < -1e-9) ++first;
    return std::span(spots).subspan(first);
}

void Worst::take(double measured, const std::string& run) {
    if (std::isnan(value) || measured <= value) return;
    value = measured;
    where = run;
}

CharacterSettings hero() {
    CharacterSettings settings;
    settings.volume = Capsule{.radius = 0.4, .half_height = 0.5};
    settings.acceleration = settings.braking = settings.air_acceleration = 1e9;
    return settings;
}

Script walk(const dvec3& wish) {
    return [wish](double, const Spot&) { return Input{wish}; };
}

dvec3 heading(double degrees, double speed) {
    // Quarter turns come out as they are written, without the rounding of a cosine.
    const double quarters = degrees / 90;
    if (quarters == std::floor(quarters)) {
        const int turn = ((static_cast<int>(quarters) % 4) + 4) % 4;
        return dvec3{turn == 0 ? 1 : turn == 2 ? -1 : 0, 0, turn == 1 ? 1 : turn == 3 ? -1 : 0} * speed;
    }
    return dvec3{std::cos(radians(degrees)), 0, std::sin(radians(degrees))} * speed;
}

}  // namespace surefoot::course
