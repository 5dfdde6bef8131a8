#include "view/shapes.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <numbers>
#include <tuple>
#include <variant>

namespace surefoot::view {
namespace {

constexpr double pi = std::numbers::pi;

/// One corner of an outline that is turned about Y. Where two have one place, the surface has a crease.
struct Station {
    double radius;
    double y;
    double out;  // the normal's part away from the axis
    double up;   // and along it
};

/// A figure of revolution; the outline goes from the top down.
ShapeMesh turned(const std::vector<Station>& outline, int around) {
    ShapeMesh mesh;
    const auto columns = static_cast<std::uint32_t>(around);
    for (const Station& s : outline) {
        for (std::uint32_t i = 0; i <= columns; ++i) {
            const double angle = 2 * pi * (i % columns) / columns;
            const double c = std::cos(angle);
            const double n = std::sin(angle);
            mesh.vertices.push_back({vec3(s.radius * n, s.y, s.radius * c), vec3(s.out * n, s.up, s.out * c)});
        }
    }
    for (std::uint32_t row = 0; row + 1 < outline.size(); ++row) {
        const Station& above = outline[row];
        const Station& below = outline[row + 1];
        if (above.radius == below.radius && above.y == below.y) continue;  // a crease
        for (std::uint32_t i = 0; i < columns; ++i) {
            const std::uint32_t a = row * (columns + 1) + i;
            const std::uint32_t b = a + columns + 1;
            if (below.radius > 0) mesh.indices.insert(mesh.indices.end(), {a, b, b + 1});
            if (above.radius > 0) mesh.indices.insert(mesh.indices.end(), {a, b + 1, a + 1});
        }
    }
    return mesh;
}

ShapeMesh box(const dvec3& half) {
    ShapeMesh mesh;
    for (int axis = 0; axis < 3; ++axis) {
        for (const double side : {-1.0, 1.0}) {
            const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
            dvec3 normal(0);
            normal[axis] = side;
            for (const auto& [u, v] : {std::pair{-1.0, -1.0}, {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}}) {
                dvec3 corner(0);
                corner[axis] = side;
                corner[(axis + 1) % 3] = u * side;  // mirrored on the other side, so that fronts face outwards
                corner[(axis + 2) % 3] = v;
                mesh.vertices.push_back({vec3(corner * half), vec3(normal)});
            }
            mesh.indices.insert(mesh.indices.end(), {first, first + 1, first + 2, first, first + 2, first + 3});
        }
    }
    return mesh;
}

std::vector<Station> cap(double radius, double middle, int rows, bool upper) {
    std::vector<Station> stations;
    for (int i = 0; i <= rows; ++i) {
        const double angle = (upper ? 0 : pi / 2) + pi / 2 * i / rows;
        const double s = i == (upper ? 0 : rows) ? 0 : std::sin(angle);
        stations.push_back({radius * s, middle + radius * std::cos(angle), s, std::cos(angle)});
    }
    return stations;
}

ShapeMesh sphere(int around) {
    std::vector<Station> outline = cap(1, 0, around / 4, true);
    const std::vector<Station> lower = cap(1, 0, around / 4, false);
    outline.insert(outline.end(), lower.begin() + 1, lower.end());
    return turned(outline, around);
}

void stretch(ShapeMesh& mesh, const dvec3& by) {
    for (ShapeMesh::Vertex& v : mesh.vertices) {
        v.position = vec3(dvec3(v.position) * by);
        v.normal = vec3(glm::normalize(dvec3(v.normal) / by));
    }
}

/// Which triangles share an edge, by place: vertices are doubled at creases.
void add_edges(ShapeMesh& mesh) {
    using Place = std::tuple<float, float, float>;
    const auto place = [&](std::uint32_t i) {
        const vec3& p = mesh.vertices[i].position;
        return Place{p.x + 0.0F, p.y + 0.0F, p.z + 0.0F};
    };
    struct Half {
        vec3 face;
        vec3 corners[2];
    };
    std::map<std::pair<Place, Place>, Half> halves;
    for (std::size_t t = 0; t < mesh.indices.size(); t += 3) {
        vec3 p[3];
        for (std::size_t i = 0; i < 3; ++i) p[i] = mesh.vertices[mesh.indices[t + i]].position;
        const vec3 cross = glm::cross(p[1] - p[0], p[2] - p[0]);
        if (glm::length(cross) == 0) continue;
        const vec3 face = glm::normalize(cross);
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t next = (i + 1) % 3;
            const Place a = place(mesh.indices[t + i]);
            const Place b = place(mesh.indices[t + next]);
            const auto [found, is_new] = halves.try_emplace(std::minmax(a, b), Half{face, {p[i], p[next]}});
            if (is_new) continue;
            const bool crease = glm::dot(found->second.face, face) < 0.8F;
            mesh.edges.push_back({p[i], p[next], {found->second.face, face}, crease});
        }
    }
}

struct MakeMesh {
    int around;

    ShapeMesh operator()(const Sphere& s) const {
        ShapeMesh mesh = sphere(around);
        stretch(mesh, dvec3(s.radius));
        return mesh;
    }
    ShapeMesh operator()(const Ellipsoid& e) const {
        ShapeMesh mesh = sphere(around);
        stretch(mesh, e.radii);
        return mesh;
    }
    ShapeMesh operator()(const Capsule& c) const {
        std::vector<Station> outline = cap(c.radius, c.half_height, around / 4, true);
        const std::vector<Station> lower = cap(c.radius, -c.half_height, around / 4, false);
        outline.insert(outline.end(), lower.begin(), lower.end());
        return turned(outline, around);
    }
    ShapeMesh operator()(const Box& b) const { return box(b.half_extents); }
    ShapeMesh operator()(const Cylinder& c) const {
        return turned({{0, c.half_height, 0, 1},
                       {c.radius, c.half_height, 0, 1},
                       {c.radius, c.half_height, 1, 0},
                       {c.radius, -c.half_height, 1, 0},
                       {c.radius, -c.half_height, 0, -1},
                       {0, -c.half_height, 0, -1}},
                      around);
    }
    ShapeMesh operator()(const Cone& c) const {
        const double slant = std::hypot(c.radius, c.height);
        const double out = c.height / slant;
        const double down = -c.radius / slant;
        return turned(
            {{0, c.height, 0, 1}, {c.radius, c.height, 0, 1}, {c.radius, c.height, out, down}, {0, 0, out, down}},
            around);
    }
};

struct Reach {
    double operator()(const Sphere& s) const { return s.radius; }
    double operator()(const Ellipsoid& e) const { return std::max({e.radii.x, e.radii.y, e.radii.z}); }
    double operator()(const Capsule& c) const { return c.radius + c.half_height; }
    double operator()(const Box& b) const { return glm::length(b.half_extents); }
    double operator()(const Cylinder& c) const { return std::hypot(c.radius, c.half_height); }
    double operator()(const Cone& c) const { return std::hypot(c.radius, c.height); }
};

}  // namespace

ShapeMesh mesh_of(const Shape& shape, int around) {
    ShapeMesh mesh = std::visit(MakeMesh{around}, shape);
    add_edges(mesh);
    return mesh;
}

double reach_of(const Shape& shape) {
    return std::visit(Reach{}, shape);
}

dvec3 middle_of(const Shape& shape) {
    const auto* const cone = std::get_if<Cone>(&shape);
    return cone != nullptr ? dvec3(0, cone->height / 2, 0) : dvec3(0);
}

}  // namespace surefoot::view
