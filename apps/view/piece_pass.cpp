#include "view/piece_pass.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <string>

#include "view/model.hpp"
#include "view/piece_shaders.hpp"
#include "view/shaders.hpp"
#include "view/shapes.hpp"

namespace surefoot::view {
namespace {

ShapeMesh unit_mesh(Solid solid, int around) {
    switch (solid) {
        case Solid::ball:
            return mesh_of(Sphere{1}, around);
        case Solid::drum:
            return mesh_of(Cylinder{1, 1}, around);
        case Solid::cube:
            return mesh_of(Box{{1, 1, 1}}, around);
        case Solid::cone:
            break;
    }
    // The library's cone stands on its tip: half a turn about X puts it right.
    ShapeMesh mesh = mesh_of(Cone{1, 1}, around);
    for (ShapeMesh::Vertex& v : mesh.vertices) {
        v.position = vec3(v.position.x, 1 - v.position.y, -v.position.z);
        v.normal = vec3(v.normal.x, -v.normal.y, -v.normal.z);
    }
    return mesh;
}

}  // namespace

double reach_of(const Piece& piece) {
    // No direction is stretched more than the three columns together.
    const dmat4x3& m = piece.place;
    const double squares = glm::dot(m[0], m[0]) + glm::dot(m[1], m[1]) + glm::dot(m[2], m[2]);
    const double farthest = piece.solid == Solid::ball ? 1 : piece.solid == Solid::cube ? 1.74 : 1.42;
    return std::sqrt(squares) * farthest;
}

PiecePass::PiecePass()
    : depth_("piece depth", shaders::piece_depth_vertex, shaders::depth_fragment), instances_(gl::Buffer::make()) {
    const std::string light = std::string(shaders::light) + std::string(shaders::piece_light);
    for (const int shadows : {0, 1})
        lit_[shadows] =
            gl::Program("piece", light + std::string(shaders::piece_vertex),
                        light + std::string(shaders::piece_fragment), shadows != 0 ? "#define SHADOWS\n" : "");
    for (std::size_t i = 0; i < meshes_.size(); ++i)
        meshes_[i] = make_mesh(static_cast<Solid>(i / detail_count), i % detail_count);
}

PiecePass::SolidMesh PiecePass::make_mesh(Solid solid, std::size_t detail) const {
    constexpr int corners[detail_count] = {28, 12, 8};
    const ShapeMesh shape = unit_mesh(solid, corners[detail]);
    SolidMesh mesh{gl::VertexArray::make(), gl::Buffer::make(), gl::Buffer::make(),
                   static_cast<GLsizei>(shape.indices.size())};
    glBindVertexArray(mesh.array.id());
    glBindBuffer(GL_ARRAY_BUFFER, mesh.vertices.id());
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(shape.vertices.size() * sizeof(ShapeMesh::Vertex)),
                 shape.vertices.data(), GL_STATIC_DRAW);
    glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(ShapeMesh::Vertex), nullptr);
    glVertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, sizeof(ShapeMesh::Vertex),
                          gl::offset(offsetof(ShapeMesh::Vertex, normal)));
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, mesh.indices.id());
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(shape.indices.size() * sizeof(shape.indices[0])),
                 shape.indices.data(), GL_STATIC_DRAW);
    glBindBuffer(GL_ARRAY_BUFFER, instances_.id());
    for (GLuint row = 0; row < 3; ++row)
        glVertexAttribPointer(2 + row, 4, GL_FLOAT, GL_FALSE, sizeof(Instance),
                              gl::offset(offsetof(Instance, rows) + row * sizeof(gl::vec4)));
    glVertexAttribPointer(5, 4, GL_UNSIGNED_BYTE, GL_TRUE, sizeof(Instance), gl::offset(offsetof(Instance, colour)));
    glVertexAttribPointer(6, 1, GL_FLOAT, GL_FALSE, sizeof(Instance), gl::offset(offsetof(Instance, glow)));
    for (GLuint attribute = 0; attribute < 7; ++attribute) {
        glEnableVertexAttribArray(attribute);
        if (attribute >= 2) glVertexAttribDivisor(attribute, 1);
    }
    glBindVertexArray(0);
    return mesh;
}

