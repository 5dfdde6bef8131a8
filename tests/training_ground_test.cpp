// The project's own level is what levels/README.md says it is.
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <set>
#include <string>
#include <tuple>

#include <surefoot/import.hpp>

namespace surefoot {
namespace {

dvec3 cross_product(const dvec3& a, const dvec3& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

double dot_product(const dvec3& a, const dvec3& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

double length_of(const dvec3& v) {
    return std::sqrt(dot_product(v, v));
}

class TrainingGround : public testing::Test {
protected:
    static void SetUpTestSuite() {
        auto read = import_level(SUREFOOT_LEVELS_DIR "/training-ground.glb");
        ASSERT_TRUE(read.has_value()) << read.error().text;
        level = std::move(*read);
    }

    static const ImportedPart* part(const std::string& name) {
        const auto found = std::ranges::find(level.parts, name, &ImportedPart::name);
        return found != level.parts.end() ? &*found : nullptr;
    }

    static Triangle triangle(std::uint32_t id) {
        const auto corner = [&](std::uint32_t k) { return dvec3(level.vertices[level.indices[3 * id + k]]); };
        return {corner(0), corner(1), corner(2)};
    }

    static dvec3 normal(const Triangle& t) { return cross_product(t.b - t.a, t.c - t.a); }

    /// Requires: the part exists.
    template <typename Visit>
    static void each_triangle(const std::string& name, Visit visit) {
        const ImportedPart* const found = part(name);
        ASSERT_NE(found, nullptr) << name;
        for (std::uint32_t i = 0; i < found->triangle_count; ++i) visit(triangle(found->first_triangle + i));
    }

    static double top_of(const std::string& name) {
        double top = -1e9;
        each_triangle(name, [&](const Triangle& t) { top = std::max({top, t.a.y, t.b.y, t.c.y}); });
        return top;
    }

    static inline ImportedLevel level;
};

TEST_F(TrainingGround, has_everything_that_trips_up_a_player) {
    for (const char* const name :
         {"ground", "hills", "columns", "terrace west", "terrace east", "bridge", "beam", "ledge",
          "ledge without thickness", "thin walls without thickness", "thin walls of a centimetre", "dome",
          "low ceiling 1.9", "low ceiling 1.7", "low ceiling 1.2", "crevice"}) {
        EXPECT_NE(part(name), nullptr) << name;
    }
    for (int i = 1; i <= 6; ++i) EXPECT_NE(part("stairs 0." + std::to_string(i)), nullptr) << i;
    for (int angle = 10; angle <= 80; angle += 10) EXPECT_NE(part("ramp " + std::to_string(angle)), nullptr) << angle;
    for (int angle = 10; angle <= 170; angle += 20) {
        EXPECT_NE(part("outer corner " + std::to_string(angle)), nullptr) << angle;
        EXPECT_NE(part("inner corner " + std::to_string(angle)), nullptr) << angle;
    }
    EXPECT_GE(level.triangle_count(), 5'000u);
    EXPECT_LE(level.triangle_count(), 30'000u);
}

TEST_F(TrainingGround, names_its_surfaces) {
    for (const char* const name : {"grass", "sand", "stone", "rock", "wood", "ice", "metal", "plaster"}) {
        const auto found = std::ranges::find(level.surface_names, name);
        ASSERT_NE(found, level.surface_names.end()) << name;
        const auto& extras = level.surface_extras[static_cast<std::size_t>(found - level.surface_names.begin())];
        EXPECT_NE(extras.find("friction"), std::string::npos) << name;
    }
}

TEST_F(TrainingGround, has_a_spawn_a_goal_and_a_tour_in_order) {
    std::vector<const ImportedMarker*> tour;
    for (const ImportedMarker& marker : level.markers) {
        if (marker.kind == "waypoint") tour.push_back(&marker);
    }
    ASSERT_GE(tour.size(), 10u);
    for (std::size_t i = 0; i < tour.size(); ++i) {
        EXPECT_NE(tour[i]->extras.find("\"order\":" + std::to_string(i) + "}"), std::string::npos) << tour[i]->extras;
    }
    EXPECT_EQ(std::ranges::count(level.markers, "spawn", &ImportedMarker::kind), 1);
    EXPECT_EQ(std::ranges::count(level.markers, "goal", &ImportedMarker::kind), 1);
    EXPECT_NEAR(std::ranges::find(level.markers, "goal", &ImportedMarker::kind)->position.y, 4.5, 1e-6);
}

TEST_F(TrainingGround, floors_face_up) {
    each_triangle("ground", [](const Triangle& t) {
        EXPECT_GT(normal(t).y, 0);
        EXPECT_EQ(t.a.y, 0);
    });
    each_triangle("hills", [](const Triangle& t) { EXPECT_GT(normal(t).y, 0); });
    double up = 0;
    each_triangle("terrace west", [&](const Triangle& t) {
        const dvec3 n = normal(t);
        EXPECT_GE(n.y, 0);
        up += n.y / 2;
    });
    EXPECT_NEAR(up, 16.0 * 6.0, 1e-3);
}

TEST_F(TrainingGround, solids_face_outwards) {
    each_triangle("dome", [](const Triangle& t) { EXPECT_GT(dot_product(normal(t), t.a - dvec3(0, 0, -19)), 0); });
    for (int angle = 10; angle <= 170; angle += 20) {
        const std::string name = "outer corner " + std::to_string(angle);
        dvec3 middle(0);
        double corners = 0;
        each_triangle(name, [&](const Triangle& t) {
            middle += t.a + t.b + t.c;
            corners += 3;
        });
        middle /= corners;
        each_triangle(name, [&](const Triangle& t) { EXPECT_GT(dot_product(normal(t), t.a - middle), 0) << name; });
    }
}

TEST_F(TrainingGround, ramps_have_the_slope_that_their_names_say) {
    for (int angle = 10; angle <= 80; angle += 10) {
        bool seen = false;
        each_triangle("ramp " + std::to_string(angle), [&](const Triangle& t) {
            const dvec3 n = normal(t);
            if (n.y <= 0.01 * length_of(n)) return;
            seen = true;
            const double slope = std::atan2(std::hypot(n.x, n.z), n.y) * 180 / 3.14159265358979323846;
            // A sliver a millimetre wide, of float corners at ten metres, is off by up to a fraction of a degree.
            EXPECT_NEAR(slope, angle, 0.2);
        });
        EXPECT_TRUE(seen) << angle;
    }
}

TEST_F(TrainingGround, stairs_reach_the_terrace) {
    for (int i = 1; i <= 6; ++i) {
        EXPECT_NEAR(top_of("stairs 0." + std::to_string(i)), i == 5 ? 2.5 : 2.4, 1e-6) << i;
    }
}

TEST_F(TrainingGround, the_ground_is_cut_badly) {
    using Place = std::tuple<double, double>;
    std::set<Place> corners;
    int slivers = 0;
    each_triangle("ground", [&](const Triangle& t) {
        double longest = 0;
        for (const auto& [p, q] : {std::pair{t.a, t.b}, std::pair{t.b, t.c}, std::pair{t.c, t.a}}) {
            corners.insert({p.x, p.z});
            longest = std::max(longest, length_of(q - p));
        }
        if (length_of(normal(t)) / longest < 0.002) ++slivers;
    });
    int junctions = 0;
    each_triangle("ground", [&](const Triangle& t) {
        for (const auto& [p, q] : {std::pair{t.a, t.b}, std::pair{t.b, t.c}, std::pair{t.c, t.a}}) {
            junctions += static_cast<int>(corners.count({(p.x + q.x) / 2, (p.z + q.z) / 2}));
        }
    });
    EXPECT_GT(slivers, 100);
    EXPECT_GT(junctions, 100);
}

}  // namespace
}  // namespace surefoot
