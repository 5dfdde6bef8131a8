#include <algorithm>
#include <cmath>

#include "frame.hpp"
#include "kernels/mesh_search.hpp"
#include "overloaded.hpp"

namespace surefoot::internal {

namespace {

struct Extents {
    FilterKind kind;
    Vec half;             // [m]
    double centre_y = 0;  // in half heights
};

Extents extents_of(const Shape& shape) noexcept {
    return std::visit(Overloaded{
                          [](const Sphere& s) {
                              return Extents{FilterKind::ball, {s.radius, s.radius, s.radius}};
                          },
                          [](const Ellipsoid& s) {
                              return Extents{FilterKind::ball, to_vec(s.radii)};
                          },
                          [](const Capsule& s) {
                              return Extents{FilterKind::capsule, {s.radius, s.half_height + s.radius, s.radius}};
                          },
                          [](const Box& s) {
                              return Extents{FilterKind::box, to_vec(s.half_extents)};
                          },
                          [](const Cylinder& s) {
                              return Extents{FilterKind::cylinder, {s.radius, s.half_height, s.radius}};
                          },
                          [](const Cone& s) {
                              return Extents{FilterKind::cone, {s.radius, s.height / 2, s.radius}, 1};
                          },
                      },
                      shape);
}

void fill_filter(ShapeFilter& filter, const Frame& frame, const Extents& extents, const Vec& along) noexcept {
    const Vec columns[3] = {divide_each(frame.to_local({1, 0, 0}), extents.half),
                            divide_each(frame.to_local({0, 1, 0}), extents.half),
                            divide_each(frame.to_local({0, 0, 1}), extents.half)};
    filter.is_diagonal = true;
    const Vec motion = divide_each(frame.to_local(along), extents.half);
    for (int row = 0; row < 3; ++row) {
        const auto component = [&](const Vec& v) { return row == 0 ? v.x : (row == 1 ? v.y : v.z); };
        float sum = 0;
        for (int column = 0; column < 3; ++column) {
            const auto entry = static_cast<float>(component(columns[column]));
            filter.to_scaled[row][column] = entry;
            sum += std::abs(entry);
            if (row != column && entry != 0) filter.is_diagonal = false;
        }
        filter.row_sum = std::max(filter.row_sum, sum);
        filter.motion[row] = static_cast<float>(component(motion));
        filter.motion_size = std::max(filter.motion_size, std::abs(filter.motion[row]));
        filter.per_extent[row] = static_cast<float>(1 / component(extents.half));
        filter.centre[row] = row == 1 ? static_cast<float>(extents.centre_y) : 0;
    }
    filter.kind = extents.kind;
}

MeshSearch begin(const MeshView& view, const Motion& motion, const Box3& extent) noexcept {
    MeshSearch search;
    search.view = &view;
    search.motion = motion;
    search.extent = extent;
    search.region = swept_box(extent, motion);
    return search;
}

}  // namespace

MeshSearch make_search(const MeshView& view, const Volume& volume, const Motion& motion, const Box3& extent) noexcept {
    MeshSearch search = begin(view, motion, extent);
    const bool is_sphere = std::holds_alternative<Sphere>(volume.shape);
    const Frame frame(is_sphere ? dquat(1, 0, 0, 0) : volume.orientation);
    fill_filter(search.filter, frame, extents_of(volume.shape), to_vec(motion.to) - to_vec(motion.from));
    if (const auto* capsule = std::get_if<Capsule>(&volume.shape)) {
        search.filter.radius = static_cast<float>(capsule->radius);
        search.filter.half_height = static_cast<float>(capsule->half_height);
    }
    return search;
}

MeshSearch make_point_search(const MeshView& view, const Motion& motion, const Box3& extent) noexcept {
    MeshSearch search = begin(view, motion, extent);
    fill_filter(search.filter, Frame(dquat(1, 0, 0, 0)), {FilterKind::point, {1, 1, 1}},
                to_vec(motion.to) - to_vec(motion.from));
    return search;
}

}  // namespace surefoot::internal
