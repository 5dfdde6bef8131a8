/// What a renderer keeps from frame to frame, and what it collects for one.
#pragma once

#include <optional>

#include "view/renderer.hpp"
#include "view/shadow.hpp"
#include "view/shape_pass.hpp"

namespace surefoot::view {

struct Renderer::PlacedModel {
    std::shared_ptr<const Model> model;
    ModelLook look;
    Pose pose;
    dmat4 turn{1};  // of the pose

    /// Relative to `eye`.
    [[nodiscard]] gl::mat4 from_model(const dvec3& eye) const;
    [[nodiscard]] dvec3 origin() const;

    /// A place of the world as the model's vertices are.
    [[nodiscard]] gl::vec3 in_model(const dvec3& place) const;
};

struct Renderer::PlacedShape {
    std::shared_ptr<const ShapeModel> model;
    dvec3 position{0, 0, 0};
    dmat4 turn{1};
    ShapeLook look;
    dvec3 middle{0, 0, 0};  // in the world
    double reach = 0;

    [[nodiscard]] gl::mat4 from_model(const dvec3& eye) const;
};

/// The colour and depth that a frame is drawn into before it is shown.
struct Canvas {
    ivec2 size{0, 0};
    gl::Texture colour;
    gl::Texture smooth_colour;
    gl::Texture depth;
    gl::Framebuffer scene;
    gl::Framebuffer smooth;

    void fit(const ivec2& wanted);
};

/// What the still shadow map was drawn for; while it stays so, the map is kept.
struct StillShadow {
    std::vector<std::uint64_t> models;
    std::vector<Pose> poses;
    dvec3 middle{0, 0, 0};
    double radius = 0;
    dvec3 towards_sun{0, 0, 0};
};

struct Renderer::Parts {
    Parts();

    gl::Program mesh[2][4];  // [shadows][round, flat, with edges, with patterns]
    gl::Program door[2][2];  // [shadows][flat, with patterns], with holes
    gl::Program shape;
    gl::Program depth;
    gl::Program flat;
    gl::Program sky;
    gl::Program smooth;
    gl::VertexArray nothing;  // for triangles that cover the screen
    gl::VertexArray flat_array;
    gl::Buffer flat_buffer;
    LinePass lines;
    ShapeStore shapes;
    PiecePass pieces;
    DiscPass discs;
    gl::Texture patterns;
    Canvas canvas;
    std::optional<ShadowMap> still;
    std::optional<ShadowMap> moving;
    StillShadow still_is;

    struct FlatVertex {
        vec3 place;
        Colour colour;
    };
    std::vector<PlacedModel> models;
    std::vector<PlacedShape> placed;
    std::vector<FlatVertex> triangles;
    gl::mat4 clip_from_eye{1};
    Lighting light{};
};

}  // namespace surefoot::view
