/// Many small solids in a handful of calls: what figures, coins and puffs of dust are made of.
#pragma once

#include <array>
#include <cstdint>
#include <glm/ext/matrix_double4x3.hpp>
#include <vector>

#include <surefoot/math.hpp>

#include "view/camera.hpp"
#include "view/colour.hpp"
#include "view/gl.hpp"
#include "view/lighting.hpp"

namespace surefoot::view {

using glm::dmat4x3;

enum class Solid : std::uint8_t {
    ball,  ///< of radius 1 about the origin
    drum,  ///< of radius 1 about Y, from -1 to 1
    cone,  ///< of radius 1 about Y, from its base at 0 to its tip at 1
    cube,  ///< from -1 to 1 on every axis
};
inline constexpr std::size_t solid_count = 4;

struct Piece {
    Solid solid = Solid::ball;
    dmat4x3 place{1};            ///< from the solid to the world: it may turn, stretch and shear, but not mirror
    Colour colour = paint::hit;  ///< below 255 of `a` it is seen through, and what is farther is drawn first
    float glow = 0;              ///< how much of its colour it shines by itself [0 to 1]
    bool casts_shadow = false;   ///< where shadows are drawn
};

class PiecePass {
public:
    PiecePass();

    void clear() { pieces_.clear(); }
    void add(const Piece& piece) { pieces_.push_back(piece); }
    [[nodiscard]] const std::vector<Piece>& pieces() const { return pieces_; }

    /// Those that are solid, or those that are seen through. `pixel` is how large one is a metre away; small pieces get
    /// few corners. Returns how many triangles that were.
    std::size_t draw(const Lighting& light, const gl::mat4& clip_from_eye, const dvec3& eye, double pixel,
                     bool see_through, bool shadows);

    /// Those that cast shadows, into a depth map.
    void draw_depth(const gl::mat4& clip_from_middle, const dvec3& middle);

private:
    /// How many corners there are: for what fills a part of the picture, for what is small on it, and for specks.
    static constexpr std::size_t detail_count = 3;

    struct SolidMesh {
        gl::VertexArray array;
        gl::Buffer vertices;
        gl::Buffer indices;
        GLsizei index_count = 0;
    };
    struct Instance {
        gl::vec4 rows[3];  // of the place, relative to the eye
        Colour colour;
        float glow;
    };

    [[nodiscard]] static Instance instance_of(const Piece& piece, const dvec3& origin);
    [[nodiscard]] SolidMesh make_mesh(Solid solid, std::size_t detail) const;
    void draw_run(std::size_t mesh, const std::vector<Instance>& run);

    gl::Program lit_[2];  // without shadows, with
    gl::Program depth_;
    gl::Buffer instances_;
    std::array<SolidMesh, solid_count * detail_count> meshes_;
    std::vector<Piece> pieces_;
    std::array<std::vector<Instance>, solid_count * detail_count> sorted_;
};

/// How far a piece reaches from its middle, at most [m].
[[nodiscard]] double reach_of(const Piece& piece);

}  // namespace surefoot::view
