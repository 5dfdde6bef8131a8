#include <gtest/gtest.h>
#include <string>
#include <string_view>

#include <surefoot/debug_draw.hpp>

namespace {

using surefoot::DebugColour;
using surefoot::DebugDraw;
using surefoot::dvec3;

struct Notebook {
    std::string words;

    void line(const dvec3& from, const dvec3& to, const DebugColour& colour) {
        words += "line " + std::to_string(int(from.x)) + std::to_string(int(to.x)) + std::to_string(colour.r) + "; ";
    }
    void triangle(const dvec3& a, const dvec3& b, const dvec3& c, const DebugColour&) {
        words += "triangle " + std::to_string(int(a.x)) + std::to_string(int(b.x)) + std::to_string(int(c.x)) + "; ";
    }
    void text(const dvec3& place, std::string_view said, const DebugColour& colour) {
        words += "text " + std::to_string(int(place.x)) + std::string(said) + std::to_string(colour.a) + "; ";
    }
};

TEST(DebugDraw, hands_everything_to_its_sink_in_the_order_of_drawing) {
    Notebook notebook;
    const DebugDraw draw(notebook);
    draw.text({4, 0, 0}, "here", {1, 2, 3, 9});
    draw.line({1, 0, 0}, {2, 0, 0}, {7, 0, 0});
    draw.triangle({1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {});
    EXPECT_EQ(notebook.words, "text 4here9; line 127; triangle 123; ");
}

TEST(DebugDraw, made_of_nothing_swallows_everything_and_says_so) {
    const DebugDraw nobody;
    nobody.line({}, {}, {});
    nobody.triangle({}, {}, {}, {});
    nobody.text({}, "unheard", {});
    EXPECT_FALSE(nobody);
    Notebook notebook;
    EXPECT_TRUE(DebugDraw(notebook));
}

TEST(DebugDraw, copies_draw_into_the_same_sink) {
    Notebook notebook;
    const DebugDraw first(notebook);
    const DebugDraw second = first;
    second.line({1, 0, 0}, {2, 0, 0}, {7, 0, 0});
    EXPECT_EQ(notebook.words, "line 127; ");
}

}  // namespace
