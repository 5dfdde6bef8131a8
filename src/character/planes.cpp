#include "character/planes.hpp"

#include <optional>

namespace surefoot::internal {

namespace {

// Rising costs this share of what going forward costs. Its square is what a 45 degree slope takes off the way.
constexpr double price_of_rising = 0x1p-10;

// Two planes whose crease is shorter than this, as the sine of their angle, meet nowhere that doubles could tell.
constexpr double parallel = 1e-9;

bool allows(std::span<const Vec> normals, const Vec& motion, double tolerance) noexcept {
    const double least = -tolerance * length(motion);
    for (const Vec& normal : normals) {
        if (dot(normal, motion) < least) return false;
    }
    return true;
}

template <typename Feasible>
std::optional<Vec> on_one_plane(std::span<const Vec> normals, const Vec& wish, const Feasible& feasible) noexcept {
    for (const Vec& normal : normals) {
        const double into = dot(normal, wish);
        if (into >= 0) continue;
        const Vec motion = wish - normal * into;
        if (feasible(motion)) return motion;
    }
    return std::nullopt;
}

// The wish is motion - x a - y b with both planes pushing, x and y >= 0.
template <typename Feasible>
std::optional<Vec> on_crease(std::span<const Vec> normals, const Vec& wish, const Feasible& feasible) noexcept {
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
            if (feasible(motion)) return motion;
        }
    }
    return std::nullopt;
}

template <typename Feasible>
Vec nearest(std::span<const Vec> normals, const Vec& wish, const Feasible& feasible) noexcept {
    if (const auto motion = on_one_plane(normals, wish, feasible)) return *motion;
    if (const auto motion = on_crease(normals, wish, feasible)) return *motion;
    return {};
}

// What the solutions are held to: half of what counts as along a plane, so that no plane that was obeyed is met again.
constexpr double solved_tolerance = 0.5 * along_tolerance;

}  // namespace

bool Planes3::add(const Vec& normal) noexcept {
    if (has(normal)) return true;
    if (count_ == most) return false;
    normals_[count_++] = normal;
    return true;
}

bool Planes3::has(const Vec& normal) const noexcept {
    for (const Vec& old : normals()) {
        const Vec difference = normal - old;
        if (dot(difference, difference) < parallel * parallel) return true;
    }
    return false;
}

Vec Planes3::nearest_to(const Vec& wish) const noexcept {
    if (allows(normals(), wish, solved_tolerance)) return wish;
    return nearest(normals(), wish,
                   [&](const Vec& motion) noexcept { return allows(normals(), motion, solved_tolerance); });
}

Vec Planes3::nearest_on_foot(const Vec& wish, const Vec& up) const noexcept {
    if (allows(normals(), wish, solved_tolerance)) return wish;
    // In a space that is flattened along `up` motions m become m' = m + up (up . m) (price - 1), and normals, which
    // keep n' . m' = n . m, the inverse. Nearest there is nearest on foot here.
    std::array<Vec, most> flattened;
    for (std::size_t i = 0; i < count_; ++i) {
        const Vec& n = normals_[i];
        const Vec tall = n + up * (dot(up, n) * (1 / price_of_rising - 1));
        flattened[i] = tall / length(tall);
    }
    const auto raised = [&](const Vec& flat) noexcept {
        return flat + up * (dot(up, flat) * (1 / price_of_rising - 1));
    };
    const Vec flat_wish = wish + up * (dot(up, wish) * (price_of_rising - 1));
    return raised(nearest({flattened.data(), count_}, flat_wish,
                          [&](const Vec& flat) noexcept { return allows(normals(), raised(flat), solved_tolerance); }));
}

}  // namespace surefoot::internal
