// Crowds for tests: many characters in one level, stepped all at once.
#pragma once

#include <thread>
#include <vector>

#include "movement_scene.hpp"
#include "splitmix.hpp"

namespace surefoot::tests {

struct Many {
    std::vector<CharacterSettings> settings;
    std::vector<CharacterInput> inputs;
    std::vector<CharacterState> states;
    std::vector<CharacterEvents> events;
    std::vector<std::uint32_t> ids;
    Crowd crowd;
    double dt = 1.0 / 60;

    void add(const dvec3& position, const dvec3& wish = {0, 0, 0}, const CharacterSettings& setting = {}) {
        settings.push_back(setting);
        inputs.push_back({.wish = wish});
        states.push_back({.position = position});
        ids.push_back(static_cast<std::uint32_t>(ids.size()));
        events.resize(states.size());
    }
    [[nodiscard]] Characters all(std::vector<CharacterState>& after) {
        return {.settings = settings, .inputs = inputs, .before = states, .after = after, .events = events, .ids = ids};
    }
    /// One tick, the work shared by so many threads.
    void tick(const World& world, std::size_t threads = 1) {
        std::vector<CharacterState> after(states.size());
        const Characters characters = all(after);
        ASSERT_TRUE(crowd.gather(characters, dt));
        std::vector<std::thread> workers;
        for (std::size_t k = 1; k < threads; ++k) {
            workers.emplace_back([&, k] { step_all(world, crowd, characters, dt, part(k, threads)); });
        }
        step_all(world, crowd, characters, dt, part(0, threads));
        for (std::thread& worker : workers) worker.join();
        states = after;
    }
    void run(const World& world, double seconds) {
        for (int i = 0, ticks = static_cast<int>(std::lround(seconds / dt)); i < ticks; ++i) tick(world);
    }
    [[nodiscard]] StepRange part(std::size_t k, std::size_t parts) const {
        return {states.size() * k / parts, states.size() * (k + 1) / parts};
    }
    /// How deep two are in each other, or 0.
    [[nodiscard]] double overlap(std::size_t a, std::size_t b) const {
        const auto found = pair_overlap(settings[a].volume, states[a].position, settings[b].volume, states[b].position);
        return found ? found->depth : 0;
    }
    [[nodiscard]] double deepest_overlap() const {
        double deepest = 0;
        for (std::size_t a = 0; a < states.size(); ++a) {
            for (std::size_t b = 0; b < a; ++b) {
                const dvec3 between = states[a].position - states[b].position;
                if (glm::dot(between, between) < 4) deepest = std::max(deepest, overlap(a, b));
            }
        }
        return deepest;
    }
};

/// Characters of all shapes in a yard with a wall across it, in no order, that want in all directions.
inline Many jostling(std::size_t count, double half_width, std::uint64_t seed) {
    Many many;
    SplitMix random(seed);
    const Volume volumes[] = {Ellipsoid{{0.4, 0.9, 0.4}}, Capsule{0.4, 0.5}, Cylinder{0.4, 0.9},
                              Box{{0.35, 0.9, 0.35}},     Sphere{0.5},       Cone{0.4, 1.8}};
    for (std::size_t i = 0; i < count; ++i) {
        CharacterSettings settings;
        settings.volume = volumes[i % 7 < 6 ? i % 7 : 0];
        settings.firmness = i % 5 == 0 ? Firmness::soft : Firmness::hard;
        const dvec3 place = random.point(half_width);
        many.add({place.x, std::holds_alternative<Cone>(settings.volume.shape) ? 0.05 : 1, place.z},
                 {random.in(-6, 6), 0, random.in(-6, 6)}, settings);
    }
    return many;
}

}  // namespace surefoot::tests
