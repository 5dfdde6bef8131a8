/// Lines of any width in pixels with round ends, points and arrows: collected, then drawn all at once.
#pragma once

#include <vector>

#include <surefoot/math.hpp>

#include "view/camera.hpp"
#include "view/colour.hpp"
#include "view/gl.hpp"

namespace surefoot::view {

/// How a line looks.
struct Stroke {
    Colour colour = paint::ink;
    double width = 2;      ///< [window units]
    double behind = 0.22;  ///< how much of it is seen through what hides it [0 nothing, 1 all]
};

class LinePass {
public:
    LinePass();

    /// `from` and `to` are relative to the eye; widths at either end in pixels.
    void add(const vec3& from, const vec3& to, double from_width, double to_width, Colour colour, double behind);
    void clear() { lines_.clear(); }
    [[nodiscard]] std::size_t size() const { return lines_.size(); }

    /// `pixel` is how large one is at a metre from the eye. Into the framebuffer that is bound, against its depth.
    void draw(const gl::mat4& clip_from_eye, const gl::ivec2& picture, double nearest, double pixel);

private:
    struct Line {
        vec3 from;
        vec3 to;
        float from_width;
        float to_width;
        float behind;
        Colour colour;
    };
    static_assert(sizeof(Line) == 40);

    gl::Program program_;
    gl::VertexArray array_;
    gl::Buffer buffer_;
    std::vector<Line> lines_;
};

}  // namespace surefoot::view
