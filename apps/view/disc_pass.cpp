#include "view/disc_pass.hpp"

#include <algorithm>
#include <cstddef>

#include "view/camera.hpp"

namespace surefoot::view {
namespace {

// How much nearer to the eye it counts as than it is, so that it lies on what it lies on.
constexpr float lift = 0.004F;

constexpr std::string_view disc_vertex = R"(
layout(location = 0) in vec3 place;
layout(location = 1) in vec3 side;
layout(location = 2) in vec3 other;
layout(location = 3) in vec4 colour;
layout(location = 4) in float core;
uniform mat4 clip_from_eye;
uniform float lift;
out vec2 v_at;
flat out vec4 v_colour;
flat out float v_core;
void main() {
    v_at = vec2((gl_VertexID & 1) == 0 ? -1.0 : 1.0, gl_VertexID > 1 ? 1.0 : -1.0);
    v_colour = colour;
    v_core = core;
    vec3 corner = place + side * v_at.x + other * v_at.y;
    gl_Position = clip_from_eye * vec4(corner, 1.0);
    if (gl_Position.w > 0.1) {
        vec4 nearer = clip_from_eye * vec4(corner * (1.0 - lift), 1.0);
        gl_Position.z = nearer.z / max(nearer.w, 1e-6) * gl_Position.w;
    }
}
)";

constexpr std::string_view disc_fragment = R"(
in vec2 v_at;
flat in vec4 v_colour;
flat in float v_core;
out vec4 result;
void main() {
    float share = clamp((1.0 - length(v_at)) / (1.0 - v_core), 0.0, 1.0);
    result = v_colour * (share * share * (3.0 - 2.0 * share));
}
)";

}  // namespace

DiscPass::DiscPass()
    : program_("disc", disc_vertex, disc_fragment), array_(gl::VertexArray::make()), buffer_(gl::Buffer::make()) {
    glBindVertexArray(array_.id());
    glBindBuffer(GL_ARRAY_BUFFER, buffer_.id());
    glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(Instance), gl::offset(offsetof(Instance, place)));
    glVertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, sizeof(Instance), gl::offset(offsetof(Instance, side)));
    glVertexAttribPointer(2, 3, GL_FLOAT, GL_FALSE, sizeof(Instance), gl::offset(offsetof(Instance, other)));
    glVertexAttribPointer(3, 4, GL_FLOAT, GL_FALSE, sizeof(Instance), gl::offset(offsetof(Instance, colour)));
    glVertexAttribPointer(4, 1, GL_FLOAT, GL_FALSE, sizeof(Instance), gl::offset(offsetof(Instance, core)));
    for (GLuint attribute = 0; attribute < 5; ++attribute) {
        glEnableVertexAttribArray(attribute);
        glVertexAttribDivisor(attribute, 1);
    }
    glBindVertexArray(0);
}

void DiscPass::draw(const gl::mat4& clip_from_eye, const dvec3& eye, const dvec3& right, const dvec3& above) {
    if (discs_.empty()) return;
    instances_.clear();
    for (const Disc& disc : discs_) {
        const bool lies = disc.normal != dvec3(0);
        const Across on_it = lies ? across(disc.normal) : Across{right, above};
        const gl::vec4 colour = to_vec4(disc.colour);
        instances_.push_back({gl::vec3(disc.place - eye), gl::vec3(on_it.first * disc.radius),
                              gl::vec3(on_it.second * disc.radius),
                              gl::vec4(gl::vec3(colour) * colour.a, disc.is_light ? 0.0F : colour.a),
                              static_cast<float>(std::clamp(disc.core, 0.0, 0.99))});
    }
    gl::stream(buffer_, instances_.data(), instances_.size() * sizeof(Instance));
    program_.use();
    program_.set("clip_from_eye", clip_from_eye);
    program_.set("lift", lift);
    glBindVertexArray(array_.id());
    glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(instances_.size()));
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glBindVertexArray(0);
}

}  // namespace surefoot::view
