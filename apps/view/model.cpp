#include "view/model.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>

#include "view/normals.hpp"

namespace surefoot::view {
namespace {

constexpr std::size_t chunk_size = 1024;

dvec3 middle(const Triangle& t) {
    return (t.a + t.b + t.c) / 3.0;
}

/// Every third bit of 30: one axis of a curve that fills space.
std::uint32_t spread(double share) {
    auto x = static_cast<std::uint32_t>(std::clamp(share, 0.0, 1.0) * 1023);
    x = (x | x << 16) & 0x030000FF;
    x = (x | x << 8) & 0x0300F00F;
    x = (x | x << 4) & 0x030C30C3;
    return (x | x << 2) & 0x09249249;
}

std::uint32_t edges_of(const SourceTriangle& t) {
    return static_cast<std::uint32_t>(t.edges[0]) | static_cast<std::uint32_t>(t.edges[1]) << 2U |
           static_cast<std::uint32_t>(t.edges[2]) << 4U;
}

std::int8_t small(float x) {
    return static_cast<std::int8_t>(std::lround(std::clamp(x, -1.0F, 1.0F) * 127));
}

template <typename T>
void fill(GLenum target, const gl::Buffer& buffer, const std::vector<T>& values) {
    glBindBuffer(target, buffer.id());
    glBufferData(target, static_cast<GLsizeiptr>(values.size() * sizeof(T)), values.data(), GL_STATIC_DRAW);
}

}  // namespace

Frustum::Frustum(const gl::mat4& m) {
    const auto row = [&](int i) { return gl::vec4(m[0][i], m[1][i], m[2][i], m[3][i]); };
    for (int axis = 0; axis < 3; ++axis) {
        planes_[static_cast<std::size_t>(2 * axis)] = row(3) + row(axis);
        planes_[static_cast<std::size_t>(2 * axis + 1)] = row(3) - row(axis);
    }
}

bool Frustum::may_see(const gl::vec3& low, const gl::vec3& high) const {
    return std::all_of(planes_.begin(), planes_.end(), [&](const gl::vec4& p) {
        const gl::vec3 best(p.x > 0 ? high.x : low.x, p.y > 0 ? high.y : low.y, p.z > 0 ? high.z : low.z);
        return p.x * best.x + p.y * best.y + p.z * best.z + p.w >= 0;
    });
}

bool SightLine::touches(const gl::vec3& low, const gl::vec3& high) const {
    const gl::vec3 gap = eye - glm::clamp(eye, low, high);
    if (glm::dot(gap, gap) < nearest * nearest) return true;
    if (!(radius > 0)) return false;
    // The line against the box and some room around it, slab by slab.
    const gl::vec3 way = goal - eye;
    float enter = 0;
    float leave = 1;
    for (int axis = 0; axis < 3; ++axis) {
        const float least = low[axis] - radius - eye[axis];
        const float most = high[axis] + radius - eye[axis];
        if (std::abs(way[axis]) < 1e-6F) {
            if (least > 0 || most < 0) return false;
            continue;
        }
        const float a = least / way[axis];
        const float b = most / way[axis];
        enter = std::max(enter, std::min(a, b));
        leave = std::min(leave, std::max(a, b));
    }
    return enter <= leave;
}

std::shared_ptr<Model> Model::make(const Mesh& mesh, const TriangleFinish& finish, Shading shading) {
    static std::atomic<std::uint64_t> made{0};
    std::shared_ptr<Model> model(new Model);
    model->serial_ = ++made;
    model->bounds_ = mesh.bounds();
    model->origin_ = (model->bounds_.min + model->bounds_.max) * 0.5;
    std::vector<SourceTriangle>& all = model->triangles_;
    all.resize(mesh.triangle_count());
    all.resize(mesh.gather(model->bounds_, all));
    const dvec3 extent = glm::max(model->bounds_.max - model->bounds_.min, dvec3(1e-9));
    std::vector<std::pair<std::uint32_t, std::uint32_t>> order(all.size());
    for (std::uint32_t i = 0; i < order.size(); ++i) {
        const dvec3 share = (middle(all[i].triangle) - model->bounds_.min) / extent;
        order[i] = {spread(share.x) | spread(share.y) << 1U | spread(share.z) << 2U, i};
    }
    std::sort(order.begin(), order.end());
    std::vector<SourceTriangle> sorted(all.size());
    for (std::size_t i = 0; i < order.size(); ++i) sorted[i] = all[order[i].second];
    all = std::move(sorted);
    model->cut_into_chunks();
    model->shading_ = shading;
    for (const gl::vec3& n : corner_normals(all, shading == Shading::smooth ? 35.0 : 0.0))
        model->normals_.push_back({small(n.x), small(n.y), small(n.z), 0});
    model->upload();
    model->recolour(finish);
    return model;
}

void Model::cut_into_chunks() {
    for (std::size_t first = 0; first < triangles_.size(); first += chunk_size) {
        const std::size_t end = std::min(first + chunk_size, triangles_.size());
        Chunk chunk{static_cast<int>(first), static_cast<int>(end - first), gl::vec3(3e38F), gl::vec3(-3e38F)};
        for (std::size_t i = first; i < end; ++i) {
            for (const dvec3& corner : {triangles_[i].triangle.a, triangles_[i].triangle.b, triangles_[i].triangle.c}) {
                chunk.low = glm::min(chunk.low, gl::vec3(corner - origin_));
                chunk.high = glm::max(chunk.high, gl::vec3(corner - origin_));
            }
        }
        chunks_.push_back(chunk);
    }
}

void Model::upload() {
    struct Vertex {
        gl::vec3 position;
        SmallNormal normal;
        std::uint32_t info;
    };
    static_assert(sizeof(Vertex) == 20);
    std::vector<Vertex> vertices;
    vertices.reserve(3 * triangles_.size());
    for (const SourceTriangle& t : triangles_)
        for (const dvec3& corner : {t.triangle.a, t.triangle.b, t.triangle.c})
            vertices.push_back({gl::vec3(corner - origin_), normals_[vertices.size()], edges_of(t)});
    array_ = gl::VertexArray::make();
    vertices_ = gl::Buffer::make();
    colours_ = gl::Buffer::make();
    glBindVertexArray(array_.id());
    fill(GL_ARRAY_BUFFER, vertices_, vertices);
    glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(Vertex), gl::offset(offsetof(Vertex, position)));
    glVertexAttribPointer(1, 3, GL_BYTE, GL_TRUE, sizeof(Vertex), gl::offset(offsetof(Vertex, normal)));
    glVertexAttribIPointer(3, 1, GL_UNSIGNED_INT, sizeof(Vertex), gl::offset(offsetof(Vertex, info)));
    glBindBuffer(GL_ARRAY_BUFFER, colours_.id());
    glVertexAttribPointer(2, 4, GL_UNSIGNED_BYTE, GL_TRUE, 0, nullptr);
    for (const GLuint attribute : {0U, 1U, 2U, 3U}) glEnableVertexAttribArray(attribute);
    glBindVertexArray(0);
}

