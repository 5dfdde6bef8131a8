// Queries allocate nothing: every form of operator new is replaced by one that counts.
#include <cstdlib>
#include <gtest/gtest.h>
#include <new>
#include <vector>

#include <surefoot/surefoot.hpp>

#include "golden/queries.hpp"

namespace {

std::size_t allocations = 0;

void* count_and_allocate(std::size_t size) {
    ++allocations;
    void* memory = std::malloc(size == 0 ? 1 : size);
    if (memory == nullptr) std::abort();
    return memory;
}

}  // namespace

void* operator new(std::size_t size) {
    return count_and_allocate(size);
}
void* operator new[](std::size_t size) {
    return count_and_allocate(size);
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
    return count_and_allocate(size);
}
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept {
    return count_and_allocate(size);
}
void operator delete(void* memory) noexcept {
    std::free(memory);
}
void operator delete[](void* memory) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}
void operator delete[](void* memory, std::size_t) noexcept {
    std::free(memory);
}

namespace {

TEST(Allocation, the_counter_counts) {
    const std::size_t before = allocations;
    const std::vector<int> one(1);
    EXPECT_GT(allocations, before);
}

TEST(Allocation, building_a_mesh_allocates_and_asking_it_does_not) {
    golden::Queries queries(1);
    std::vector<surefoot::vec3> vertices;
    std::vector<std::uint32_t> indices;
    for (std::uint32_t i = 0; i < 300; ++i) {
        const surefoot::dvec3 corner = queries.position();
        vertices.emplace_back(corner);
        indices.push_back(i);
    }
    const std::size_t before_building = allocations;
    const auto mesh = surefoot::Mesh::build({.vertices = vertices, .indices = indices});
    ASSERT_TRUE(mesh);
    EXPECT_GT(allocations, before_building);

    const std::size_t before = allocations;
    std::size_t hits = 0;
    for (int i = 0; i < 600; ++i) {
        const surefoot::Volume volume = queries.volume(static_cast<std::size_t>(i) % 6);
        const surefoot::Motion motion = queries.motion();
        std::array<surefoot::Overlap, 4> found;
        hits += mesh->sweep(volume, motion).has_value();
        hits += mesh->ray(motion).has_value();
        hits += mesh->overlap(volume, motion.from, found);
    }
    EXPECT_EQ(allocations, before);
    EXPECT_GT(hits, 100u);
}

TEST(Allocation, bodies_allocate_when_they_are_added_and_then_no_more) {
    golden::Queries queries(4);
    std::vector<surefoot::vec3> vertices;
    std::vector<std::uint32_t> indices;
    for (std::uint32_t i = 0; i < 90; ++i) {
        vertices.emplace_back(queries.position());
        indices.push_back(i);
    }
    const auto mesh = surefoot::Mesh::build({.vertices = vertices, .indices = indices});
    ASSERT_TRUE(mesh);
    surefoot::World world;
    std::vector<surefoot::BodyHandle> bodies;
    for (std::uint32_t i = 0; i < 30; ++i) {
        const auto added = world.add(*mesh, {.pose = {queries.position(), queries.orientation()}, .body = i});
        ASSERT_TRUE(added);
        bodies.push_back(*added);
    }
    std::array<surefoot::BodyPose, 30> saved;
    std::array<surefoot::Overlap, 4> found;
    std::array<surefoot::SourceTriangle, 4> near;
    std::size_t hits = 0;
    bool moved = true;

    const std::size_t before = allocations;
    world.save_poses(saved);
    for (int i = 0; i < 300; ++i) {
        const surefoot::BodyHandle body = bodies[static_cast<std::size_t>(i) % bodies.size()];
        moved = moved && world.move(body, {queries.position(), queries.orientation()});
        const surefoot::Volume volume = queries.volume(static_cast<std::size_t>(i) % 6);
        const surefoot::Motion motion = queries.motion();
        hits += world.sweep(volume, motion, {.turn_gap = 0.1}).has_value();
        hits += world.sweep_any(volume, motion, {.turn_gap = 0.1});
        hits += world.ray(motion).has_value();
        hits += world.overlap(volume, motion.from, found);
        hits += world.nearest(motion.from, 1).has_value();
        hits += world.gather({motion.from, motion.from}, near);
        if (i % 10 == 0) world.begin_tick();
    }
    const bool restored = world.restore_poses(saved);
    const bool removed = world.remove(bodies[3]);
    EXPECT_EQ(allocations, before);
    EXPECT_TRUE(moved && restored && removed);
    EXPECT_GT(hits, 300u);
}

TEST(Allocation, height_fields_allocate_when_built_and_then_no_more_and_voxels_never) {
    golden::Queries queries(5);
    const std::vector<std::uint16_t> levels(32 * 32, std::uint16_t{1});
    auto field = surefoot::HeightField::build({.columns = 32, .rows = 32, .levels = levels, .origin = {-16, 0, -16}});
    ASSERT_TRUE(field);

    const std::size_t before = allocations;
    const auto ground = [](std::int32_t, std::int32_t y, std::int32_t) { return y < 2; };
    const auto voxels = surefoot::Voxels::over(ground, {.cells = {32, 4, 32}, .origin = {-16, -1, -16}});
    ASSERT_TRUE(voxels);
    std::size_t hits = 0;
    for (int i = 0; i < 300; ++i) {
        const surefoot::Volume volume = queries.volume(static_cast<std::size_t>(i) % 6);
        const surefoot::Motion motion = queries.motion();
        std::array<surefoot::Overlap, 4> found;
        std::array<surefoot::SourceTriangle, 4> near;
        for (const surefoot::SourceView source : {surefoot::SourceView(*field), surefoot::SourceView(*voxels)}) {
            hits += source.sweep(volume, motion).has_value();
            hits += source.ray(motion).has_value();
            hits += source.overlap(volume, motion.from, found);
            hits += source.nearest(motion.from, 10).has_value();
            hits += source.gather({{-2, -2, -2}, {2, 2, 2}}, near);
        }
        hits += surefoot::move_axis_by_axis(*voxels, {}, {0, 5, 0}, motion.to).y.blocked;
        hits += field->set({.columns = 1, .rows = 1, .levels = {levels.data(), 1}}).has_value();
    }
    EXPECT_EQ(allocations, before);
    EXPECT_GT(hits, 1000u);
}

TEST(Allocation, no_query_against_one_triangle_or_shape_allocates) {
    golden::Queries queries(2);
    const std::size_t before = allocations;
    std::size_t hits = 0;
    for (int i = 0; i < 3000; ++i) {
        queries.next_family();
        const surefoot::Volume volume = queries.volume(static_cast<std::size_t>(i) % 6);
        const surefoot::Motion motion = queries.motion();
        const surefoot::Triangle triangle = queries.triangle();
        const surefoot::JumpArc arc{.from = motion.from, .velocity = motion.to};
        hits += surefoot::sweep(volume, motion, triangle).has_value();
        hits += surefoot::ray(motion, triangle).has_value();
        hits += surefoot::overlap(volume, motion.from, triangle).has_value();
        hits += surefoot::march(volume, arc, triangle, {.steps = 4}).has_value();
        const surefoot::Volume other = queries.volume(static_cast<std::size_t>(i) / 6 % 6);
        hits += surefoot::pair_sweep(volume, motion, other, triangle.a).has_value();
        hits += surefoot::pair_overlap(volume, motion.from, other, triangle.a).has_value();
    }
    EXPECT_EQ(allocations, before);
    EXPECT_GT(hits, 500u);
}

TEST(Allocation, a_crowd_allocates_when_it_is_reserved_and_never_again_and_hitboxes_never) {
    using namespace surefoot;
    const vec3 corners[] = {{-20, 0, -20}, {-20, 0, 20}, {20, 0, 20}, {20, 0, -20}};
    const std::uint32_t indices[] = {0, 1, 2, 0, 2, 3};
    const auto mesh = Mesh::build({.vertices = corners, .indices = indices});
    ASSERT_TRUE(mesh);
    World world;
    ASSERT_TRUE(world.add(*mesh));
    const Shape shapes[] = {Ellipsoid{}, Capsule{}, Box{}, Sphere{}, Cylinder{}, Cone{}};
    std::vector<CharacterSettings> settings(60);
    std::vector<CharacterState> states(60);
    for (std::size_t i = 0; i < states.size(); ++i) {
        settings[i].volume = Volume(shapes[i % 6]);
        states[i].position = {0.7 * static_cast<double>(i % 8), 1, 0.7 * static_cast<double>(i / 8)};
    }
    const CharacterInput input{.wish = {2, 0, 1}};
    const Characters all{.settings = settings, .inputs = {&input, 1}, .before = states, .after = states};
    Crowd crowd;
    const std::size_t before_reserving = allocations;
    ASSERT_TRUE(crowd.reserve(60));
    EXPECT_GT(allocations, before_reserving);
    const std::size_t before = allocations;
    bool gathered = true;
    std::size_t hits = 0;
    const HitPart parts[] = {{Sphere{0.2}, {.position = {0, 0.5, 0}}, {.position = {0.3, 0.5, 0}}, 1},
                             {Box{}, {.orientation = {1, 0, 0, 0}}, {.orientation = {1, 0.2, 0, 0}}, 2}};
    for (int tick = 0; tick < 30; ++tick) {
        gathered = gathered && crowd.gather(all, 0.02);
        step_all(world, crowd, all, 0.02);
        const Hitboxes body(parts, {.position = states[0].position});
        hits += body.ray({.from = {-9, 1, 0}, .to = {9, 1, 1}}).has_value();
        hits += body.sweep(Sphere{0.3}, {.from = {-9, 1, 0}, .to = {9, 1, 1}}).has_value();
    }
    EXPECT_EQ(allocations, before);
    EXPECT_TRUE(gathered);
    EXPECT_GT(hits, 0U);
}

}  // namespace
