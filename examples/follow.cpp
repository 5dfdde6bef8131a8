// Sends characters over a navigation mesh: one along a path, many among each other, and many down a field.
#include <array>
#include <cstdio>
#include <vector>

#include <surefoot/navigation_crowd.hpp>
#include <surefoot/navigation_field.hpp>
#include <surefoot/navigation_follow.hpp>
#include <surefoot/navigation_links.hpp>
#include <surefoot/navigation_query.hpp>
#include <surefoot/surefoot.hpp>

namespace {

using surefoot::dvec3;

/// A floor of 20 by 20 m and a wall across it, which leaves a way at one end.
surefoot::Mesh level() {
    const std::array<surefoot::vec3, 8> corners{
        {{-10, 0, -10}, {-10, 0, 10}, {10, 0, 10}, {10, 0, -10}, {0, 0, -10}, {0, 0, 6}, {0, 3, 6}, {0, 3, -10}}};
    const std::array<std::uint32_t, 12> triangles{0, 1, 2, 0, 2, 3, 4, 5, 6, 4, 6, 7};
    return *surefoot::Mesh::build({.vertices = corners, .indices = triangles});
}

bool one(const surefoot::World& world, const surefoot::CharacterSettings& settings,
         const surefoot::NavigationMesh& mesh) {
    const double dt = 1.0 / 60;
    surefoot::CharacterState state{.position = {-5, mesh.agent().feet, -8}};
    // [follow]
    const surefoot::NavigationQuery query(mesh);
    surefoot::NavigationFollower follower;
    follower.go(query, {5, 0, -8});
    while (follower.status() == surefoot::NavigationFollowStatus::following) {
        const surefoot::CharacterInput input = follower.input(query, state, settings, dt);
        state = surefoot::step(world, settings, input, dt, state).state;
    }
    if (follower.status() == surefoot::NavigationFollowStatus::gave_up)
        std::printf("%s\n", surefoot::sentence(follower.reason()).data());
    // [/follow]
    return follower.status() == surefoot::NavigationFollowStatus::arrived;
}

bool many(const surefoot::World& world, const surefoot::CharacterSettings& settings,
          const surefoot::NavigationMesh& mesh) {
    const double dt = 1.0 / 60;
    constexpr std::size_t count = 12;
    std::vector<surefoot::CharacterState> states(count);
    std::vector<surefoot::CharacterInput> inputs(count);
    for (std::size_t i = 0; i < count; ++i)
        states[i].position = {-9 + 1.5 * static_cast<double>(i % 4), mesh.agent().feet, -8 + 2.0 * double(i / 4)};
    // [crowd]
    surefoot::NavigationCrowdWorker worker(mesh);
    surefoot::NavigationCrowd crowd(mesh, count);
    surefoot::Crowd feet;
    for (std::size_t i = 0; i < count; ++i) crowd.go(worker.query(), i, {5, 0, -8});
    for (int tick = 0; tick < 900; ++tick) {
        if (!crowd.gather(states)) return false;
        crowd.steer(worker, settings, dt, inputs);
        const surefoot::Characters all{.settings = {&settings, 1}, .inputs = inputs, .before = states, .after = states};
        if (!feet.gather(all, dt)) return false;
        surefoot::step_all(world, feet, all, dt);
    }
    // [/crowd]
    for (std::size_t i = 0; i < count; ++i)
        if (crowd.follower(i).status() != surefoot::NavigationFollowStatus::arrived) return false;
    return true;
}

bool down(const surefoot::World& world, const surefoot::CharacterSettings& settings,
          const surefoot::NavigationMesh& mesh) {
    const double dt = 1.0 / 60;
    const surefoot::NavigationQuery query(mesh);
    surefoot::CharacterState state{.position = {-5, mesh.agent().feet, -8}};
    surefoot::NavigationFollower follower;
    // [field]
    const auto goal = query.nearest({5, 0, -8}, 1, 1);
    const auto field = surefoot::NavigationField::make(query, *goal);
    follower.go(query, *field);  // and so may a thousand others
    // [/field]
    while (follower.status() == surefoot::NavigationFollowStatus::following)
        state = surefoot::step(world, settings, follower.input(query, state, settings, dt), dt, state).state;
    return follower.status() == surefoot::NavigationFollowStatus::arrived;
}

}  // namespace

int main() {
    surefoot::World world;
    const surefoot::CharacterSettings settings{};
    if (!world.add(level())) return 1;
    // [navigation]
    auto mesh = surefoot::NavigationMesh::build(world, settings);  // or ::open("castle.surefoot")
    if (!mesh || !mesh->set_links(surefoot::find_links(world, settings, *mesh))) return 1;
    const surefoot::NavigationQuery ask(*mesh);
    const auto here = ask.under({-5, 0.5, -8}, 2, 1);
    const auto there = ask.nearest({5, 0, -8}, 1, 1);
    const auto path = here && there ? ask.path(*here, *there) : std::nullopt;
    if (path) std::printf("%.1f m, %zu bends\n", path->length, path->corners.size() - 2);
    // [/navigation]
    const bool all =
        path && one(world, settings, *mesh) && many(world, settings, *mesh) && down(world, settings, *mesh);
    std::printf("%s\n", all ? "all arrived" : "somebody did not arrive");
    return all ? 0 : 1;
}
