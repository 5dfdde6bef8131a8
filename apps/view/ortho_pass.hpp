/// Draws a Canvas over whatever was drawn before: one draw call, whatever is on it.
#pragma once

#include "view/canvas.hpp"
#include "view/gl.hpp"
#include "view/picture.hpp"

namespace surefoot::view {

class OrthoPass {
public:
    OrthoPass();

    /// What `Canvas::picture` shows parts of. Opacity counts.
    void set_picture(const Picture& picture);

    /// Into this framebuffer object, of the size that the canvas was begun with.
    void draw(const Canvas& canvas, unsigned framebuffer);

private:
    gl::Program program_;
    gl::VertexArray array_;
    gl::Buffer buffer_;
    gl::Texture letters_;
    gl::Texture picture_;
    const Letters* held_ = nullptr;  // whose letters the texture holds, and which of their versions
    std::uint64_t version_ = 0;
};

}  // namespace surefoot::view
