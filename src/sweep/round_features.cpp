#include "sweep/round_features.hpp"

#include "exact/products.hpp"
#include "fault.hpp"

namespace surefoot::internal {

namespace {

// Hairs of the world, along the normal that `closest` stands for, in the ball's space.
Hairs squashed(const Hairs& hairs, const Vec& closest, const Ball& ball) noexcept {
    const double scale = inflation * length(divide_each(unit(closest), ball.squash));
    return {hairs.own * scale, hairs.triangle * scale};
}

}  // namespace

RoundNormals normals_of_pass(const Vec& closest, const Vec& onward, double radius, const Hairs& hairs) noexcept {
    const double distance = length(closest);
    const auto half_chord = [&](double inflated) {
        return distance < inflated ? std::sqrt((inflated - distance) * (inflated + distance)) : -1;
    };
    RoundNormals normals;
    const double half = half_chord(radius + hairs.own);
    if (half >= 0) {
        normals.entry = closest - onward * half;
        normals.exit = closest + onward * half;
        if (has_fault(Fault::larger_root)) normals.entry = normals.exit;
    }
    if (distance < radius - hairs.triangle) return normals;
    normals.passing = closest;
    const double wide = half_chord(radius + hairs.triangle);
    if (wide >= 0) {
        normals.grazing_entry = closest - onward * wide;
        normals.grazing_exit = closest + onward * wide;
    }
    return normals;
}

RoundNormals ball_against_point(const Vec& point, const Vec& along, const Ball& ball) noexcept {
    const Vec onward = unit(along);
    Vec closest = onward * dot(point, onward) - point;
    closest = closest - onward * dot(closest, onward);
    return normals_of_pass(closest, onward, ball.radius, squashed(ball.hairs, closest, ball));
}

RoundNormals ball_against_line(const Vec& point, const Vec& direction, const Vec& along, const Ball& ball) noexcept {
    const Vec line = unit(direction);
    if (line == Vec{}) return {};
    const Vec across = unit(accurate_cross(scaled_to_one(along), scaled_to_one(direction)));
    if (across == Vec{}) {
        // Along the line: the distance never changes.
        Vec closest = line * dot(point, line) - point;
        closest = closest - line * dot(closest, line);
        RoundNormals normals;
        normals.passing = closest;
        return normals;
    }
    const Vec onward = unit(cross(line, across));
    return normals_of_pass(across * -dot(point, across), onward, ball.radius, squashed(ball.hairs, across, ball));
}

}  // namespace surefoot::internal
