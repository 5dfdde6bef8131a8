/// What a lesson stands on: bodies of which only the upper edge matters, and rows of cubes, as one model.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include <surefoot/math.hpp>

#include "view/colour.hpp"
#include "view/model.hpp"

namespace surefoot::playground {

class Scenery {
public:
    /// Everything from the base up to the line through `top`, which goes towards +x and may go straight up or down,
    /// for z within +-half; all of it moved by `offset` and, if `turned`, turned half around the vertical before.
    struct Profile {
        std::span<const dvec3> top;  ///< z is not used
        double base = 0;
        double half = 1;
        dvec3 offset{0, 0, 0};
        bool turned = false;
        view::Colour colour;
        view::Colour side;
    };
    void add(const Profile& profile);

    [[nodiscard]] std::shared_ptr<const view::Model> model() const;

private:
    void quad(const Profile& profile, const dvec3& a, const dvec3& b, const dvec3& c, const dvec3& d,
              view::Colour colour);

    std::vector<vec3> vertices_;
    std::vector<std::uint32_t> indices_;
    std::vector<view::Colour> colours_;  // of triangles
};

/// Half around the vertical through the origin.
[[nodiscard]] inline dvec3 half_turned(const dvec3& p) {
    return {-p.x, p.y, -p.z};
}

}  // namespace surefoot::playground
