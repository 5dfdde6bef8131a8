/// One shadow map: a picture of depths from the sun over a round region of the world.
#pragma once

#include <surefoot/math.hpp>

#include "view/camera.hpp"
#include "view/gl.hpp"

namespace surefoot::view {

class ShadowMap {
public:
    explicit ShadowMap(int size);

    /// Looks at a ball from the sun; what stands up to `reach` nearer to the sun casts shadows into it too. Binds the
    /// framebuffer, empty.
    void begin(const dvec3& middle, double radius, double reach, const dvec3& towards_sun);

    /// From places relative to `origin` to clip space, while the map is drawn.
    [[nodiscard]] gl::mat4 clip_from(const dvec3& origin) const;

    /// From places relative to `eye` to places of the map and depths, 0 to 1.
    [[nodiscard]] gl::mat4 map_from(const dvec3& eye) const;

    [[nodiscard]] const gl::Texture& texture() const { return depth_; }
    [[nodiscard]] int size() const { return size_; }

    /// How large a texel is in the world [m].
    [[nodiscard]] double texel() const { return 2 * radius_ / size_; }

private:
    int size_;
    gl::Texture depth_;
    gl::Framebuffer framebuffer_;
    dvec3 middle_{0, 0, 0};
    double radius_ = 1;
    dmat4 clip_from_middle_{1};
};

}  // namespace surefoot::view