void Model::upload_shared(const std::vector<Finish>& finishes, const std::vector<Colour>& colours) {
    using Vertex = SharedCorners::Vertex;
    SharedCorners shared(is_flat());
    for (const Chunk& chunk : chunks_) {
        shared.begin_chunk();
        for (int k = 0; k < chunk.count; ++k) {
            const auto i = static_cast<std::size_t>(chunk.first + k);
            const Triangle& t = triangles_[i].triangle;
            const auto corner = [&](const dvec3& place, std::size_t k_th) {
                SmallNormal normal = normals_[3 * i + k_th];
                normal.pattern = is_flat() ? static_cast<std::int8_t>(finishes[i].pattern) : std::int8_t{0};
                return SharedCorners::Corner{gl::vec3(place - origin_), normal};
            };
            shared.add({{{corner(t.a, 0), corner(t.b, 1), corner(t.c, 2)}}, colours[i]});
        }
    }
    shared_array_ = gl::VertexArray::make();
    shared_vertices_ = gl::Buffer::make();
    shared_indices_ = gl::Buffer::make();
    glBindVertexArray(shared_array_.id());
    fill(GL_ARRAY_BUFFER, shared_vertices_, shared.vertices());
    fill(GL_ELEMENT_ARRAY_BUFFER, shared_indices_, shared.indices());
    glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(Vertex), gl::offset(offsetof(Vertex, position)));
    glVertexAttribPointer(1, 3, GL_BYTE, GL_TRUE, sizeof(Vertex), gl::offset(offsetof(Vertex, normal)));
    glVertexAttribPointer(2, 4, GL_UNSIGNED_BYTE, GL_TRUE, sizeof(Vertex), gl::offset(offsetof(Vertex, colour)));
    glVertexAttribIPointer(4, 1, GL_BYTE, sizeof(Vertex),
                           gl::offset(offsetof(Vertex, normal) + offsetof(SmallNormal, pattern)));
    for (const GLuint attribute : {0U, 1U, 2U, 4U}) glEnableVertexAttribArray(attribute);
    glBindVertexArray(0);
}

