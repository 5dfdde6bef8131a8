/// Random questions of every kind, and moments made of them.
#pragma once

#include <bit>
#include <limits>
#include <string>
#include <vector>

#include <surefoot/surefoot.hpp>

#include "splitmix.hpp"
#include "world_things.hpp"

namespace surefoot::tests {

/// Any bits at all, half of the time; else something that a game would have.
inline double any_number(SplitMix& random) {
    return random.next() % 2 == 0 ? std::bit_cast<double>(random.next()) : random.in(-1000, 1000);
}
inline dvec3 any_vector(SplitMix& random) {
    const double x = any_number(random);
    const double y = any_number(random);
    return {x, y, any_number(random)};
}
inline dquat any_turn(SplitMix& random) {
    const dvec3 axis = any_vector(random);
    return dquat(any_number(random), axis.x, axis.y, axis.z);
}
inline Shape any_shape(SplitMix& random) {
    const dvec3 size = any_vector(random);
    switch (random.next() % 6) {
        case 0:
            return Sphere{.radius = size.x};
        case 1:
            return Ellipsoid{.radii = size};
        case 2:
            return Capsule{.radius = size.x, .half_height = size.y};
        case 3:
            return Box{.half_extents = size};
        case 4:
            return Cylinder{.radius = size.x, .half_height = size.y};
        default:
            return Cone{.radius = size.x, .height = size.y};
    }
}
inline std::string any_note(SplitMix& random) {
    constexpr const char* pieces[] = {"a ledge", "\"", "\\", "\n", "\x01", "\x7f", "é", "\xf0\x9f\xa6\xb6", "/", "\t"};
    std::string note;
    for (std::uint64_t i = random.next() % 8; i > 0; --i) note += pieces[random.next() % std::size(pieces)];
    return note;
}

/// A capture that holds anything that a capture can hold, whether it makes sense or not.
inline Capture any_capture(SplitMix& random) {
    Capture capture;
    capture.origin = {.library = {1, 2, static_cast<int>(random.next() % 100)}, .abi = abi_name};
    capture.note = any_note(random);
    CapturedQuestion& q = capture.question;
    q.kind = random.next() % 2 == 0 ? CaptureKind::sweep : CaptureKind::ray;
    if (q.kind == CaptureKind::sweep) q.volume = Volume(any_shape(random), any_turn(random));
    q.motion = {any_vector(random), any_vector(random)};
    q.one_sided = random.next() % 2 == 0;
    const std::uint32_t bodies = random.next() % 2 == 0 ? 0 : 1 + static_cast<std::uint32_t>(random.next() % 3);
    if (bodies > 0) {
        q.begin = any_number(random);
        q.end = any_number(random);
        q.turn_gap = any_number(random);
    }
    for (std::uint32_t i = 0; i < bodies; ++i) {
        capture.bodies.push_back({.body = 7 * i,
                                  .start = {any_vector(random), any_turn(random)},
                                  .end = {any_vector(random), any_turn(random)},
                                  .bounds = {any_vector(random), any_vector(random)}});
    }
    for (std::uint32_t i = 0; i < (bodies > 0 ? bodies : 1); ++i) {
        std::uint32_t id = 0;
        for (std::uint64_t count = random.next() % 4; count > 0; --count) {
            id += 1 + static_cast<std::uint32_t>(random.next() % 1000);
            capture.triangles.push_back({.triangle = {any_vector(random), any_vector(random), any_vector(random)},
                                         .id = id,
                                         .surface = static_cast<std::uint32_t>(random.next()),
                                         .body = 7 * i});
        }
    }
    if (random.next() % 4 != 0) {
        capture.answer = Hit{.t = any_number(random),
                             .point = any_vector(random),
                             .normal = any_vector(random),
                             .triangle = static_cast<std::uint32_t>(random.next()),
                             .surface = static_cast<std::uint32_t>(random.next()),
                             .body = static_cast<std::uint32_t>(random.next()),
                             .feature = static_cast<Feature>(random.next() % 3),
                             .status = static_cast<HitStatus>(random.next() % 3),
                             .started_inside = random.next() % 2 == 0};
    }
    return capture;
}

/// A volume that is within the limits, turned anyhow.
inline Volume any_volume(SplitMix& random) {
    return {every_shape[random.next() % every_shape.size()], random.turn()};
}

/// Three bodies: one that stands at the origin, one that stands turned, one that moves and turns. They refer to
/// nothing but `world`.
inline World moving_world(const Soup& soup) {
    World world;
    const auto part = static_cast<std::size_t>(soup.count() / 3);
    EXPECT_TRUE(world.add(soup.mesh(0, part), {.body = 2}).has_value());
    const dquat turned(0.9, 0.1, 0.3, -0.2);
    EXPECT_TRUE(world.add(soup.mesh(part, part), {.pose = {{1, 2, 3}, turned}, .body = 40}).has_value());
    const auto lift = world.add(soup.mesh(2 * part, part), {.pose = {{-1, 0, 0.3}, dquat(1, 0, 0, 0)}, .body = 9});
    EXPECT_TRUE(lift && world.move(*lift, {{1, 0.5, 0.3}, dquat(0.98, 0, 0.2, 0)}));
    return world;
}

}  // namespace surefoot::tests