PiecePass::Instance PiecePass::instance_of(const Piece& piece, const dvec3& origin) {
    const dmat4x3& m = piece.place;
    const dvec3 at = m[3] - origin;
    Instance instance{{}, piece.colour, piece.glow};
    for (int row = 0; row < 3; ++row) instance.rows[row] = gl::vec4(m[0][row], m[1][row], m[2][row], at[row]);
    return instance;
}

void PiecePass::draw_run(std::size_t mesh, const std::vector<Instance>& run) {
    gl::stream(instances_, run.data(), run.size() * sizeof(Instance));
    glBindVertexArray(meshes_[mesh].array.id());
    glDrawElementsInstanced(GL_TRIANGLES, meshes_[mesh].index_count, GL_UNSIGNED_INT, nullptr,
                            static_cast<GLsizei>(run.size()));
}

std::size_t PiecePass::draw(const Lighting& light, const gl::mat4& clip_from_eye, const dvec3& eye, double pixel,
                            bool see_through, bool shadows) {
    const Frustum frustum(clip_from_eye);
    struct Seen {
        double away;
        std::size_t mesh;
        const Piece* piece;
    };
    std::vector<Seen> seen;
    for (const Piece& piece : pieces_) {
        if ((piece.colour.a < 255) != see_through || piece.colour.a == 0) continue;
        const dvec3 at = piece.place[3] - eye;
        const double reach = reach_of(piece);
        if (!frustum.may_see(vec3(at - reach), vec3(at + reach))) continue;
        const double away = glm::length(at);
        const double pixels = reach / (std::max(away - reach, 1e-3) * pixel);
        const std::size_t detail = pixels > 60 ? 0 : pixels > 12 ? 1 : 2;
        seen.push_back({away, static_cast<std::size_t>(piece.solid) * detail_count + detail, &piece});
    }
    if (seen.empty()) return 0;
    const gl::Program& program = lit_[shadows ? 1 : 0];
    program.use();
    light.set(program);
    program.set("clip_from_eye", clip_from_eye);
    glEnable(GL_CULL_FACE);
    glCullFace(GL_BACK);
    std::size_t triangles = 0;
    for (const Seen& s : seen) triangles += static_cast<std::size_t>(meshes_[s.mesh].index_count) / 3;
    if (see_through) {
        std::stable_sort(seen.begin(), seen.end(), [](const Seen& a, const Seen& b) { return a.away > b.away; });
        std::vector<Instance> run;
        for (std::size_t i = 0; i < seen.size(); ++i) {
            run.push_back(instance_of(*seen[i].piece, eye));
            if (i + 1 < seen.size() && seen[i + 1].mesh == seen[i].mesh) continue;
            draw_run(seen[i].mesh, run);
            run.clear();
        }
    } else {
        for (auto& list : sorted_) list.clear();
        for (const Seen& s : seen) sorted_[s.mesh].push_back(instance_of(*s.piece, eye));
        for (std::size_t mesh = 0; mesh < sorted_.size(); ++mesh)
            if (!sorted_[mesh].empty()) draw_run(mesh, sorted_[mesh]);
    }
    glDisable(GL_CULL_FACE);
    glBindVertexArray(0);
    return triangles;
}

void PiecePass::draw_depth(const gl::mat4& clip_from_middle, const dvec3& middle) {
    for (auto& list : sorted_) list.clear();
    for (const Piece& piece : pieces_)
        if (piece.casts_shadow && piece.colour.a == 255)
            sorted_[static_cast<std::size_t>(piece.solid) * detail_count + 1].push_back(instance_of(piece, middle));
    depth_.use();
    depth_.set("clip_from_middle", clip_from_middle);
    for (std::size_t mesh = 0; mesh < sorted_.size(); ++mesh)
        if (!sorted_[mesh].empty()) draw_run(mesh, sorted_[mesh]);
    glBindVertexArray(0);
}

}  // namespace surefoot::view
