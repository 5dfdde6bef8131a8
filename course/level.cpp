#include "course/level.hpp"

#include <cmath>
#include <stdexcept>
#include <utility>

namespace surefoot::course {

Triangles& Triangles::triangle(const dvec3& a, const dvec3& b, const dvec3& c) {
    for (const dvec3& corner : {a, b, c}) {
        indices.push_back(static_cast<std::uint32_t>(vertices.size()));
        vertices.emplace_back(corner);
    }
    return *this;
}

Triangles& Triangles::quad(const dvec3& a, const dvec3& b, const dvec3& c, const dvec3& d) {
    return triangle(a, b, c).triangle(a, c, d);
}

Triangles& Triangles::sheet(const dvec3& a, const dvec3& b, const dvec3& c, const dvec3& d, int along, int across) {
    const auto at = [&](int i, int k) {
        const double s = static_cast<double>(i) / along;
        const double t = static_cast<double>(k) / across;
        return (a * (1 - s) + b * s) * (1 - t) + (d * (1 - s) + c * s) * t;
    };
    for (int i = 0; i < along; ++i) {
        for (int k = 0; k < across; ++k) quad(at(i, k), at(i + 1, k), at(i + 1, k + 1), at(i, k + 1));
    }
    return *this;
}

Triangles& Triangles::floor(const dvec3& low, const dvec3& high, int pieces) {
    const double y = low.y;
    return sheet({low.x, y, low.z}, {low.x, y, high.z}, {high.x, y, high.z}, {high.x, y, low.z}, pieces, pieces);
}

Triangles& Triangles::block(const dvec3& low, const dvec3& high) {
    const auto corner = [&](bool x, bool y, bool z) {
        return dvec3{x ? high.x : low.x, y ? high.y : low.y, z ? high.z : low.z};
    };
    const dvec3 c000 = corner(false, false, false), c100 = corner(true, false, false);
    const dvec3 c010 = corner(false, true, false), c110 = corner(true, true, false);
    const dvec3 c001 = corner(false, false, true), c101 = corner(true, false, true);
    const dvec3 c011 = corner(false, true, true), c111 = corner(true, true, true);
    quad(c010, c011, c111, c110).quad(c000, c100, c101, c001);
    quad(c000, c001, c011, c010).quad(c100, c110, c111, c101);
    return quad(c000, c010, c110, c100).quad(c001, c101, c111, c011);
}

Triangles& Triangles::room(const dvec3& low, const dvec3& high) {
    const std::size_t first = indices.size();
    block(low, high);
    for (std::size_t i = first; i < indices.size(); i += 3) std::swap(indices[i + 1], indices[i + 2]);
    return *this;
}

Triangles& Triangles::stairs(double x, int steps, double rise, double tread, double half_width, double landing) {
    for (int i = 0; i < steps; ++i) {
        const double near = x + i * tread;
        const double far = near + (i + 1 == steps ? landing : tread);
        const double low = i * rise, high = (i + 1) * rise;
        quad({near, low, -half_width}, {near, low, half_width}, {near, high, half_width}, {near, high, -half_width});
        quad({near, high, -half_width}, {near, high, half_width}, {far, high, half_width}, {far, high, -half_width});
    }
    return *this;
}

Triangles& Triangles::ramp(double x, double run, double degrees, double half_width, int pieces) {
    const double rise = run * std::tan(radians(degrees));
    return sheet({x, 0, -half_width}, {x, 0, half_width}, {x + run, rise, half_width}, {x + run, rise, -half_width},
                 pieces, pieces);
}

Level& Level::add(Triangles triangles, const Pose& pose, std::function<Pose(double)> path) {
    bodies.push_back({std::move(triangles), path ? path(0) : pose, path});
    return *this;
}

LevelPointer level_of(Triangles triangles, const Pose& pose) {
    auto level = std::make_shared<Level>();
    level->add(std::move(triangles), pose);
    return level;
}

LevelWorld::LevelWorld(const Level& level) : level_(&level) {
    for (std::size_t i = 0; i < level.bodies.size(); ++i) {
        const LevelBody& body = level.bodies[i];
        const auto mesh = Mesh::build({.vertices = body.triangles.vertices, .indices = body.triangles.indices});
        if (!mesh) throw std::runtime_error(mesh.error().text);
        const auto handle = world_.add(*mesh, {.pose = body.pose, .body = static_cast<std::uint32_t>(i)});
        if (!handle) throw std::runtime_error(handle.error().text);
        handles_.push_back(*handle);
    }
}

void LevelWorld::move_to(double time) {
    move_to(poses_at(*level_, time));
}

void LevelWorld::move_to(std::span<const Pose> poses) {
    world_.begin_tick();
    for (std::size_t i = 0; i < handles_.size(); ++i) {
        if (level_->bodies[i].path && !world_.move(handles_[i], poses[i]))
            throw std::runtime_error("a body of the course moves to no valid pose");
    }
}

std::vector<Pose> poses_at(const Level& level, double time) {
    std::vector<Pose> poses;
    for (const LevelBody& body : level.bodies) poses.push_back(body.path ? body.path(time) : body.pose);
    return poses;
}

}  // namespace surefoot::course
