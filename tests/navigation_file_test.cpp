// A navigation mesh in a file: what comes back, and what is refused.
#include <cstring>

#include "file_things.hpp"
#include "navigation_scene.hpp"
#include "splitmix.hpp"

namespace surefoot::tests {
namespace {

std::vector<NavigationPath> paths_of(const NavigationMesh& mesh) {
    const NavigationQuery query(mesh);
    std::vector<NavigationPath> paths;
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
        const auto from = query.random(2 * seed);
        const auto to = query.random(2 * seed + 1);
        if (!from || !to) continue;
        if (auto path = query.path(*from, *to)) paths.push_back(*std::move(path));
    }
    return paths;
}

void expect_same(const NavigationMesh& mesh, const NavigationMesh& other) {
    EXPECT_EQ(shapes_of(mesh), shapes_of(other));
    ASSERT_EQ(mesh.links().size(), other.links().size());
    for (std::size_t i = 0; i < mesh.links().size(); ++i) {
        const NavigationLink& a = mesh.links()[i];
        const NavigationLink& b = other.links()[i];
        EXPECT_EQ(a.from, b.from);
        EXPECT_EQ(a.to, b.to);
        EXPECT_EQ(a.takeoff, b.takeoff);
        EXPECT_EQ(a.kind, b.kind);
        EXPECT_EQ(a.seconds, b.seconds);
        EXPECT_EQ(a.tick, b.tick);
        ASSERT_EQ(a.inputs.size(), b.inputs.size());
        for (std::size_t k = 0; k < a.inputs.size(); ++k) {
            EXPECT_EQ(a.inputs[k].wish, b.inputs[k].wish);
            EXPECT_EQ(a.inputs[k].ticks, b.inputs[k].ticks);
            EXPECT_EQ(a.inputs[k].jump, b.inputs[k].jump);
        }
    }
    ASSERT_EQ(mesh.areas().size(), other.areas().size());
    for (std::size_t i = 0; i < mesh.areas().size(); ++i) {
        EXPECT_EQ(mesh.areas()[i].name, other.areas()[i].name);
        EXPECT_EQ(mesh.areas()[i].cost, other.areas()[i].cost);
        EXPECT_EQ(mesh.areas()[i].closed, other.areas()[i].closed);
    }
    EXPECT_EQ(mesh.agent().feet, other.agent().feet);
    EXPECT_EQ(mesh.agent().slope_limit_deg, other.agent().slope_limit_deg);
    const auto paths = paths_of(mesh);
    const auto others = paths_of(other);
    ASSERT_EQ(paths.size(), others.size());
    for (std::size_t i = 0; i < paths.size(); ++i) {
        EXPECT_EQ(paths[i].length, others[i].length);
        EXPECT_EQ(paths[i].midpoints, others[i].midpoints);
        EXPECT_EQ(paths[i].partial, others[i].partial);
    }
}

// Would catch a field that is not written, or written in another order than it is read.
TEST(NavigationFile, WhatWasWrittenComesBackWithItsAreasLinksAndPaths) {
    const NavigationMesh mesh = built_yard();
    const std::vector<std::byte> bytes = mesh.to_bytes();
    const auto back = NavigationMesh::read(bytes);
    ASSERT_TRUE(back.has_value()) << back.error().text;
    expect_same(mesh, *back);
    EXPECT_EQ(back->to_bytes(), bytes) << "and is written as it was";
    ASSERT_TRUE(leads(*back, {5, 2, 5}, {2, 0, 2})) << "the drop is a way";
    const auto path = way(*back, {5, 2, 5}, {2, 0, 2});
    EXPECT_TRUE(std::any_of(path->corners.begin(), path->corners.end(),
                            [](const NavigationCorner& corner) { return corner.link == 0U; }));
}

// Would catch links, salts or free lists of Detour that leak into the bytes.
TEST(NavigationFile, HowManyThreadsBuiltItDoesNotShowInTheBytes) {
    EXPECT_EQ(built_yard(1).to_bytes(), built_yard(2).to_bytes());
}

// Would catch a door that is open in the tiles and shut in the areas.
TEST(NavigationFile, DoorsAndPolygonsTakenOutAreKeptAsTheyAre) {
    NavigationMesh mesh = built_yard();
    ASSERT_TRUE(mesh.set_area(2, false));
    ASSERT_TRUE(mesh.set_area(1, true, 7));
    const NavigationOutline first = outlines_of(mesh).front();
    mesh.take_out(std::span(&first.polygon, 1));
    const auto back = NavigationMesh::read(mesh.to_bytes());
    ASSERT_TRUE(back.has_value()) << back.error().text;
    expect_same(mesh, *back);
    EXPECT_FALSE(back->areas()[2].closed);
    EXPECT_EQ(back->areas()[1].cost, 7);
    EXPECT_TRUE(outlines_of(*back).front().taken_out);
}

using NavigationFileTest = FileTest;

// Would catch a mapping that is shared, a section that loses the triangles, and one that lies where Detour cannot use
// it.
TEST_F(NavigationFileTest, AFileIsMappedAndNeverWrittenInto) {
    const NavigationMesh mesh = built_yard();
    const Mesh level = yard().mesh();
    const std::vector<std::byte> bytes = mesh.to_bytes();
    const std::array<Section, 1> sections{navigation_section(bytes, level.made_from())};
    ASSERT_TRUE(level.write(path("yard.surefoot"), sections).has_value());
    const Bytes before = read_bytes(path("yard.surefoot"));
    {
        auto opened = NavigationMesh::open(path("yard.surefoot"));
        ASSERT_TRUE(opened.has_value()) << opened.error().text;
        expect_same(mesh, *opened);
        ASSERT_TRUE(opened->set_area(1, true));
        NavigationMesh moved = *std::move(opened);
        EXPECT_EQ(shapes_of(moved), shapes_of(mesh));
        const auto again = NavigationMesh::open(path("yard.surefoot"));
        ASSERT_TRUE(again.has_value());
        EXPECT_FALSE(again->areas()[1].closed) << "what one changes is not seen by another";
    }
    EXPECT_EQ(read_bytes(path("yard.surefoot")), before);
    const auto triangles = Mesh::open(path("yard.surefoot"), Check::everything);
    ASSERT_TRUE(triangles.has_value());
    EXPECT_EQ(triangles->triangle_count(), level.triangle_count());
    const auto read = NavigationMesh::read(*triangles);
    ASSERT_TRUE(read.has_value()) << read.error().text;
    expect_same(mesh, *read);
}

// Would catch tiles that are rebuilt over the mapped ones and freed with them.
TEST_F(NavigationFileTest, AMeshThatWasOpenedIsBuiltAnewWhereItsWorldChanges) {
    const NavigationMesh mesh = built(yard().world());
    const Mesh level = yard().mesh();
    const std::vector<std::byte> bytes = mesh.to_bytes();
    const std::array<Section, 1> sections{navigation_section(bytes)};
    ASSERT_TRUE(level.write(path("yard.surefoot"), sections).has_value());
    auto opened = NavigationMesh::open(path("yard.surefoot"));
    ASSERT_TRUE(opened.has_value()) << opened.error().text;
    World world = yard().world();
    const Bounds box{{12, 0, 5}, {13, 2, 9}};
    ASSERT_TRUE(world.add(Scene().block(box.min, box.max).mesh()).has_value());
    const auto count = opened->rebuild(world, {}, quick(), box);
    ASSERT_TRUE(count.has_value()) << count.error().text;
    EXPECT_EQ(shapes_of(*opened), shapes_of(built(world)));
}

TEST_F(NavigationFileTest, WhatIsNoSuchFileSaysWhatToDo) {
    const Mesh level = yard().mesh();
    ASSERT_TRUE(level.write(path("bare.surefoot")).has_value());
    const auto bare = NavigationMesh::open(path("bare.surefoot"));
    ASSERT_FALSE(bare.has_value());
    EXPECT_EQ(bare.error().code, ErrorCode::not_found);
    EXPECT_NE(bare.error().text.find("surefoot nav build"), std::string::npos) << bare.error().text;
    EXPECT_EQ(NavigationMesh::read(level).error().code, ErrorCode::not_found);
    EXPECT_EQ(NavigationMesh::open(path("none.surefoot")).error().code, ErrorCode::not_found);

    const std::vector<std::byte> bytes = built(yard().world()).to_bytes();
    const std::array<Section, 1> stale{navigation_section(bytes, level.made_from() + 1)};
    ASSERT_TRUE(level.write(path("stale.surefoot"), stale).has_value());
    const auto old = NavigationMesh::open(path("stale.surefoot"));
    ASSERT_FALSE(old.has_value());
    EXPECT_NE(old.error().text.find("other triangles"), std::string::npos) << old.error().text;
    EXPECT_EQ(old.error().file, path("stale.surefoot"));
    EXPECT_GT(old.error().byte, 0U);
}

TEST_F(NavigationFileTest, EveryBitThatFlipsInAFileIsNoticed) {
    const Mesh level = yard().mesh();
    const std::vector<std::byte> bytes = built_yard().to_bytes();
    const std::array<Section, 1> sections{navigation_section(bytes)};
    ASSERT_TRUE(level.write(path("yard.surefoot"), sections).has_value());
    Bytes file = read_bytes(path("yard.surefoot"));
    const auto section = std::search(file.begin(), file.end(), bytes.begin(), bytes.end());
    ASSERT_NE(section, file.end());
    SplitMix random(7);
    for (int i = 0; i < 200; ++i) {
        const auto at = section + static_cast<std::ptrdiff_t>(random.next() % bytes.size());
        const auto bit = static_cast<std::byte>(1U << random.next() % 8);
        *at ^= bit;
        write_bytes(path("flipped.surefoot"), file);
        EXPECT_FALSE(NavigationMesh::open(path("flipped.surefoot")).has_value());
        *at ^= bit;
    }
}

/// Asks all that follows an index.
void ask(const NavigationMesh& mesh) {
    const NavigationQuery query(mesh, 512);
    const auto from = query.nearest({2, 0, 2}, 3, 3);
    for (std::uint64_t seed = 0; from && seed < 4; ++seed) {
        const auto to = query.random(seed);
        if (!to) break;
        static_cast<void>(query.path(*from, *to));
        static_cast<void>(query.ray(*from, to->position));
        static_cast<void>(query.under(to->position, 2, 2));
    }
    if (from) static_cast<void>(query.reachable(*from));
    static_cast<void>(outlines_of(mesh));
    static_cast<void>(mesh.report());
}

// Without the checksum, as somebody who wants to harm would do it. Would catch any index that is not looked at.
TEST(NavigationFile, WhicheverBitsFlipInASectionItIsRefusedOrSafe) {
    const std::vector<std::byte> bytes = built_yard().to_bytes();
    SplitMix random(3);
    int refused = 0;
    constexpr int flips = 4000;
    for (int i = 0; i < flips; ++i) {
        std::vector<std::byte> bad = bytes;
        bad[random.next() % bad.size()] ^= static_cast<std::byte>(1U << random.next() % 8);
        const auto mesh = NavigationMesh::read(bad, "yard.surefoot");
        if (mesh) {
            ask(*mesh);
            continue;
        }
        ++refused;
        EXPECT_EQ(mesh.error().file, "yard.surefoot");
        EXPECT_NE(mesh.error().text.find("surefoot nav build"), std::string::npos) << mesh.error().text;
    }
    EXPECT_GT(refused, flips / 3);
}

TEST(NavigationFile, ASectionThatEndsTooSoonIsRefusedWhereverItEnds) {
    const std::vector<std::byte> bytes = built_yard().to_bytes();
    for (std::size_t size = 0; size < bytes.size(); size += size < 600 ? 1 : 97) {
        EXPECT_FALSE(NavigationMesh::read(std::span(bytes).first(size)).has_value()) << size;
        // And when it says so itself.
        std::vector<std::byte> shorter(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size));
        const std::uint64_t says = size;
        if (size >= 24) std::memcpy(shorter.data() + 16, &says, sizeof says);
        EXPECT_FALSE(NavigationMesh::read(shorter).has_value()) << size;
    }
}

}  // namespace
}  // namespace surefoot::tests
