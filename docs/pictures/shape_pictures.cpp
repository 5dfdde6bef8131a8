// The pictures of docs/method.md, shape by shape: one panel for each patch of M, each with a sweep that ends on that
// patch.
#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <span>
#include <string>
#include <vector>

#include <surefoot/sweep.hpp>

#include "canvas.hpp"
#include "scene.hpp"
#include "sheets.hpp"

namespace pictures {
namespace {

struct Panel {
    const char* title;
    surefoot::Motion motion;
    surefoot::Triangle triangle;
};

struct Touch {
    surefoot::Hit hit;
    dvec3 end;  // of the reference point
};

constexpr double panel_width = 236;
constexpr double panel_height = 236;
constexpr double azimuth = 28;
constexpr double elevation = 24;

struct Extent {
    Point least{1e9, 1e9};
    Point most{-1e9, -1e9};
    void add(Point p) {
        least = {std::min(least.x, p.x), std::min(least.y, p.y)};
        most = {std::max(most.x, p.x), std::max(most.y, p.y)};
    }
};

// All that a panel shows, seen by a camera at the origin with scale 1.
Extent extent_of(const surefoot::Shape& shape, const Panel& panel, const Touch& touch) {
    const Camera camera(azimuth, elevation, {0, 0}, 1);
    Extent extent;
    for (const dvec3& corner : {panel.triangle.a, panel.triangle.b, panel.triangle.c}) extent.add(camera(corner));
    extent.add(camera(panel.motion.from));
    for (const dvec3& across : {camera.right(), camera.up()}) {
        extent.add(camera(touch.end + support_point(shape, across)));
        extent.add(camera(touch.end + support_point(shape, -across)));
    }
    return extent;
}

// Panels side by side, each in the middle of its room, all to one scale.
std::string draw_panels(const char* description, const surefoot::Shape& shape, std::span<const Panel> panels) {
    std::vector<Touch> touches;
    std::vector<Extent> extents;
    double scale = 1e9;
    for (const Panel& panel : panels) {
        const auto hit = surefoot::sweep(shape, panel.motion, panel.triangle);
        if (!hit) {
            std::fprintf(stderr, "%s: the sweep '%s' meets nothing\n", description, panel.title);
            std::exit(1);
        }
        touches.push_back({*hit, panel.motion.from + hit->t * (panel.motion.to - panel.motion.from)});
        extents.push_back(extent_of(shape, panel, touches.back()));
        scale = std::min({scale, (panel_width - 30) / (extents.back().most.x - extents.back().least.x),
                          (panel_height - 20) / (extents.back().most.y - extents.back().least.y)});
    }
    Canvas c(16 + panel_width * static_cast<double>(panels.size()), panel_height + 62, description);
    double left = 8;
    for (std::size_t i = 0; i < panels.size(); ++i) {
        const Panel& panel = panels[i];
        const Point middle = 0.5 * (extents[i].least + extents[i].most);
        const Camera camera(azimuth, elevation, Point{left + panel_width / 2, 16 + panel_height / 2} - scale * middle,
                            scale);
        draw_triangle(c, camera, panel.triangle);
        draw_shape(c, camera, shape, touches[i].end);
        c.arrow(camera(panel.motion.from), camera(touches[i].end), {.stroke = colour::motion, .width = 1.8});
        c.dot(camera(touches[i].end), colour::motion, 3.5);
        draw_touch(c, camera, touches[i].hit, 0.55);
        c.text({left + panel_width / 2, panel_height + 44}, panel.title, {.size = 15, .anchor = Anchor::middle});
        left += panel_width;
    }
    return c.svg();
}

std::string draw_ball() {
    static const Panel panels[] = {
        {"face", {{0, 1.7, 0.3}, {0.1, 0, 0}}, {{-1.2, 0, 0.9}, {1.3, 0, 0.8}, {0.1, 0.1, -1.3}}},
        {"edge", {{-0.9, 1.25, 0}, {0.5, 0.1, 0}}, {{0, 0, 1.0}, {0.1, 0, -1.1}, {1.6, -0.5, 0}}},
        {"vertex", {{-1.1, 0.9, 0.4}, {0.4, 0.1, 0}}, {{0, 0, 0.2}, {1.5, -0.3, 0.9}, {1.3, 0.1, -0.9}}},
    };
    return draw_panels("An ellipsoid that meets a face, an edge, a vertex.", surefoot::Ellipsoid{{0.42, 0.6, 0.42}},
                       panels);
}

std::string draw_box() {
    static const Panel panels[] = {
        {"the box's face, a vertex", {{0, 1.9, 0}, {0, 0, 0}}, {{0.1, 0.3, 0}, {1.3, -0.5, 0.4}, {-0.5, -0.5, 1.1}}},
        {"the triangle's face, a corner",
         {{-0.2, 1.7, 0}, {0.2, 0, 0}},
         {{-1.2, -0.45, 0.9}, {1.1, 0.1, 1.0}, {0.3, 0.35, -1.3}}},
        {"edge against edge",
         {{-1.2, 1.2, 0}, {0.6, 0.1, 0}},
         {{-0.3, 0.35, 1.1}, {0.35, -0.25, -0.9}, {1.5, -0.3, 0.8}}},
    };
    return draw_panels("A box that meets a triangle: the three kinds of facet that M has.",
                       surefoot::Box{{0.42, 0.5, 0.42}}, panels);
}

std::string draw_capsule() {
    static const Panel panels[] = {
        {"core's end, face", {{-0.2, 1.9, 0}, {0.2, 0, 0}}, {{-1.2, -0.3, 0.9}, {1.1, 0.0, 1.0}, {0.3, 0.25, -1.3}}},
        {"core, edge across", {{-1.2, 0.3, 0}, {0.6, 0.1, 0}}, {{0, 0.1, 1.1}, {0.15, 0.3, -1.1}, {1.5, -0.2, 0}}},
        {"core, vertex", {{-1.2, 0.2, 0.3}, {0.6, 0.1, 0}}, {{0, 0.2, 0.2}, {1.5, -0.3, 0.9}, {1.3, 0.3, -0.9}}},
    };
    return draw_panels("A capsule that meets a triangle with the end of its core, and with its side.",
                       surefoot::Capsule{.radius = 0.36, .half_height = 0.36}, panels);
}

std::string draw_cylinder() {
    static const Panel panels[] = {
        {"cap, a vertex", {{0, 1.9, 0}, {0, 0, 0}}, {{0.05, 0.3, 0}, {1.3, -0.5, 0.4}, {-0.5, -0.5, 1.1}}},
        {"wall, a vertex", {{-1.3, 0.3, 0.2}, {0.6, 0.1, 0}}, {{0, 0.2, 0.2}, {1.5, -0.3, 0.9}, {1.3, 0.3, -0.9}}},
        {"wall, an edge", {{-1.3, 0.2, 0}, {0.6, 0.1, 0}}, {{0, 0.1, 1.1}, {0.15, 0.3, -1.1}, {1.5, -0.2, 0}}},
        {"rim, an edge", {{-1.1, 1.2, 0}, {0.6, 0.1, 0}}, {{-0.35, 0.45, 0.9}, {0.35, -0.3, -0.8}, {1.5, -0.4, 0.7}}},
    };
    return draw_panels("An upright cylinder that meets a triangle with its cap, its wall, its rim.",
                       surefoot::Cylinder{.radius = 0.4, .half_height = 0.5}, panels);
}

std::string draw_cone() {
    static const Panel panels[] = {
        {"apex, the face", {{-0.2, 1.3, 0}, {0.2, -0.6, 0}}, {{-1.2, -0.3, 0.9}, {1.1, 0.0, 1.0}, {0.3, 0.25, -1.3}}},
        {"side, a vertex", {{-1.4, -0.1, 0.2}, {0.6, -0.4, 0}}, {{0, 0.2, 0.2}, {1.5, -0.3, 0.9}, {1.3, 0.3, -0.9}}},
        {"side, an edge", {{-1.4, -0.1, 0}, {0.6, -0.4, 0}}, {{0, 0.1, 1.1}, {0.15, 0.3, -1.1}, {1.5, -0.2, 0}}},
        {"rim, an edge", {{-1.3, -1.4, 0}, {0.6, -0.2, 0}}, {{-0.25, -0.1, 1.0}, {0.2, 0.25, -0.9}, {1.5, 0.4, 0.3}}},
    };
    return draw_panels("A cone on its apex that meets a triangle with its apex, its side, its rim.",
                       surefoot::Cone{.radius = 0.5, .height = 1.0}, panels);
}

}  // namespace

std::span<const Picture> shape_pictures() {
    static constexpr Picture all[] = {
        {"method-ball", draw_ball},         {"method-box", draw_box},   {"method-capsule", draw_capsule},
        {"method-cylinder", draw_cylinder}, {"method-cone", draw_cone},
    };
    return all;
}

}  // namespace pictures
