#include "sweep/round_features.hpp"

#include "exact/products.hpp"
#include "fault.hpp"

namespace surefoot::internal {

namespace {

RoundNormals normals_of_pass(const Vec& closest, double distance, const Vec& onward, double radius) noexcept {
    if (distance >= radius) return {closest, {}};
    const double half_chord = std::sqrt((radius - distance) * (radius + distance));
    if (has_fault(Fault::larger_root)) return {closest + onward * half_chord, {}};
    return {closest - onward * half_chord, closest + onward * half_chord};
}

double inflated(double radius, const Vec& feature) noexcept {
    return radius + inflation_share * (radius + norm1(feature));
}

}  // namespace

RoundNormals ball_against_point(const Vec& point, const Vec& along, double radius) noexcept {
    const Vec onward = unit(along);
    Vec closest = onward * dot(point, onward) - point;
    closest = closest - onward * dot(closest, onward);
    return normals_of_pass(closest, length(closest), onward, inflated(radius, point));
}

RoundNormals ball_against_line(const Vec& point, const Vec& direction, const Vec& along, double radius) noexcept {
    const Vec line = unit(direction);
    if (line == Vec{}) return {};
    const Vec across = unit(accurate_cross(scaled_to_one(along), scaled_to_one(direction)));
    if (across == Vec{}) {
        // Along the line: the distance never changes.
        Vec closest = line * dot(point, line) - point;
        closest = closest - line * dot(closest, line);
        return {closest, {}};
    }
    const Vec onward = unit(cross(line, across));
    const double offset = -dot(point, across);
    return normals_of_pass(across * offset, absolute(offset), onward, inflated(radius, point));
}

}  // namespace surefoot::internal
