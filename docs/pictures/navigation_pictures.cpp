// The pictures of docs/navigation.md.
#include <string>
#include <vector>

#include "canvas.hpp"
#include "sheets.hpp"

namespace pictures {
namespace {

constexpr Lettering note{.size = 13.5, .fill = colour::quiet};
constexpr Lettering note_middle{.size = 13.5, .fill = colour::quiet, .anchor = Anchor::middle};
constexpr Lettering head{.size = 15, .bold = true};

// Cells, from the side -----------------------------------------------------------------------------------------------

struct Column {
    double from;
    double to;
    double height;
};

std::string draw_cells() {
    Canvas c(760, 330,
             "A level from the side, cut into columns of cells: stairs are ground, a wall takes the body's radius away "
             "before it, and an edge takes one cell.");
    const View v{{40, 222}, 34};
    constexpr Column solids[] = {{0, 9, 0}, {9, 11, 0.6}, {11, 13, 1.2}, {13, 18, 1.8}, {18, 20, -1.6}};
    for (const Column& solid : solids) {
        const std::vector<Point> block{
            {solid.from, -2}, {solid.from, solid.height}, {solid.to, solid.height}, {solid.to, -2}};
        c.polygon(v(block), {.stroke = colour::ground, .width = 1.6, .fill = colour::ground_fill});
    }
    const std::vector<Point> wall{{3.6, 0}, {3.6, 5}, {4.4, 5}, {4.4, 0}};
    c.polygon(v(wall), {.stroke = colour::ground, .width = 1.6, .fill = colour::ground_fill});
    // Half a metre is a cell; the top of each is ground, or why it is none.
    const auto cells = [&](double from, double to, double height, std::string_view fill) {
        for (double x = from; x < to - 1e-9; x += 0.5)
            c.box(v(x + 0.03, height + 0.2), 0.44 * v.scale, 0.2 * v.scale - 1, {.stroke = colour::none, .fill = fill},
                  1.5);
    };
    const std::string_view good = colour::motion;
    const std::string_view near_wall = colour::touch;
    const std::string_view at_edge = colour::plane;
    cells(0, 2, 0, good);
    cells(2, 3.5, 0, near_wall);
    cells(4.5, 6, 0, near_wall);
    cells(6, 9, 0, good);
    cells(9, 11, 0.6, good);
    cells(11, 13, 1.2, good);
    cells(13, 17.5, 1.8, good);
    cells(17.5, 18, 1.8, at_edge);
    cells(18.5, 20, -1.6, good);
    cells(18, 18.5, -1.6, near_wall);
    c.ellipse(v(15.2, 3.65), 0.85 * v.scale, 1.8 * v.scale, 0,
              {.stroke = colour::shape, .width = 2, .fill = colour::shape_fill});
    c.text(v(4, 5.25), "wall", note_middle);
    c.text(v(2.75, 0.75), "radius", {.size = 13.5, .fill = near_wall, .anchor = Anchor::middle});
    c.text(v(11, 2.15), "steps that it climbs", {.size = 13.5, .fill = good, .anchor = Anchor::middle});
    c.text(v(18.6, 2.5), "an edge: one cell", {.size = 13.5, .fill = at_edge, .anchor = Anchor::middle});
    c.text({40, 322}, "green: ground of the mesh. Feet stand on edges, so only walls take the body's radius away.",
           note);
    return c.svg();
}

// The funnel ---------------------------------------------------------------------------------------------------------

struct Portal {
    Point left;
    Point right;
};

constexpr Portal portals[] = {
    {{1.6, 2.7}, {1.6, 0.8}}, {{3.2, 2.9}, {3.0, 1.3}}, {{4.4, 3.6}, {4.5, 2.2}}, {{5.2, 4.4}, {6.2, 3.2}}};
constexpr Point start{0.3, 1.2};
constexpr Point goal{5.9, 5.2};

void corridor(Canvas& c, const View& v) {
    std::vector<Point> outline{start};
    for (const Portal& portal : portals) outline.push_back(portal.right);
    outline.push_back(goal);
    for (auto portal = std::rbegin(portals); portal != std::rend(portals); ++portal) outline.push_back(portal->left);
    c.polygon(v(outline), {.stroke = colour::ground, .width = 1.4, .fill = colour::ground_fill});
    for (const Portal& portal : portals)
        c.line(v(portal.left), v(portal.right), {.stroke = colour::quiet, .width = 1.4, .dashed = true});
}

void funnel(Canvas& c, const View& v, Point apex, Point left, Point right) {
    const std::vector<Point> inside{apex, left, right};
    c.polygon(v(inside), {.stroke = colour::none, .fill = colour::plane_fill, .opacity = 0.8});
    c.line(v(apex), v(left), {.stroke = colour::plane, .width = 2});
    c.line(v(apex), v(right), {.stroke = colour::plane, .width = 2});
}

std::string draw_funnel() {
    Canvas c(780, 330, "Three moments of the funnel: it narrows, its sides cross and the line bends, a new one opens.");
    const View first{{20, 290}, 36};
    const View second{{275, 290}, 36};
    const View third{{530, 290}, 36};
    for (const View& v : {first, second, third}) corridor(c, v);
    funnel(c, first, start, portals[1].left, portals[1].right);
    funnel(c, second, start, portals[2].left, portals[3].right);
    c.line(second(start), second(goal), {.stroke = colour::touch, .width = 2, .dashed = true});
    const Point bend = portals[2].left;
    const std::vector<Point> way{start, bend, goal};
    c.polyline(third(way), {.stroke = colour::motion, .width = 3});
    c.dot(third(bend), colour::motion, 5);
    for (const View& v : {first, second, third}) {
        c.dot(v(start), colour::ink);
        c.dot(v(goal), colour::ink);
    }
    c.text(first(0.2, 7.1), "1  each portal narrows it", head);
    c.text(second(0.2, 7.1), "2  its sides would cross", head);
    c.text(third(0.2, 7.1), "3  there the line bends", head);
    c.text({28, 318},
           "violet: the funnel. Red: what comes next lies to the left of its left side, so the line bends at that "
           "side's end.",
           note);
    return c.svg();
}

}  // namespace

std::span<const Picture> navigation_pictures() {
    static constexpr Picture all[] = {{"navigation-cells", draw_cells}, {"navigation-funnel", draw_funnel}};
    return all;
}

}  // namespace pictures
