#include "character/motion.hpp"

namespace surefoot::internal {

Travel accelerate(const Vec& velocity, const Vec& wish, double acceleration, double seconds) noexcept {
    const Vec change = wish - velocity;
    const double distance = length(change);
    if (distance == 0) return {wish, wish * seconds};
    const double needed = acceleration > 0 ? distance / acceleration : seconds * 2;
    if (needed >= seconds) {
        const Vec gained = change * (acceleration * seconds / distance);
        return {velocity + gained, (velocity + gained * 0.5) * seconds};
    }
    return {wish, (velocity + change * 0.5) * needed + wish * (seconds - needed)};
}

Flight fly(double speed, double rising, double falling, double terminal, double seconds) noexcept {
    Flight flight{speed, 0};
    double left = seconds;
    const auto spend = [&](double time, double gravity) {
        flight.rise += (flight.speed - 0.5 * gravity * time) * time;
        flight.speed -= gravity * time;
        left -= time;
    };
    if (flight.speed > 0 && rising > 0) {
        const double to_apex = flight.speed / rising;
        if (to_apex >= left) {
            spend(left, rising);
            return flight;
        }
        spend(to_apex, rising);
        flight.speed = 0;
    } else if (flight.speed > 0) {
        return {speed, speed * seconds};
    }
    if (flight.speed > -terminal && falling > 0) {
        const double to_terminal = (flight.speed + terminal) / falling;
        if (to_terminal >= left) {
            spend(left, falling);
            return flight;
        }
        spend(to_terminal, falling);
        flight.speed = -terminal;
    }
    flight.rise += flight.speed * left;
    return flight;
}

Vec finite_or_none(const dvec3& v) noexcept {
    constexpr double far = 1e9;
    const Vec vector = to_vec(v);
    return norm1(vector) < far ? vector : Vec{};  // false for what is no number
}

}  // namespace surefoot::internal
