// Two hundred characters that want to one place, two threads, and a shot through them.
#include <array>
#include <cstdio>
#include <optional>
#include <thread>
#include <vector>

#include <surefoot/surefoot.hpp>

namespace {

std::optional<surefoot::Mesh> make_floor() {
    const std::array<surefoot::vec3, 4> corners{
        {{-40.0F, 0.0F, -40.0F}, {-40.0F, 0.0F, 40.0F}, {40.0F, 0.0F, 40.0F}, {40.0F, 0.0F, -40.0F}}};
    const std::array<std::uint32_t, 6> indices{0, 1, 2, 0, 2, 3};
    auto mesh = surefoot::Mesh::build({.vertices = corners, .indices = indices});
    if (!mesh) return std::puts(mesh.error().text.c_str()), std::nullopt;
    return *mesh;
}

}  // namespace

int main() {
    const std::optional<surefoot::Mesh> floor = make_floor();
    surefoot::World world;
    if (!floor || !world.add(*floor)) return 1;

    // [crowd]
    const std::size_t count = 200;
    const double dt = 1.0 / 60;
    const surefoot::CharacterSettings settings;  // one for all; or one each
    std::vector<surefoot::CharacterState> states(count);
    std::vector<surefoot::CharacterInput> inputs(count);
    for (std::size_t i = 0; i < count; ++i) {
        states[i].position = {1.5 * static_cast<double>(i % 20) - 15, 1, 1.5 * static_cast<double>(i / 20) - 7};
    }

    surefoot::Crowd crowd;
    if (!crowd.reserve(count)) return 1;  // no memory; later nothing is allocated
    for (int tick = 0; tick < 180; ++tick) {
        for (std::size_t i = 0; i < count; ++i) inputs[i].wish = -0.5 * states[i].position;  // all to the middle
        const surefoot::Characters all{.settings = {&settings, 1}, .inputs = inputs, .before = states, .after = states};
        if (!crowd.gather(all, dt)) return 1;  // where everybody is now
        std::thread other([&] { step_all(world, crowd, all, dt, {0, count / 2}); });
        step_all(world, crowd, all, dt, {count / 2, count});
        other.join();
    }
    // [/crowd]

    double deepest = 0;
    for (std::size_t a = 0; a < count; ++a) {
        for (std::size_t b = 0; b < a; ++b) {
            const auto overlap =
                surefoot::pair_overlap(settings.volume, states[a].position, settings.volume, states[b].position);
            if (overlap && overlap->depth > deepest) deepest = overlap->depth;
        }
    }
    std::printf("after three seconds the deepest of all overlaps is %.4f m\n", deepest);

    // [hitboxes]
    enum Part : std::uint32_t { head, trunk, legs };
    const std::array<surefoot::HitPart, 3> parts{{
        {surefoot::Sphere{0.12}, {.position = {0, 0.75, 0}}, {.position = {0, 0.75, 0}}, head},
        {surefoot::Box{{0.2, 0.3, 0.12}}, {.position = {0, 0.3, 0}}, {.position = {0, 0.3, 0}}, trunk},
        {surefoot::Capsule{0.12, 0.3}, {.position = {0, -0.45, 0}}, {.position = {0, -0.45, 0}}, legs},
    }};
    const surefoot::Pose was{.position = {0, 1, 0}};
    const surefoot::Pose is{.position = {0.1, 1, 0}};  // where the body goes in this tick
    const surefoot::Hitboxes body(parts, was, is);     // for this tick; copies and allocates nothing
    const auto hit = body.ray({.from = {0, 1.75, -20}, .to = {0, 1.75, 20}});
    if (hit) std::printf("%s at z = %.2f\n", hit->number == head ? "head" : "body", hit->point.z);
    const bool over_the_shoulder = !body.ray({.from = {0.25, 1.7, -20}, .to = {0.25, 1.7, 20}});
    std::printf("over the shoulder it %s\n", over_the_shoulder ? "misses" : "hits");
    // [/hitboxes]
    return hit && over_the_shoulder && deepest <= 2 * 10 * dt ? 0 : 1;
}
