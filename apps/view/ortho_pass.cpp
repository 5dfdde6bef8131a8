#include "view/ortho_pass.hpp"

#include <cstddef>

namespace surefoot::view {
namespace {

constexpr std::string_view vertex = R"(
layout(location = 0) in vec4 place;   // middle and half size [pixels]
layout(location = 1) in vec4 turn_and_widths;
layout(location = 2) in vec4 shape_a;
layout(location = 3) in vec4 shape_b;
layout(location = 4) in vec4 shape_clip;
layout(location = 5) in vec4 shape_top;
layout(location = 6) in vec4 shape_bottom;
layout(location = 7) in vec4 shape_edge;
uniform vec2 window;
out vec2 local;
out vec2 page;
flat out vec4 a;
flat out vec4 b;
flat out vec4 clip;
flat out vec4 top;
flat out vec4 bottom;
flat out vec4 edge;
flat out vec2 half_size;
flat out vec2 widths;
flat out mat3 sides;  // of a triangle: outward normal, and minus how far it is

vec3 side(vec2 from, vec2 to, vec2 opposite) {
    vec2 along = to - from;
    vec2 normal = vec2(along.y, -along.x) / max(length(along), 1e-6);
    if (dot(normal, opposite - from) > 0.0) normal = -normal;
    return vec3(normal, -dot(normal, from));
}
void main() {
    vec2 corner = vec2(float(gl_VertexID & 1), float(gl_VertexID >> 1)) * 2.0 - 1.0;
    // Room for what is outside of the outline; the field of a glyph has its own.
    float around = shape_b.w == 3.0 ? 0.0 : turn_and_widths.z + turn_and_widths.w * 0.5 + 1.0;
    local = corner * (place.zw + around);
    vec2 turn = turn_and_widths.xy;
    page = place.xy + vec2(local.x * turn.x - local.y * turn.y, local.x * turn.y + local.y * turn.x);
    vec2 clip_place = page / window * 2.0 - 1.0;
    gl_Position = vec4(clip_place.x, -clip_place.y, 0.0, 1.0);
    a = shape_a;
    b = shape_b;
    clip = shape_clip;
    top = shape_top;
    bottom = shape_bottom;
    edge = shape_edge;
    half_size = place.zw;
    widths = turn_and_widths.zw;
    sides = mat3(side(a.xy, a.zw, b.xy), side(a.zw, b.xy, a.xy), side(b.xy, a.xy, a.zw));
}
)";

// Distances to outlines after the well-known closed forms: a box with round corners is the box of the corners' middles,
// grown; of an arc one end or the ring is nearer; of a triangle the farthest of its sides' lines, which is right inside
// and mitres the outline: software renderers compute all of this for every pixel, so it has to be little.
constexpr std::string_view fragment = R"(
in vec2 local;
in vec2 page;
flat in vec4 a;
flat in vec4 b;
flat in vec4 clip;
flat in vec4 top;
flat in vec4 bottom;
flat in vec4 edge;
flat in vec2 half_size;
flat in vec2 widths;
flat in mat3 sides;
uniform sampler2D letters;
uniform sampler2D picture;
out vec4 colour;

float box(vec2 p, vec2 size, float radius) {
    vec2 q = abs(p) - size + radius;
    return length(max(q, 0.0)) + min(max(q.x, q.y), 0.0) - radius;
}
float arc(vec2 p) {
    p = vec2(abs(p.x), -p.y);
    bool is_at_end = p.x * a.w > p.y * a.z;
    return (is_at_end ? length(p - a.zw * a.x) : abs(length(p) - a.x)) - a.y;
}
void main() {
    if (any(lessThan(page, clip.xy)) || any(greaterThan(page, clip.zw))) discard;
    vec4 fill = mix(top, bottom, clamp(local.y / half_size.y * 0.5 + 0.5, 0.0, 1.0));
    vec3 at3 = vec3(local, 1.0);
    float d;
    if (b.w == 3.0) {
        vec2 at = local / half_size * 0.5 + 0.5;
        d = (128.0 / 255.0 - texture(letters, mix(a.xy, a.zw, at)).r) * b.x;
    } else if (b.w == 1.0) {
        d = arc(local - b.xy);
    } else if (b.w == 2.0) {
        d = max(max(dot(sides[0], at3), dot(sides[1], at3)), dot(sides[2], at3)) - b.z;
    } else {
        d = box(local, half_size, b.z);
        if (b.w == 4.0) {
            vec2 at = local / half_size * a.zw;
            fill *= texture(picture, a.xy + vec2(at.x * b.x - at.y * b.y, at.x * b.y + at.y * b.x));
        }
    }
    float within = clamp(0.5 - d / widths.y, 0.0, 1.0);
    float around = clamp(0.5 - (d - widths.x) / widths.y, 0.0, 1.0);
    float edge_share = edge.a * (around - within);
    float opacity = fill.a * within + edge_share;
    if (opacity <= 0.0) discard;
    colour = vec4((fill.rgb * fill.a * within + edge.rgb * edge_share) / opacity, opacity);
}
)";

