/// Draws a frame: say `begin`, hand over what is to be seen in any order, say `end`.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <surefoot/bounds.hpp>
#include <surefoot/debug_draw.hpp>
#include <surefoot/pose.hpp>
#include <surefoot/shapes.hpp>

#include "view/camera.hpp"
#include "view/colour.hpp"
#include "view/disc_pass.hpp"
#include "view/lighting.hpp"
#include "view/line_pass.hpp"
#include "view/model.hpp"
#include "view/piece_pass.hpp"

namespace surefoot::view {

/// From where, and how large.
struct FrameView {
    Camera camera;
    ivec2 size{1280, 720};         ///< in window units
    ivec2 framebuffer{1280, 720};  ///< in pixels
    double scale = 1;              ///< of letters, and so of lines and of what marks a place

    [[nodiscard]] double pixels_per_unit() const { return double(framebuffer.y) / size.y; }

    /// Of what is as wide however far away it is.
    [[nodiscard]] double line_pixels() const { return pixels_per_unit() * scale; }
};

/// The lines on a model's edges, by `EdgeKind`: open, convex, flat, concave. An opacity of 0 hides a kind.
struct EdgeLook {
    double width = 0;  ///< [window units, for usual letters]; 0 for none
    Colour kinds[4] = {with_opacity(paint::ink, 0.5), with_opacity(paint::ink, 0.35), with_opacity(paint::ink, 0.16),
                       with_opacity(paint::ink, 0.35)};
};

struct ModelLook {
    EdgeLook edges{};
    bool moves = false;  ///< its shadow is drawn anew with every frame
    bool casts_shadow = true;
    bool yields = false;  ///< has holes close up to what is seen through a `ScreenDoor`, as leaves around it should
};

/// What is to be seen whatever stands before it: models in between are drawn with holes, as a screen door, in a soft
/// ellipse around it. Models with lines on their edges, or with round shading, stay whole.
struct ScreenDoor {
    dvec3 middle{0, 0, 0};   ///< of what is to be seen
    dvec2 half{0.75, 1.05};  ///< of its size, across and along up, with some air [m, > 0]
    double strength = 0;     ///< 0 draws everything whole; 1 leaves nothing of it [0 to 1]
    double nearest = 0;      ///< what is nearer to the eye than this goes away, too [m]
};

struct ShapeLook {
    Colour colour = paint::hit;
    double opacity = 0.35;  ///< of its middle; 1 is a solid body
    double outline = 2;     ///< [window units, for usual letters], 0 for none
    double behind = 0.30;   ///< how much of the outline is seen through what hides it
    bool casts_shadow = true;
};

struct Label {
    dvec3 place{0, 0, 0};
    std::string text;
    Colour colour = paint::paper;
    dvec2 offset{0, 0};    ///< from the place, in window units, y down
    double behind = 0.35;  ///< opacity where something hides the place, for whoever asks
    bool yields = false;   ///< steps aside, up or down, where it would lie on another
};

struct FrameCounts {
    std::size_t triangles = 0;
    std::size_t lines = 0;
    std::size_t shapes = 0;
    std::size_t pieces = 0;
    bool shadow_drawn = false;  ///< the still shadow map had to be made anew
};

class Renderer {
public:
    Renderer();
    Renderer(const Renderer&) = delete;
    Renderer& operator=(const Renderer&) = delete;
    ~Renderer();

    Effects effects{};
    Sky sky{};

    void begin(const FrameView& view);

    /// A model, placed; it has to live until `end`.
    void model(const std::shared_ptr<const Model>& model, const ModelLook& look = {}, const Pose& pose = {});

    /// For all models of this frame.
    void see_through(const ScreenDoor& door) { door_ = door; }

    void shape(const Volume& volume, const dvec3& position, const ShapeLook& look = {});

    /// A small solid; hundreds of them cost little.
    void piece(const Piece& piece);

    /// Soft, over whatever is solid.
    void disc(const Disc& disc);

    void line(const dvec3& from, const dvec3& to, const Stroke& stroke);
    void polyline(std::span<const dvec3> points, const Stroke& stroke, bool closed = false);

    /// `size` is its diameter in window units, for usual letters.
    void point(const dvec3& place, double size, Colour colour, double behind = 0.3);

    /// The head is `head` window units long, for usual letters, but at most half of the arrow.
    void arrow(const dvec3& from, const dvec3& to, const Stroke& stroke, double head = 14);

    void box(const Bounds& bounds, const Stroke& stroke);

    /// A circle about `axis`.
    void circle(const dvec3& middle, const dvec3& axis, double radius, const Stroke& stroke);

    void label(const Label& label);

    // The core's DebugDraw: `DebugDraw draw(renderer);`
    void line(const dvec3& from, const dvec3& to, const DebugColour& colour) { line(from, to, Stroke{colour}); }
    void triangle(const dvec3& a, const dvec3& b, const dvec3& c, const DebugColour& colour);
    void text(const dvec3& place, std::string_view words, const DebugColour& colour) {
        label({.place = place, .text = std::string(words), .colour = colour});
    }

    /// Draws everything into this framebuffer object.
    void end(unsigned framebuffer);

    [[nodiscard]] const FrameView& view() const { return view_; }
    [[nodiscard]] const std::vector<Label>& labels() const { return labels_; }
    [[nodiscard]] const FrameCounts& counts() const { return counts_; }

private:
    struct Parts;
    struct PlacedModel;
    struct PlacedShape;

    [[nodiscard]] vec3 seen(const dvec3& place) const { return vec3(place - view_.camera.eye); }
    void outline(const PlacedShape& shape);
    void draw_shadows();
    void draw_scene();
    void draw_sky();
    void draw_models();
    void set_door(const gl::Program& program) const;
    void draw_shapes(bool solid);
    void draw_pieces(bool see_through);
    void draw_discs();
    void draw_triangles();
    void finish(unsigned framebuffer);

    std::unique_ptr<Parts> parts_;
    FrameView view_;
    ScreenDoor door_;
    std::vector<Label> labels_;
    FrameCounts counts_;
};

}  // namespace surefoot::view
