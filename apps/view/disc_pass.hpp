/// Soft discs: halos around what shines, pools of light, and the shade under somebody's feet.
#pragma once

#include <vector>

#include <surefoot/math.hpp>

#include "view/colour.hpp"
#include "view/gl.hpp"

namespace surefoot::view {

struct Disc {
    dvec3 place{0, 0, 0};
    double radius = 1;                  ///< where it ends [m]
    dvec3 normal{0, 0, 0};              ///< unit: it lies on what has this normal; zero: it faces the eye
    Colour colour{255, 255, 255, 255};  ///< its opacity is how strong it is in the middle
    double core = 0;                    ///< which part of the radius is as strong as the middle [0 to 1]
    bool is_light = false;              ///< it adds to what is behind it, and does not cover it
};

class DiscPass {
public:
    DiscPass();

    void clear() { discs_.clear(); }
    void add(const Disc& disc) { discs_.push_back(disc); }
    [[nodiscard]] std::size_t size() const { return discs_.size(); }

    /// In the order in which they came, against the depth of what is bound.
    void draw(const gl::mat4& clip_from_eye, const dvec3& eye, const dvec3& right, const dvec3& above);

private:
    struct Instance {
        gl::vec3 place;
        gl::vec3 side;  // half of it
        gl::vec3 other;
        gl::vec4 colour;  // multiplied by its opacity; of the opacity only what covers
        float core;
    };

    gl::Program program_;
    gl::VertexArray array_;
    gl::Buffer buffer_;
    std::vector<Disc> discs_;
    std::vector<Instance> instances_;
};

}  // namespace surefoot::view