void attribute(GLuint index, GLint count, GLenum type, std::size_t offset) {
    glVertexAttribPointer(index, count, type, type == GL_UNSIGNED_BYTE ? GL_TRUE : GL_FALSE, sizeof(CanvasItem),
                          gl::offset(offset));
    glEnableVertexAttribArray(index);
    glVertexAttribDivisor(index, 1);
}

gl::Texture texture_of(GLint kind, GLenum format, const ivec2& size, const void* texels) {
    gl::Texture made = gl::Texture::make();
    glBindTexture(GL_TEXTURE_2D, made.id());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage2D(GL_TEXTURE_2D, 0, kind, size.x, size.y, 0, format, GL_UNSIGNED_BYTE, texels);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    return made;
}

}  // namespace

OrthoPass::OrthoPass()
    : program_("flat picture", vertex, fragment),
      array_(gl::VertexArray::make()),
      buffer_(gl::Buffer::make()),
      letters_(texture_of(GL_R8, GL_RED, {Letters::side, Letters::side}, nullptr)) {
    static_assert(sizeof(CanvasItem) == 92 && offsetof(CanvasItem, half) == 8);
    const Colour nothing{0, 0, 0, 0};
    picture_ = texture_of(GL_RGBA8, GL_RGBA, {1, 1}, &nothing);
    glBindVertexArray(array_.id());
    glBindBuffer(GL_ARRAY_BUFFER, buffer_.id());
    attribute(0, 4, GL_FLOAT, offsetof(CanvasItem, middle));
    attribute(1, 4, GL_FLOAT, offsetof(CanvasItem, turn_and_widths));
    attribute(2, 4, GL_FLOAT, offsetof(CanvasItem, a));
    attribute(3, 4, GL_FLOAT, offsetof(CanvasItem, b));
    attribute(4, 4, GL_FLOAT, offsetof(CanvasItem, clip));
    attribute(5, 4, GL_UNSIGNED_BYTE, offsetof(CanvasItem, top));
    attribute(6, 4, GL_UNSIGNED_BYTE, offsetof(CanvasItem, bottom));
    attribute(7, 4, GL_UNSIGNED_BYTE, offsetof(CanvasItem, edge));
    glBindVertexArray(0);
}

void OrthoPass::set_picture(const Picture& picture) {
    picture_ = texture_of(GL_RGBA8, GL_RGBA, picture.size, picture.pixels.data());
}

void OrthoPass::draw(const Canvas& canvas, unsigned framebuffer) {
    if (canvas.items().empty()) return;
    const Letters& letters = canvas.letters();
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, letters_.id());
    if (held_ != &letters || version_ != letters.version()) {
        glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
        glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, Letters::side, letters.rows(), GL_RED, GL_UNSIGNED_BYTE,
                        letters.texels().data());
        held_ = &letters;
        version_ = letters.version();
    }
    glActiveTexture(GL_TEXTURE1);
    glBindTexture(GL_TEXTURE_2D, picture_.id());
    glActiveTexture(GL_TEXTURE0);
    gl::stream(buffer_, canvas.items().data(), canvas.items().size() * sizeof(CanvasItem));
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    const ivec2 size = canvas.layout().framebuffer;
    glViewport(0, 0, size.x, size.y);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    glDisable(GL_SCISSOR_TEST);
    glEnable(GL_BLEND);
    glBlendEquation(GL_FUNC_ADD);
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    program_.use();
    program_.set("window", gl::vec2(size));
    program_.set("letters", 0);
    program_.set("picture", 1);
    glBindVertexArray(array_.id());
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(canvas.items().size()));
    glBindVertexArray(0);
    glDisable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
}

}  // namespace surefoot::view
