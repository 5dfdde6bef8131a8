/// A flat picture as a list of shapes: boxes, discs, rings, arcs, triangles, lines, signs, text. Filled anew every
/// frame, drawn by OrthoPass in one go. Places are in layout units from the upper left: a window is `size()` of them,
/// at least 800 by 600 at the usual scale, so that what fits there fits in any window.
#pragma once

#include <glm/ext/vector_float2.hpp>
#include <glm/ext/vector_float4.hpp>
#include <optional>
#include <string_view>
#include <vector>

#include "view/colour.hpp"
#include "view/input.hpp"
#include "view/letters.hpp"

namespace surefoot::view {

struct Rect {
    dvec2 low{0, 0};
    dvec2 high{0, 0};

    [[nodiscard]] dvec2 size() const { return high - low; }
    [[nodiscard]] dvec2 middle() const { return (low + high) * 0.5; }
    [[nodiscard]] bool has(const dvec2& place) const {
        return place.x >= low.x && place.y >= low.y && place.x < high.x && place.y < high.y;
    }
    [[nodiscard]] bool meets(const Rect& other) const {
        return low.x < other.high.x && other.low.x < high.x && low.y < other.high.y && other.low.y < high.y;
    }
    [[nodiscard]] Rect grown(double by) const { return {low - dvec2(by), high + dvec2(by)}; }
};

/// From one colour above to another below, within an outline.
struct Fill {
    Colour top;
    Colour bottom;
    Colour edge{0, 0, 0, 0};
    double edge_width = 0;  ///< outside of the shape; of text at most a sixth of its height
    double softness = 0;    ///< over how many units the border fades; 0: as sharp as pixels are

    Fill(Colour colour) : top(colour), bottom(colour) {}  // NOLINT: a colour is a fill
    Fill(Colour above, Colour below) : top(above), bottom(below) {}
    [[nodiscard]] Fill edged(Colour colour, double width) const;
    [[nodiscard]] Fill soft(double units) const;
};

enum class Align : std::uint8_t { left, middle, right };

struct TextLook {
    double size = 16;  ///< an em
    Colour colour = paint::paper;
    Face face = Face::plain;
    Align align = Align::left;
    Colour edge = rgb(0x0A0E12, 0.85);
    double edge_width = 0;  ///< an outline that keeps it legible on any ground
};

/// One shape as the graphics card takes it, in pixels.
struct CanvasItem {
    enum class Kind : std::uint8_t { box, arc, triangle, glyph, picture };

    glm::vec2 middle;
    glm::vec2 half;
    glm::vec4 turn_and_widths;  ///< cosine, sine, edge, softness
    glm::vec4 a;                ///< arc: radius, half width, sine and cosine of half of it; triangle: two corners;
                                ///< glyph: texels from and to; picture: middle and half size in it
    glm::vec4 b;  ///< arc: the ring's middle from ours; triangle: third corner; glyph: reach; picture: its
                  ///< turn; then radius of corners, kind
    glm::vec4 clip;
    Colour top;
    Colour bottom;
    Colour edge;
};

/// How layout units become pixels.
struct Layout {
    ivec2 framebuffer{800, 600};  ///< [pixels]
    double user_scale = 1;        ///< how much larger the user wants it [0.5 to 2]
    double per_window_unit = 1;   ///< pixels, where the pointer is told in window units [> 0]

    [[nodiscard]] double pixels() const;  ///< of one unit
    [[nodiscard]] dvec2 size() const;     ///< of the window
};

class Canvas {
public:
    explicit Canvas(Letters& letters) : letters_(letters) {}

    void begin(const Layout& layout);
    [[nodiscard]] dvec2 size() const { return layout_.size(); }

    void box(const Rect& rect, double radius, const Fill& fill);
    void disc(const dvec2& middle, double radius, const Fill& fill);
    void ring(const dvec2& middle, double radius, double width, const Fill& fill);

    /// A part of a ring with round ends: `sweep` about the direction `angle`; 0 is up, turning to the right [rad].
    void arc(const dvec2& middle, double radius, double width, double angle, double sweep, const Fill& fill);

    /// Of a whole turn from the top, to the right [0 to 1].
    void progress(const dvec2& middle, double radius, double width, double share, const Fill& fill);

    void triangle(const dvec2& a, const dvec2& b, const dvec2& c, const Fill& fill, double radius = 0);
    void line(const dvec2& from, const dvec2& to, double width, const Fill& fill);

    /// `size` is its height; turned to the right [rad].
    void sign(Sign sign, const dvec2& middle, double size, const Fill& fill, double turn = 0);

    /// A part of the picture that OrthoPass holds: `middle` and `half` of it in parts of the whole, turned [rad].
    void picture(const Rect& rect, double radius, const dvec2& middle, const dvec2& half, double turn, double opacity);

    /// One line; `at` is on the line of writing, at its left, middle or right. Returns how wide it is.
    double text(std::string_view words, const dvec2& at, const TextLook& look);

    /// One line whose capitals stand in the middle of `height` at `at.y`.
    double text_in(std::string_view words, const Rect& rect, const TextLook& look);

    /// Lines no longer than `width`, broken at spaces and where the text says so. Returns how high they are, from `at`.
    double wrapped(std::string_view words, const dvec2& at, double width, const TextLook& look);

    [[nodiscard]] double width_of(std::string_view words, const TextLook& look) const;
    [[nodiscard]] std::vector<std::string_view> lines_of(std::string_view words, double width,
                                                         const TextLook& look) const;
    [[nodiscard]] static double line_height(const TextLook& look) { return look.size * 1.35; }

    /// What comes next is seen within this only; none: everywhere.
    void clip(const std::optional<Rect>& to);
    /// What comes next is this opaque [0 to 1].
    void fade(double opacity) { opacity_ = opacity; }

    [[nodiscard]] const std::vector<CanvasItem>& items() const { return items_; }
    /// Of a shape without its softness, in layout units.
    [[nodiscard]] Rect bounds_of(const CanvasItem& item) const;

    [[nodiscard]] Letters& letters() const { return letters_; }
    [[nodiscard]] const Layout& layout() const { return layout_; }

private:
    void add(CanvasItem::Kind kind, const dvec2& middle, const dvec2& half, const dvec2& turn, const Fill& fill,
             const glm::vec4& a, const glm::vec4& b);

    Letters& letters_;
    Layout layout_;
    std::vector<CanvasItem> items_;
    glm::vec4 clip_{-1e6F, -1e6F, 1e6F, 1e6F};
    double opacity_ = 1;
    double pixels_ = 1;
};

/// A place for something of this size: `anchor` is -1, 0 or 1 along each axis, for low, middle and high.
[[nodiscard]] Rect anchored(const dvec2& frame, const dvec2& anchor, const dvec2& size, double margin);

}  // namespace surefoot::view
