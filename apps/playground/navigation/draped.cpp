#include "playground/navigation/draped.hpp"

#include <algorithm>
#include <glm/geometric.hpp>
#include <utility>

namespace surefoot::playground {
namespace {

constexpr double least_side = 0.5;  // that is still cut [m]
constexpr double bend = 0.04;       // how far the ground may be from the middle of a side that stays whole [m]

class Drape {
public:
    Drape(const World& world, const NavigationMesh& mesh)
        : world_(world), up_(mesh.up()), reach_(mesh.up() * (0.8 * mesh.agent().height)) {}

    [[nodiscard]] dvec3 ground(const dvec3& place) const {
        const auto hit = world_.ray({place + reach_, place - reach_});
        return hit && hit->status == HitStatus::ok ? hit->point : place;
    }

    /// Level length: at a cliff, pieces of a side do not get shorter than the cliff is high.
    [[nodiscard]] double across(const dvec3& way) const { return glm::length(way - up_ * glm::dot(way, up_)); }

    /// The ground below the middle of a side, if the side has to be cut there: the same from both of its ends.
    [[nodiscard]] bool cut(const dvec3& a, const dvec3& b, dvec3& middle) const {
        const dvec3 flat = (a + b) * 0.5;
        if (across(b - a) < least_side) return false;
        middle = ground(flat);
        return glm::length(middle - flat) > bend;
    }

    void side(std::vector<dvec3>& line, const dvec3& a, const dvec3& b) const {
        if (dvec3 middle; cut(a, b, middle)) {
            side(line, a, middle);
            side(line, middle, b);
        } else {
            line.push_back(b);
        }
    }

    void triangle(std::vector<std::array<dvec3, 3>>& found, std::array<dvec3, 3> t, int depth) const {
        constexpr int deepest = 16;
        // The longest of the sides that bend is cut first, so that pieces do not get thin.
        double longest = 0;
        std::size_t which = 3;
        dvec3 at{0, 0, 0};
        for (std::size_t i = 0; i < 3; ++i) {
            const double length = across(t[(i + 1) % 3] - t[i]);
            dvec3 middle;
            if (length <= longest || !cut(t[i], t[(i + 1) % 3], middle)) continue;
            longest = length;
            which = i;
            at = middle;
        }
        if (which == 3 || depth >= deepest) {
            found.push_back(t);
            return;
        }
        const std::size_t next = (which + 1) % 3;
        const std::size_t other = (which + 2) % 3;
        triangle(found, {t[which], at, t[other]}, depth + 1);
        triangle(found, {at, t[next], t[other]}, depth + 1);
    }

private:
    const World& world_;
    dvec3 up_;
    dvec3 reach_;
};

}  // namespace

DrapedPolygon drape(const World& world, const NavigationMesh& mesh, const NavigationOutline& outline) {
    const Drape on(world, mesh);
    DrapedPolygon draped;
    std::array<dvec3, 6> corners{};
    for (std::uint32_t i = 0; i < outline.corners; ++i) corners[i] = on.ground(outline.corner[i]);
    for (std::uint32_t i = 0; i < outline.corners; ++i) {
        draped.sides[i].push_back(corners[i]);
        on.side(draped.sides[i], corners[i], corners[(i + 1) % outline.corners]);
    }
    for (std::uint32_t i = 2; i < outline.corners; ++i)
        on.triangle(draped.triangles, {corners[0], corners[i - 1], corners[i]}, 0);
    return draped;
}

}  // namespace surefoot::playground
