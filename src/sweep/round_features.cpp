#include "sweep/round_features.hpp"

#include "exact/products.hpp"
#include "fault.hpp"

namespace surefoot::internal {

namespace {

// A hair of the world, along the normal that `closest` stands for, in the ball's space.
double squashed_hair(const Vec& closest, const Ball& ball) noexcept {
    return inflation * ball.hair * length(divide_each(unit(closest), ball.squash));
}

}  // namespace

RoundNormals normals_of_pass(const Vec& closest, const Vec& onward, double radius, double hair) noexcept {
    const double inflated = radius + hair;
    const double distance = length(closest);
    RoundNormals normals;
    if (distance >= radius - hair) normals.passing = closest;
    if (distance >= inflated) return normals;
    const double half_chord = std::sqrt((inflated - distance) * (inflated + distance));
    normals.entry = closest - onward * half_chord;
    normals.exit = closest + onward * half_chord;
    if (has_fault(Fault::larger_root)) normals.entry = normals.exit;
    return normals;
}

RoundNormals ball_against_point(const Vec& point, const Vec& along, const Ball& ball) noexcept {
    const Vec onward = unit(along);
    Vec closest = onward * dot(point, onward) - point;
    closest = closest - onward * dot(closest, onward);
    return normals_of_pass(closest, onward, ball.radius, squashed_hair(closest, ball));
}

RoundNormals ball_against_line(const Vec& point, const Vec& direction, const Vec& along, const Ball& ball) noexcept {
    const Vec line = unit(direction);
    if (line == Vec{}) return {};
    const Vec across = unit(accurate_cross(scaled_to_one(along), scaled_to_one(direction)));
    if (across == Vec{}) {
        // Along the line: the distance never changes.
        Vec closest = line * dot(point, line) - point;
        closest = closest - line * dot(closest, line);
        return {.entry = {}, .exit = {}, .passing = closest};
    }
    const Vec onward = unit(cross(line, across));
    return normals_of_pass(across * -dot(point, across), onward, ball.radius, squashed_hair(across, ball));
}

}  // namespace surefoot::internal
