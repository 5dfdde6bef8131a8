/// A mesh on the graphics card, in chunks that are skipped when they are out of sight.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include <surefoot/bounds.hpp>
#include <surefoot/mesh.hpp>
#include <surefoot/query.hpp>

#include "view/colour.hpp"
#include "view/finish.hpp"
#include "view/gl.hpp"
#include "view/shared_corners.hpp"

namespace surefoot::view {

enum class Shading : std::uint8_t {
    flat,    ///< every triangle as it is
    smooth,  ///< rounded where triangles bend by less than 35 degrees
};

using TriangleFinish = std::function<Finish(const SourceTriangle&)>;

/// Which part of space is drawn: the planes of a projection.
class Frustum {
public:
    explicit Frustum(const gl::mat4& clip_from_local);
    [[nodiscard]] bool may_see(const gl::vec3& low, const gl::vec3& high) const;

private:
    std::array<gl::vec4, 6> planes_;
};

/// Along a line of sight and around its beginning: where models may be drawn otherwise. In a model's own places.
struct SightLine {
    gl::vec3 eye{0, 0, 0};
    gl::vec3 goal{0, 0, 0};
    float radius = 0;   ///< around the line
    float nearest = 0;  ///< around the eye

    [[nodiscard]] bool touches(const gl::vec3& low, const gl::vec3& high) const;
};

class Model {
public:
    /// Reads the mesh once; hidden triangles are left out. Where no finish is given, surfaces have colours by number.
    [[nodiscard]] static std::shared_ptr<Model> make(const Mesh& mesh, const TriangleFinish& finish = {},
                                                     Shading shading = Shading::flat);

    /// Colours all triangles anew.
    void recolour(const TriangleFinish& finish);

    [[nodiscard]] const Bounds& bounds() const { return bounds_; }

    /// What vertices are relative to, in the mesh's own frame.
    [[nodiscard]] const dvec3& origin() const { return origin_; }
    [[nodiscard]] std::size_t triangle_count() const { return triangles_.size(); }

    /// Another number for every model that was ever made.
    [[nodiscard]] std::uint64_t serial() const { return serial_; }

    /// Is every triangle lit as it is? Then programs take the normal of a triangle's last corner for all of it.
    [[nodiscard]] bool is_flat() const { return shading_ == Shading::flat; }

    /// Has any triangle a pattern? Only flat ones show it, where no lines are drawn on edges.
    [[nodiscard]] bool has_patterns() const { return has_patterns_; }

    /// Draws the chunks that `seen` may see with the program in use, those nearest to `eye` first, so that what they
    /// hide need not be shaded; returns how many triangles that were. `with_edges` hands out three corners a triangle,
    /// which know their place in it; otherwise corners are shared.
    std::size_t draw(const Frustum& seen, const gl::vec3& eye, bool with_edges) const;

    /// The same, but only those chunks that touch a line of sight, or only those that do not.
    std::size_t draw_parted(const Frustum& seen, const SightLine& line, bool touching) const;

private:
    struct Chunk {
        int first = 0;  // triangle
        int count = 0;
        gl::vec3 low{0, 0, 0};
        gl::vec3 high{0, 0, 0};
    };

    Model() = default;
    template <typename Wanted>
    std::size_t draw_chunks(const Frustum& seen, const gl::vec3& eye, bool with_edges, const Wanted& is_wanted) const;
    void cut_into_chunks();
    void upload();
    void upload_shared(const std::vector<Finish>& finishes, const std::vector<Colour>& colours);

    std::vector<SourceTriangle> triangles_;  // in the order of drawing
    std::vector<Chunk> chunks_;
    Bounds bounds_;
    dvec3 origin_{0, 0, 0};
    Shading shading_ = Shading::flat;
    bool has_patterns_ = false;
    std::vector<SmallNormal> normals_;  // of every corner of every triangle
    std::uint64_t serial_ = 0;

    // Three corners a triangle.
    gl::VertexArray array_;
    gl::Buffer vertices_;
    gl::Buffer colours_;

    // Corners that triangles share.
    gl::VertexArray shared_array_;
    gl::Buffer shared_vertices_;
    gl::Buffer shared_indices_;
};

}  // namespace surefoot::view
