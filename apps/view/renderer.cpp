// Collecting a frame.
#include "view/renderer.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "view/door_shader.hpp"
#include "view/mesh_shaders.hpp"
#include "view/pattern.hpp"
#include "view/renderer_parts.hpp"
#include "view/shaders.hpp"

namespace surefoot::view {
namespace {

dmat4 matrix_of(const dquat& q) {
    const double n = q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z;
    const double s = n > 0 ? 2 / n : 0;
    return {1 - s * (q.y * q.y + q.z * q.z),
            s * (q.x * q.y + q.w * q.z),
            s * (q.x * q.z - q.w * q.y),
            0,
            s * (q.x * q.y - q.w * q.z),
            1 - s * (q.x * q.x + q.z * q.z),
            s * (q.y * q.z + q.w * q.x),
            0,
            s * (q.x * q.z + q.w * q.y),
            s * (q.y * q.z - q.w * q.x),
            1 - s * (q.x * q.x + q.y * q.y),
            0,
            0,
            0,
            0,
            1};
}

gl::mat4 placed(dmat4 turn, const dvec3& at) {
    turn[3] = glm::dvec4(at, 1);
    return gl::mat4(turn);
}

std::string with_light(std::string_view source) {
    return std::string(shaders::light) + std::string(source);
}

std::string with_mesh_light(std::string_view source) {
    return with_light(shaders::mesh_light) + std::string(source);
}

}  // namespace

dvec3 Renderer::PlacedModel::origin() const {
    return pose.position + dvec3(turn * glm::dvec4(model->origin(), 0));
}

gl::vec3 Renderer::PlacedModel::in_model(const dvec3& place) const {
    return gl::vec3(glm::transpose(turn) * glm::dvec4(place - origin(), 0));
}

gl::mat4 Renderer::PlacedModel::from_model(const dvec3& eye) const {
    return placed(turn, origin() - eye);
}

gl::mat4 Renderer::PlacedShape::from_model(const dvec3& eye) const {
    return placed(turn, position - eye);
}

Renderer::Parts::Parts()
    : shape("shape", shaders::shape_vertex, with_light(shaders::shape_fragment)),
      depth("depth", shaders::depth_vertex, shaders::depth_fragment),
      flat("flat", shaders::flat_vertex, shaders::flat_fragment),
      sky("sky", shaders::sky_vertex, shaders::sky_fragment),
      smooth("smooth", shaders::screen_vertex, shaders::smooth_fragment),
      nothing(gl::VertexArray::make()),
      flat_array(gl::VertexArray::make()),
      flat_buffer(gl::Buffer::make()),
      patterns(pattern_texture()) {
    for (const int shadows : {0, 1}) {
        const std::string define = shadows != 0 ? "#define SHADOWS\n" : "";
        const std::string whole = shadows != 0 ? "#define FLAT\n" : "#define FLAT\n#define LIT_WHOLE\n";
        const std::string looks[] = {"", whole, "#define EDGES\n", whole + "#define PATTERNS\n"};
        for (int look = 0; look < 4; ++look)
            mesh[shadows][look] = gl::Program("mesh", with_mesh_light(shaders::mesh_vertex),
                                              with_mesh_light(shaders::mesh_fragment), define + looks[look]);
        for (const bool drawn : {false, true})
            door[shadows][drawn ? 1 : 0] =
                gl::Program("mesh with holes", with_mesh_light(shaders::mesh_vertex),
                            with_mesh_light(std::string(shaders::door) + std::string(shaders::mesh_fragment)),
                            define + looks[drawn ? 3 : 1] + "#define DOOR\n");
    }
    glBindVertexArray(flat_array.id());
    glBindBuffer(GL_ARRAY_BUFFER, flat_buffer.id());
    glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(FlatVertex), nullptr);
    glVertexAttribPointer(1, 4, GL_UNSIGNED_BYTE, GL_TRUE, sizeof(FlatVertex),
                          gl::offset(offsetof(FlatVertex, colour)));
    glEnableVertexAttribArray(0);
    glEnableVertexAttribArray(1);
    glBindVertexArray(0);
}

Renderer::Renderer() : parts_(std::make_unique<Parts>()) {}
Renderer::~Renderer() = default;

void Renderer::begin(const FrameView& view) {
    view_ = view;
    labels_.clear();
    counts_ = {};
    door_ = {};
    parts_->models.clear();
    parts_->placed.clear();
    parts_->triangles.clear();
    parts_->lines.clear();
    parts_->pieces.clear();
    parts_->discs.clear();
    parts_->shapes.next_frame();
}

void Renderer::model(const std::shared_ptr<const Model>& model, const ModelLook& look, const Pose& pose) {
    parts_->models.push_back({model, look, pose, matrix_of(pose.orientation)});
}

