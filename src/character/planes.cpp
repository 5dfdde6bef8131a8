#include "character/planes.hpp"

#include <optional>

namespace surefoot::internal {

namespace {

// Rising costs this share of what going forward costs. Its square is what a 45 degree slope takes off the way.
constexpr double price_of_rising = 0x1p-10;

// Two planes whose crease is shorter than this, as the sine of their angle, meet nowhere that doubles could tell.
constexpr double parallel = 1e-9;

// Is the motion within the tolerance on the good side of all planes? `scale` is the length of the wish.
bool violates_none(std::span<const Vec> normals, const Vec& motion, double scale) noexcept {
    for (const Vec& normal : normals) {
        if (dot(normal, motion) < -along_tolerance * 0.5 * scale) return false;
    }
    return true;
}

std::optional<Vec> on_one_plane(std::span<const Vec> normals, const Vec& wish, double scale) noexcept {
    for (const Vec& normal : normals) {
        const double into = dot(normal, wish);
        if (into >= 0) continue;
        const Vec motion = wish - normal * into;
        if (violates_none(normals, motion, scale)) return motion;
    }
    return std::nullopt;
}

// The wish is motion - x a - y b with both planes pushing, x and y >= 0.
std::optional<Vec> on_crease(std::span<const Vec> normals, const Vec& wish, double scale) noexcept {
    for (std::size_t i = 0; i < normals.size(); ++i) {
        for (std::size_t j = i + 1; j < normals.size(); ++j) {
            const Vec& a = normals[i];
            const Vec& b = normals[j];
            const Vec crease = cross(a, b);
            const double square = dot(crease, crease);
            if (square < parallel * parallel) continue;
            const Vec motion = crease * (dot(crease, wish) / square);
            const Vec pushed = motion - wish;
            const double cosine = dot(a, b);
            const double x = (dot(a, pushed) - cosine * dot(b, pushed)) / square;
            const double y = (dot(b, pushed) - cosine * dot(a, pushed)) / square;
            if (x < 0 || y < 0) continue;
            if (violates_none(normals, motion, scale)) return motion;
        }
    }
    return std::nullopt;
}

Vec nearest_to(std::span<const Vec> normals, const Vec& wish) noexcept {
    const double scale = length(wish);
    if (violates_none(normals, wish, 0)) return wish;
    if (const auto motion = on_one_plane(normals, wish, scale)) return *motion;
    if (const auto motion = on_crease(normals, wish, scale)) return *motion;
    return {};
}

}  // namespace

bool Planes3::add(const Vec& normal) noexcept {
    for (const Vec& old : normals()) {
        const Vec difference = normal - old;
        if (dot(difference, difference) < parallel * parallel) return true;
    }
    if (count_ == most) return false;
    normals_[count_++] = normal;
    return true;
}

bool Planes3::allow(const Vec& motion) const noexcept {
    return violates_none(normals(), motion, 2 * length(motion));
}

Vec Planes3::nearest_to(const Vec& wish) const noexcept {
    return internal::nearest_to(normals(), wish);
}

Vec Planes3::nearest_on_foot(const Vec& wish, const Vec& up) const noexcept {
    // In a space that is flattened along `up` motions m become m' = m + up (up . m) (price - 1), and normals, which
    // keep n' . m' = n . m, the inverse. Nearest there is nearest on foot here.
    std::array<Vec, most> flattened;
    for (std::size_t i = 0; i < count_; ++i) {
        const Vec& n = normals_[i];
        const Vec tall = n + up * (dot(up, n) * (1 / price_of_rising - 1));
        flattened[i] = tall / length(tall);
    }
    if (violates_none(normals(), wish, 0)) return wish;
    const Vec flat_wish = wish + up * (dot(up, wish) * (price_of_rising - 1));
    const Vec flat = internal::nearest_to({flattened.data(), count_}, flat_wish);
    return flat + up * (dot(up, flat) * (1 / price_of_rising - 1));
}

}  // namespace surefoot::internal
