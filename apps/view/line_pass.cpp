#include "view/line_pass.hpp"

#include <algorithm>
#include <cstddef>

#include "view/shaders.hpp"

namespace surefoot::view {
namespace {

// How much nearer to the eye a line counts as than it is, so that it lies on the surface that it runs along.
constexpr float lift = 0.0015F;

}  // namespace

LinePass::LinePass()
    : program_("line", shaders::line_vertex, shaders::line_fragment),
      array_(gl::VertexArray::make()),
      buffer_(gl::Buffer::make()) {
    glBindVertexArray(array_.id());
    glBindBuffer(GL_ARRAY_BUFFER, buffer_.id());
    glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(Line), gl::offset(offsetof(Line, from)));
    glVertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, sizeof(Line), gl::offset(offsetof(Line, to)));
    glVertexAttribPointer(2, 3, GL_FLOAT, GL_FALSE, sizeof(Line), gl::offset(offsetof(Line, from_width)));
    glVertexAttribPointer(3, 4, GL_UNSIGNED_BYTE, GL_TRUE, sizeof(Line), gl::offset(offsetof(Line, colour)));
    for (const GLuint attribute : {0U, 1U, 2U, 3U}) {
        glEnableVertexAttribArray(attribute);
        glVertexAttribDivisor(attribute, 1);
    }
    glBindVertexArray(0);
}

void LinePass::add(const vec3& from, const vec3& to, double from_width, double to_width, Colour colour, double behind) {
    lines_.push_back(
        {from, to, static_cast<float>(from_width), static_cast<float>(to_width), static_cast<float>(behind), colour});
}

void LinePass::draw(const gl::mat4& clip_from_eye, const gl::ivec2& picture, double nearest, double pixel) {
    if (lines_.empty()) return;
    gl::stream(buffer_, lines_.data(), lines_.size() * sizeof(Line));
    program_.use();
    program_.set("clip_from_eye", clip_from_eye);
    program_.set("picture", gl::vec2(picture));
    program_.set("nearest", static_cast<float>(nearest));
    program_.set("lift", lift);
    program_.set("pixel", static_cast<float>(pixel));
    glBindVertexArray(array_.id());
    glEnable(GL_BLEND);
    glEnable(GL_DEPTH_TEST);
    glDepthMask(GL_FALSE);
    const auto count = static_cast<GLsizei>(lines_.size());
    if (std::any_of(lines_.begin(), lines_.end(), [](const Line& line) { return line.behind > 0; })) {
        program_.set("behind", 1.0F);
        glDepthFunc(GL_GREATER);
        glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, count);
    }
    program_.set("behind", 0.0F);
    glDepthFunc(GL_LEQUAL);
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, count);
    glDepthMask(GL_TRUE);
    glBindVertexArray(0);
}

}  // namespace surefoot::view