void Renderer::shape(const Volume& volume, const dvec3& position, const ShapeLook& look) {
    PlacedShape shape{parts_->shapes.get(volume.shape), position, matrix_of(volume.orientation), look, {}, 0};
    shape.middle = position + dvec3(shape.turn * glm::dvec4(middle_of(volume.shape), 0));
    shape.reach = reach_of(volume.shape);
    if (look.outline > 0) outline(shape);
    parts_->placed.push_back(std::move(shape));
}

// A body that curves outwards everywhere has as its outline the edges between faces that are seen and faces that are
// not, and these form the border of what is drawn, to the pixel.
void Renderer::outline(const PlacedShape& shape) {
    const dmat4 back = glm::transpose(shape.turn);
    const vec3 eye(back * glm::dvec4(view_.camera.eye - shape.position, 0));
    const gl::mat4 to_eye = shape.from_model(view_.camera.eye);
    const double width = shape.look.outline * view_.line_pixels();
    const Colour line = mixed(with_opacity(shape.look.colour, 1), paint::ink, 0.25);
    for (const ShapeMesh::Edge& edge : shape.model->mesh.edges) {
        const vec3 look = edge.from - eye;
        const bool first = glm::dot(edge.normals[0], look) < 0;
        const bool second = glm::dot(edge.normals[1], look) < 0;
        const bool border = first != second;
        if (!border && !(edge.crease && (first || second))) continue;
        const vec3 from(to_eye * gl::vec4(edge.from, 1));
        const vec3 to(to_eye * gl::vec4(edge.to, 1));
        const double share = border ? 1 : 0.55;
        parts_->lines.add(from, to, width * share, width * share, with_opacity(line, border ? 1 : 0.6),
                          border ? shape.look.behind : 0);
    }
}

void Renderer::piece(const Piece& piece) {
    parts_->pieces.add(piece);
}

void Renderer::disc(const Disc& disc) {
    parts_->discs.add(disc);
}

void Renderer::line(const dvec3& from, const dvec3& to, const Stroke& stroke) {
    const double width = stroke.width * view_.line_pixels();
    parts_->lines.add(seen(from), seen(to), width, width, stroke.colour, stroke.behind);
}

void Renderer::polyline(std::span<const dvec3> points, const Stroke& stroke, bool closed) {
    for (std::size_t i = 1; i < points.size(); ++i) line(points[i - 1], points[i], stroke);
    if (closed && points.size() > 2) line(points.back(), points.front(), stroke);
}

void Renderer::point(const dvec3& place, double size, Colour colour, double behind) {
    const double width = size * view_.line_pixels();
    parts_->lines.add(seen(place), seen(place), width, width, colour, behind);
}

void Renderer::arrow(const dvec3& from, const dvec3& to, const Stroke& stroke, double head) {
    const double length = glm::length(to - from);
    const auto at = view_.camera.project(to, view_.size);
    if (!(length > 0)) return;
    const double depth = at ? at->depth : view_.camera.nearest;
    const double share = std::min(head * view_.scale * view_.camera.unit_at(depth, view_.size) / length, 0.5);
    const dvec3 neck = to + (from - to) * share;
    const double unit = view_.line_pixels();
    parts_->lines.add(seen(from), seen(neck), stroke.width * unit, stroke.width * unit, stroke.colour, stroke.behind);
    const double base = std::max(head * 0.62, stroke.width * 2.2) * unit;
    parts_->lines.add(seen(neck), seen(to), base, 0.5, stroke.colour, stroke.behind);
}

void Renderer::box(const Bounds& b, const Stroke& stroke) {
    const auto corner = [&](int i) {
        return dvec3((i & 1) != 0 ? b.max.x : b.min.x, (i & 2) != 0 ? b.max.y : b.min.y,
                     (i & 4) != 0 ? b.max.z : b.min.z);
    };
    for (int i = 0; i < 8; ++i)
        for (const int axis : {1, 2, 4})
            if ((i & axis) == 0) line(corner(i), corner(i | axis), stroke);
}

void Renderer::circle(const dvec3& middle, const dvec3& axis, double radius, const Stroke& stroke) {
    constexpr int corners = 64;
    const auto [first, second] = across(glm::normalize(axis));
    std::vector<dvec3> points;
    for (int i = 0; i < corners; ++i) {
        const double angle = 2 * std::numbers::pi * i / corners;
        points.push_back(middle + radius * (std::cos(angle) * first + std::sin(angle) * second));
    }
    polyline(points, stroke, true);
}

void Renderer::label(const Label& label) {
    labels_.push_back(label);
}

void Renderer::triangle(const dvec3& a, const dvec3& b, const dvec3& c, const DebugColour& colour) {
    for (const dvec3& corner : {a, b, c}) parts_->triangles.push_back({seen(corner), colour});
}

}  // namespace surefoot::view
