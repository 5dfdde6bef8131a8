// A crowd that presses together on moving ground, and bodies of parts that are shot at: every number is hashed.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <surefoot/surefoot.hpp>

#include "characters.hpp"

namespace golden {

inline constexpr std::size_t crowd_size = 24;

inline void press_together(Hash& hash, surefoot::Firmness firmness) {
    Random random(970 + static_cast<std::uint64_t>(firmness));
    Playground playground(random);
    std::array<surefoot::CharacterSettings, crowd_size> settings;
    std::array<surefoot::CharacterInput, crowd_size> inputs;
    std::array<surefoot::CharacterState, crowd_size> states;
    std::array<surefoot::CharacterEvents, crowd_size> events;
    std::array<surefoot::CharacterContacts, crowd_size> contacts;
    const std::array<surefoot::Shape, 3> shapes{surefoot::Ellipsoid{{0.375, 0.875, 0.375}},
                                                surefoot::Capsule{0.375, 0.5}, surefoot::Sphere{0.5}};
    for (std::size_t i = 0; i < crowd_size; ++i) {
        settings[i].volume = shapes[i % 8 < 6 ? 0 : i % 8 - 5];
        settings[i].firmness = firmness;
        // Some begin inside of each other.
        states[i].position = {static_cast<double>(random.between(-16, 16)) * 0.25, 3,
                              static_cast<double>(random.between(-16, 16)) * 0.25};
    }
    surefoot::Crowd crowd;
    const surefoot::Characters all{.settings = settings,
                                   .inputs = inputs,
                                   .before = states,
                                   .after = states,
                                   .events = events,
                                   .contacts = contacts};
    for (int tick = 0; tick < 160; ++tick) {
        if (tick % 16 == 0) {
            for (surefoot::CharacterInput& input : inputs) {
                const auto sixteenths = [&] { return static_cast<double>(random.between(-64, 64)) * 0.0625; };
                input.wish = {sixteenths(), 0, sixteenths()};
                input.jump = random.between(0, 5) == 0;
            }
        }
        playground.tick();
        if (!crowd.gather(all, 0.015625)) return;
        step_all(playground.world(), crowd, all, 0.015625);
        for (std::size_t i = 0; i < crowd_size; ++i) {
            add_to(hash, states[i]);
            hash << std::uint64_t{events[i].set} << std::uint64_t{events[i].blocked_body} << events[i].blocked_by;
            for (const surefoot::CharacterContact& contact : contacts[i].get()) {
                hash << contact.point << contact.normal << contact.impulse << std::uint64_t{contact.triangle};
            }
        }
    }
}

inline void shoot_at_parts(Hash& hash) {
    Queries queries(990);
    for (int i = 0; i < 1500; ++i) {
        queries.next_family();
        std::array<surefoot::HitPart, 3> parts;
        for (std::uint32_t k = 0; k < parts.size(); ++k) {
            parts[k] = {.volume = queries.volume((static_cast<std::size_t>(i) + k) % 6),
                        .start = {queries.position(), queries.orientation()},
                        .number = k};
            parts[k].end = queries.coin() ? parts[k].start : surefoot::Pose{queries.position(), queries.orientation()};
        }
        const surefoot::Pose start{queries.position(), queries.orientation()};
        const surefoot::Pose end = queries.coin() ? start : surefoot::Pose{queries.position(), queries.orientation()};
        const surefoot::Hitboxes body(parts, start, end);
        const surefoot::HitboxQuery query{.begin = queries.coin() ? 0 : 0.25, .end = 0.75, .turn_gap = 0.0625};
        const surefoot::Motion motion = queries.motion();
        const auto add = [&](const std::optional<surefoot::PartHit>& hit) {
            hash << std::uint64_t{hit.has_value()};
            if (!hit) return;
            hash << hit->t << hit->point << hit->normal << std::uint64_t{hit->number}
                 << static_cast<std::uint64_t>(hit->status) << std::uint64_t{hit->started_inside};
        };
        hash << body.radius();
        add(body.ray(motion, query));
        add(body.sweep(queries.volume(static_cast<std::size_t>(i) % 6), motion, query));
    }
}

}  // namespace golden