void Model::recolour(const TriangleFinish& finish) {
    std::vector<Finish> finishes;
    std::vector<Colour> colours;  // with the glow where an opacity would be
    finishes.reserve(triangles_.size());
    colours.reserve(triangles_.size());
    has_patterns_ = false;
    for (const SourceTriangle& t : triangles_) {
        finishes.push_back(finish ? finish(t) : Finish(colour_of_surface(t.surface, {})));
        colours.push_back(with_opacity(finishes.back().colour, finishes.back().glow));
        has_patterns_ = has_patterns_ || finishes.back().pattern != Pattern::none;
    }
    upload_shared(finishes, colours);
    std::vector<Colour> thrice;
    thrice.reserve(3 * colours.size());
    for (const Colour& c : colours) thrice.insert(thrice.end(), 3, c);
    fill(GL_ARRAY_BUFFER, colours_, thrice);
}

std::size_t Model::draw(const Frustum& seen, const gl::vec3& eye, bool with_edges) const {
    return draw_chunks(seen, eye, with_edges, [](const Chunk&) { return true; });
}

std::size_t Model::draw_parted(const Frustum& seen, const SightLine& line, bool touching) const {
    return draw_chunks(seen, line.eye, false,
                       [&](const Chunk& chunk) { return line.touches(chunk.low, chunk.high) == touching; });
}

template <typename Wanted>
std::size_t Model::draw_chunks(const Frustum& seen, const gl::vec3& eye, bool with_edges,
                               const Wanted& is_wanted) const {
    std::vector<std::pair<float, const Chunk*>> order;  // by how far away they are
    for (const Chunk& chunk : chunks_) {
        if (!seen.may_see(chunk.low, chunk.high) || !is_wanted(chunk)) continue;
        const gl::vec3 gap = eye - glm::clamp(eye, chunk.low, chunk.high);
        order.emplace_back(glm::dot(gap, gap), &chunk);
    }
    std::sort(order.begin(), order.end());
    std::size_t drawn = 0;
    glBindVertexArray(with_edges ? array_.id() : shared_array_.id());
    for (const auto& [square, chunk] : order) {
        if (with_edges) {
            glDrawArrays(GL_TRIANGLES, 3 * chunk->first, 3 * chunk->count);
        } else {
            glDrawElements(GL_TRIANGLES, 3 * chunk->count, GL_UNSIGNED_INT,
                           gl::offset(3 * sizeof(std::uint32_t) * static_cast<std::size_t>(chunk->first)));
        }
        drawn += static_cast<std::size_t>(chunk->count);
    }
    glBindVertexArray(0);
    return drawn;
}

}  // namespace surefoot::view
