// The shapes in maps of Quake III: curves within their tolerance and without cracks, brushes closed and outside out.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <map>
#include <utility>
#include <vector>

#include "quake3/brush.hpp"
#include "quake3/patch.hpp"
#include "splitmix.hpp"

namespace surefoot::internal::quake3 {
namespace {

using Points = std::vector<dvec3>;
using Triangles = std::vector<std::array<std::uint32_t, 3>>;
using Place = std::array<double, 3>;

Place place(const dvec3& p) {
    return {p.x, p.y, p.z};
}

/// How often each directed edge occurs, by the places of its ends.
using Edges = std::map<std::pair<Place, Place>, int>;

/// Edges without a neighbour that runs the other way.
std::vector<std::pair<Place, Place>> open_edges(const Edges& edges) {
    std::vector<std::pair<Place, Place>> open;
    for (const auto& [edge, n] : edges) {
        const auto twin = edges.find({edge.second, edge.first});
        if (n != 1 || twin == edges.end() || twin->second != 1) open.push_back(edge);
    }
    return open;
}

PatchTriangles cut_alone(const Patch& patch, double tolerance) {
    PatchCutter cutter(tolerance);
    EXPECT_TRUE(cutter.add(patch));
    cutter.settle();
    return cutter.cut(0, patch);
}

/// x and y run evenly from 0 to 64, so that the surface is a height over them.
Patch height_patch(const std::array<float, 9>& heights) {
    Patch patch{.width = 3, .height = 3, .points = {}};
    for (std::size_t i = 0; i < 9; ++i)
        patch.points.push_back({32.0f * static_cast<float>(i % 3), 32.0f * static_cast<float>(i / 3), heights[i]});
    return patch;
}

double height_of(const std::array<float, 9>& heights, double x, double y) {
    const auto weights = [](double t) { return std::array{(1 - t) * (1 - t), 2 * t * (1 - t), t * t}; };
    const auto u = weights(x / 64);
    const auto v = weights(y / 64);
    double z = 0;
    for (std::size_t i = 0; i < 9; ++i) z += u[i % 3] * v[i / 3] * static_cast<double>(heights[i]);
    return z;
}

TEST(Quake3Patch, triangles_lie_within_the_tolerance_and_not_much_closer) {
    const std::vector<std::array<float, 9>> all{{0, 32, 0, 0, 32, 0, 0, 32, 0},
                                                {0, 0, 0, -50, -50, -50, 0, 0, 0},
                                                {0, 0, 64, 0, 16, 32, 64, 32, 0},
                                                {5, 90, -3, 40, 12, 77, -20, 31, 8}};
    for (const auto& heights : all) {
        for (const double tolerance : {4.0, 1.0, 0.1, 0.01}) {
            const PatchTriangles cut = cut_alone(height_patch(heights), tolerance);
            double worst = 0;
            for (const auto& [a, b, c] : cut.triangles) {
                const std::array p{cut.points[a], cut.points[b], cut.points[c]};
                for (int i = 0; i <= 6; ++i) {
                    for (int k = 0; k + i <= 6; ++k) {
                        const dvec3 at = (p[0] * double(i) + p[1] * double(k) + p[2] * double(6 - i - k)) / 6.0;
                        worst = std::max(worst, std::abs(at.z - height_of(heights, at.x, at.y)));
                    }
                }
            }
            EXPECT_LE(worst, tolerance + 1e-12);  // what doubles make of heights around 100
            EXPECT_GE(worst, tolerance / 8);
        }
    }
}

TEST(Quake3Patch, a_flat_patch_is_two_triangles_that_face_the_front) {
    const PatchTriangles cut = cut_alone(height_patch({}), 0.01);
    ASSERT_EQ(cut.triangles.size(), 2u);
    for (const auto& [a, b, c] : cut.triangles) {
        // Rows run along +y and columns along +x; the front of such a patch is above.
        EXPECT_GT(glm::cross(cut.points[b] - cut.points[a], cut.points[c] - cut.points[a]).z, 0);
    }
}

TEST(Quake3Patch, a_tip_has_no_triangles_without_area) {
    Patch cone{.width = 3, .height = 3, .points = {}};
    for (const float x : {-64.f, 0.f, 64.f}) cone.points.push_back({x, x == 0 ? -64.f : 0.f, 0});
    for (const float x : {-32.f, 0.f, 32.f}) cone.points.push_back({x, x == 0 ? -32.f : 0.f, 64});
    cone.points.insert(cone.points.end(), 3, vec3(0, 0, 128));
    const PatchTriangles cut = cut_alone(cone, 0.1);
    EXPECT_GT(cut.triangles.size(), 5u);
    for (const auto& [a, b, c] : cut.triangles) {
        EXPECT_GT(glm::length(glm::cross(cut.points[b] - cut.points[a], cut.points[c] - cut.points[a])), 0);
    }
}

/// Around the shared curve, one patch bends a lot and the other a little; the other is told from any of its corners.
TEST(Quake3Patch, neighbours_meet_without_a_crack_however_they_are_turned) {
    const auto left = height_patch({0, 0, 0.1f, 300, 0, 40.7f, 0, 0, 3.3f});
    for (int turn = 0; turn < 4; ++turn) {
        Patch right{.width = 3, .height = 5, .points = {}};
        for (std::size_t row = 0; row < 5; ++row) {
            for (std::size_t column = 0; column < 3; ++column) {
                right.points.push_back(row < 3 && column == 0 ? left.at(2, row)
                                                              : vec3(64.f + 32.f * static_cast<float>(column),
                                                                     32.f * static_cast<float>(row), 1));
            }
        }
        if (turn % 2 == 1) {  // the other end first, in both directions
            std::ranges::reverse(right.points);
        }
        if (turn / 2 == 1) {  // rows for columns
            Patch turned{.width = right.height, .height = right.width, .points = {}};
            for (std::size_t column = 0; column < right.width; ++column) {
                for (std::size_t row = 0; row < right.height; ++row) turned.points.push_back(right.at(column, row));
            }
            right = turned;
        }
        PatchCutter cutter(0.25);
        ASSERT_TRUE(cutter.add(right));
        ASSERT_TRUE(cutter.add(left));
        cutter.settle();
        std::map<std::pair<Place, Place>, int> edges;
        for (const PatchTriangles& cut : {cutter.cut(0, right), cutter.cut(1, left)}) {
            for (const auto& t : cut.triangles) {
                for (std::size_t i = 0; i < 3; ++i) {
                    const auto edge = std::minmax({place(cut.points[t[i]]), place(cut.points[t[(i + 1) % 3]])});
                    ++edges[{edge.first, edge.second}];
                }
            }
        }
        int shared = 0;
        for (const auto& [edge, n] : edges) {
            const bool on_seam =
                edge.first[0] == 64 && edge.second[0] == 64 && edge.first[1] <= 64 && edge.second[1] <= 64;
            if (on_seam) {
                EXPECT_EQ(n, 2) << "turn " << turn << ", at y = " << edge.first[1];
            }
            shared += on_seam;
        }
        EXPECT_GT(shared, 8);
    }
}

TEST(Quake3Patch, a_curve_that_needs_too_many_pieces_is_refused) {
    PatchCutter cutter(1e-9);
    EXPECT_FALSE(cutter.add(height_patch({0, 32, 0, 0, 32, 0, 0, 32, 0})));
    PatchCutter huge(1e-3);
    EXPECT_FALSE(huge.add(height_patch({0, 3e38f, 0, 0, -3e38f, 0, 0, 3e38f, 0})));
}

Plane plane(const dvec3& normal, double distance) {
    return {.normal = normal, .distance = distance};
}

Triangles fans_of(const BrushShape& shape) {
    Triangles triangles;
    for (const BrushPolygon& polygon : shape.polygons) {
        for (std::size_t i = 1; i + 1 < polygon.corners.size(); ++i)
            triangles.push_back({polygon.corners[0], polygon.corners[i], polygon.corners[i + 1]});
    }
    return triangles;
}

double volume_of(const BrushShape& shape) {
    double volume = 0;
    for (const auto& [a, b, c] : fans_of(shape))
        volume += glm::dot(shape.corners[a], glm::cross(shape.corners[b], shape.corners[c])) / 6;
    return volume;
}

const std::vector<Plane> unit_box{plane({-1, 0, 0}, 0), plane({1, 0, 0}, 64), plane({0, -1, 0}, 0),
                                  plane({0, 1, 0}, 32), plane({0, 0, -1}, 0), plane({0, 0, 1}, 16)};

void expect_closed(const BrushShape& shape) {
    ASSERT_EQ(shape.state, BrushShape::State::solid);
    Edges edges;
    for (const BrushPolygon& polygon : shape.polygons) {
        for (std::size_t i = 0; i < polygon.corners.size(); ++i) {
            const std::uint32_t next = polygon.corners[(i + 1) % polygon.corners.size()];
            ++edges[{place(shape.corners[polygon.corners[i]]), place(shape.corners[next])}];
        }
    }
    EXPECT_TRUE(open_edges(edges).empty());
}

TEST(Quake3Brush, a_box_is_closed_and_outside_out) {
    const BrushShape shape = shape_of(unit_box);
    expect_closed(shape);
    EXPECT_EQ(shape.polygons.size(), 6u);
    EXPECT_EQ(shape.corners.size(), 8u);
    EXPECT_DOUBLE_EQ(volume_of(shape), 64 * 32 * 16);
}

TEST(Quake3Brush, bevels_and_repeated_planes_change_nothing) {
    std::vector<Plane> planes = unit_box;
    planes.push_back(plane({1, 0, 0}, 64));
    planes.push_back(plane({std::sqrt(0.5), 0, std::sqrt(0.5)}, 80 * std::sqrt(0.5)));  // through the upper edge
    const BrushShape shape = shape_of(planes);
    expect_closed(shape);
    EXPECT_EQ(shape.polygons.size(), 6u);
    EXPECT_NEAR(volume_of(shape), 64 * 32 * 16, 1e-6);
}

TEST(Quake3Brush, random_brushes_are_closed_and_hold_exactly_what_is_behind_their_planes) {
    tests::SplitMix random(7);
    const auto number = [&] { return random.in(-1, 1); };
    for (int round = 0; round < 300; ++round) {
        const dvec3 middle(3000 * number(), 3000 * number(), 3000 * number());
        std::vector<Plane> planes;
        for (int axis = 0; axis < 3; ++axis) {
            for (const double sign : {-1.0, 1.0}) {
                dvec3 normal(0);
                normal[axis] = sign;
                planes.push_back(plane(normal, static_cast<double>(static_cast<float>(sign * middle[axis] + 100))));
            }
        }
        for (int i = 0; i < round % 12; ++i) {
            // Normals and distances as floats, as a file has them.
            const vec3 normal(glm::normalize(dvec3(number(), number(), number())));
            const dvec3 wide(normal);
            planes.push_back(
                plane(wide, static_cast<double>(static_cast<float>(glm::dot(wide, middle) + 60 + 30 * number()))));
        }
        const BrushShape shape = shape_of(planes);
        expect_closed(shape);
        EXPECT_GT(volume_of(shape), 1000);
        for (const dvec3& corner : shape.corners) {
            int touched = 0;
            for (const Plane& p : planes) {
                const double height = glm::dot(p.normal, corner) - p.distance;
                EXPECT_LT(height, 0.05);
                touched += std::abs(height) < 0.05;
            }
            EXPECT_GE(touched, 3);
        }
    }
}

TEST(Quake3Brush, what_is_empty_flat_or_open_is_told_apart) {
    std::vector<Plane> empty = unit_box;
    empty.push_back(plane({1, 0, 0}, -1));
    EXPECT_EQ(shape_of(empty).state, BrushShape::State::empty);
    std::vector<Plane> sheet = unit_box;
    sheet.push_back(plane({1, 0, 0}, 0));
    EXPECT_EQ(shape_of(sheet).state, BrushShape::State::empty);
    EXPECT_EQ(shape_of({}).state, BrushShape::State::empty);
    const std::vector<Plane> open(unit_box.begin(), unit_box.begin() + 5);
    EXPECT_EQ(shape_of(open).state, BrushShape::State::unbounded);
    std::vector<Plane> far = unit_box;
    far[1].distance = 1e30;
    EXPECT_EQ(shape_of(far).state, BrushShape::State::unbounded);
    EXPECT_EQ(shape_of(std::vector<Plane>(max_brush_sides + 1, unit_box[0])).state, BrushShape::State::too_large);
}

}  // namespace
}  // namespace surefoot::internal::quake3
