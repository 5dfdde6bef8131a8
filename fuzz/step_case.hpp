// Turns the fuzzer's bytes into a small world and the arguments of a step.
#pragma once

#include <array>
#include <limits>
#include <vector>

#include "bytes.hpp"

namespace fuzz {

// Half of the numbers are small eighths, where bodies meet; the others are what no caller should hand over.
inline double any_number(Bytes& bytes) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    constexpr std::array odd{0.0,
                             -0.0,
                             std::numeric_limits<double>::quiet_NaN(),
                             infinity,
                             -infinity,
                             5e-324,
                             -5e-324,
                             1e-12,
                             1e-6,
                             1e6,
                             -1e6,
                             1e9,
                             1e12,
                             1e150,
                             -1e155,
                             9e299,
                             std::numeric_limits<double>::max()};
    const auto kind = bytes.take<std::uint8_t>();
    if (kind < 216) return bytes.number(false);
    if (kind < 224) return bytes.number(true);
    return odd[kind % odd.size()];
}

inline surefoot::dvec3 any_vector(Bytes& bytes) {
    const double x = any_number(bytes);
    const double y = any_number(bytes);
    return {x, y, any_number(bytes)};
}

// Whether there is an odd number among them is for one byte to say, or hardly any step would be a valid one.
inline surefoot::dvec3 vector(Bytes& bytes, bool odd) {
    return odd ? any_vector(bytes) : bytes.vector(false);
}

// Everything that a step is given, and the world that it happens in.
class StepCase {
public:
    explicit StepCase(Bytes& bytes) {
        const auto kind = bytes.take<std::uint8_t>();
        odd_ = (kind & 1) != 0;
        in_room = (kind & 2) != 0;
        const bool with_body = (kind & 4) != 0;
        const bool with_settings = (kind & 8) != 0;
        const bool with_state = (kind & 16) != 0;
        const bool with_rules = (kind & 32) != 0;
        const bool with_neighbours = (kind & 64) != 0;
        with_hooks = (kind & 128) != 0;
        together = bytes.take<std::uint8_t>() % 8 == 1;
        take_level(bytes);
        if (with_body) take_body(bytes);
        if (with_rules) take_rules(bytes);
        if (with_settings) take_settings(bytes);
        take_input(bytes);
        state.position = vector(bytes, odd_);
        if (with_state) take_state(bytes);
        if (with_neighbours) take_neighbours(bytes);
        if (with_hooks) own = {vector(bytes, odd_), vector(bytes, odd_)};
    }
    StepCase(const StepCase&) = delete;
    StepCase& operator=(const StepCase&) = delete;

    // Half the side of the closed room about the origin [m].
    static constexpr double room = 6;

    surefoot::World world;
    surefoot::CharacterSettings settings;
    surefoot::CharacterInput input;
    surefoot::CharacterState state;
    std::vector<surefoot::Neighbour> neighbours;
    surefoot::OwnMotion own;  // what the hooks answer
    double dt = 1.0 / 60;
    bool together = false;     // is also asked for as one of many
    bool in_room = false;      // the level has a closed room around it
    bool moves = false;        // something in the world does
    bool has_one_way = false;  // something may be gone into from behind
    bool with_hooks = false;

private:
    void take_level(Bytes& bytes) {
        const std::size_t count = bytes.take<std::uint8_t>() % 25;
        std::vector<surefoot::vec3> corners;
        std::vector<std::uint32_t> surfaces;
        for (std::size_t i = 0; i < count; ++i) {
            for (int corner = 0; corner < 3; ++corner) corners.emplace_back(vector(bytes, odd_));
            surfaces.push_back(bytes.take<std::uint8_t>() % 5);
        }
        if (in_room) add_box(corners, surfaces, static_cast<float>(room));
        add(corners, surfaces, {});
    }

    void take_body(Bytes& bytes) {
        std::vector<surefoot::vec3> corners;
        std::vector<std::uint32_t> surfaces;
        add_box(corners, surfaces, static_cast<float>(1 + bytes.take<std::uint8_t>() % 8) * 0.25F);
        const surefoot::dvec3 from = vector(bytes, odd_);
        const auto body = add(corners, surfaces, {.position = from});
        surefoot::Pose to{.position = from + vector(bytes, odd_)};
        if (bytes.take<std::uint8_t>() % 2 != 0) to.orientation = {1, 0, bytes.number(false) * 0.0625, 0};
        moves = world.contains(body) && world.move(body, to);
    }

    surefoot::BodyHandle add(const std::vector<surefoot::vec3>& corners, const std::vector<std::uint32_t>& surfaces,
                             const surefoot::Pose& pose) {
        std::vector<std::uint32_t> indices;
        for (std::uint32_t i = 0; i < corners.size(); ++i) indices.push_back(i);
        const auto mesh = surefoot::Mesh::build({.vertices = corners, .indices = indices, .surfaces = surfaces});
        if (!mesh) return {};
        const auto body = world.add(*mesh, {.pose = pose});
        if (!body) return {};
        return *body;
    }

    static void add_box(std::vector<surefoot::vec3>& corners, std::vector<std::uint32_t>& surfaces, float half) {
        for (const int corner : {2, 6, 7, 2, 7, 3, 0, 1, 5, 0, 5, 4, 0, 4, 6, 0, 6, 2,
                                 1, 3, 7, 1, 7, 5, 0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6}) {
            corners.emplace_back((corner & 1) != 0 ? half : -half, (corner & 2) != 0 ? half : -half,
                                 (corner & 4) != 0 ? half : -half);
        }
        surfaces.resize(corners.size() / 3, 0);
    }

    void take_rules(Bytes& bytes) {
        for (std::size_t i = 1; i < rules_.size(); ++i) {  // the room's own is firm ground
            const auto kind = bytes.take<std::uint8_t>();
            rules_[i] = {.grip = number(bytes),
                         .conveyor = vector(bytes, odd_),
                         .one_way = (kind & 1) != 0,
                         .slippery = (kind & 2) != 0,
                         .ladder = (kind & 4) != 0};
            has_one_way |= rules_[i].one_way;
        }
        settings.surfaces = std::span<const surefoot::SurfaceRule>(rules_);
    }

    void take_settings(Bytes& bytes) {
        using Settings = surefoot::CharacterSettings;
        static constexpr std::array numbers{&Settings::skin,
                                            &Settings::slope_limit_deg,
                                            &Settings::step_up,
                                            &Settings::step_depth,
                                            &Settings::snap_down,
                                            &Settings::perch_distance,
                                            &Settings::gravity,
                                            &Settings::terminal_speed,
                                            &Settings::acceleration,
                                            &Settings::braking,
                                            &Settings::air_acceleration,
                                            &Settings::jump_height,
                                            &Settings::jump_cut,
                                            &Settings::coyote_time,
                                            &Settings::jump_buffer,
                                            &Settings::wall_slide_speed,
                                            &Settings::wall_jump_speed,
                                            &Settings::wall_coyote_time,
                                            &Settings::dash_speed,
                                            &Settings::dash_time,
                                            &Settings::dash_pause,
                                            &Settings::swim_acceleration,
                                            &Settings::sink_speed,
                                            &Settings::fly_acceleration,
                                            &Settings::ladder_speed,
                                            &Settings::ledge_reach,
                                            &Settings::hands_height,
                                            &Settings::climb_speed,
                                            &Settings::shimmy_speed,
                                            &Settings::vault_height,
                                            &Settings::longest_tick};
        const auto flags = bytes.take<std::uint8_t>();
        if ((flags & 1) != 0) settings.volume = bytes.volume(odd_);
        if ((flags & 2) != 0) settings.crouched = bytes.volume(odd_);
        if ((flags & 4) != 0) settings.in_air = bytes.volume(odd_);
        if ((flags & 8) != 0) settings.on_ramp = bytes.volume(odd_);
        settings.flat_foot = (flags & 16) != 0;
        settings.response = (flags & 32) != 0 ? surefoot::Response::stop : surefoot::Response::slide;
        settings.slope_speed = (flags & 64) != 0 ? surefoot::SlopeSpeed::along : surefoot::SlopeSpeed::level;
        settings.keeps_ground_velocity = (flags & 128) != 0;
        for (int count = bytes.take<std::uint8_t>() % 8; count > 0; --count) {
            const std::size_t which = bytes.take<std::uint8_t>() % numbers.size();
            settings.*numbers[which] = number(bytes);
        }
        const auto last = bytes.take<std::uint8_t>();
        settings.air_jumps = last & 127U;
        if ((last & 128) != 0) settings.on_ledge = bytes.volume(odd_);
    }

    void take_input(Bytes& bytes) {
        const auto flags = bytes.take<std::uint8_t>();
        input.wish = vector(bytes, odd_);
        if ((flags & 1) != 0) input.impulse = vector(bytes, odd_) * 4.0;
        if ((flags & 2) != 0) input.up = vector(bytes, odd_);
        if ((flags & 4) != 0) dt = number(bytes);
        input.jump = (flags & 8) != 0;
        input.crouch = (flags & 16) != 0;
        input.dash = (flags & 32) != 0;
        input.mode = static_cast<surefoot::CharacterMode>(flags >> 6);
    }

    void take_state(Bytes& bytes) {
        state.velocity = vector(bytes, odd_) * 4.0;
        state.ground_normal = vector(bytes, odd_) * 0.125;
        state.ground_velocity = vector(bytes, odd_);
        state.wall_normal = vector(bytes, odd_) * 0.125;
        state.ledge_point = vector(bytes, odd_);
        for (double* const time :
             {&state.since_ground, &state.since_jump_press, &state.since_wall, &state.since_dash, &state.since_hold}) {
            *time = number(bytes);
        }
        state.ground_body = bytes.take<std::uint8_t>() % 4;
        state.ground_triangle = bytes.take<std::uint8_t>();
        state.air_jumps_left = bytes.take<std::uint8_t>();
        const auto flags = bytes.take<std::uint8_t>();
        // Of what may have come over a network no number is beyond belief.
        state.footing = static_cast<surefoot::Footing>(odd_ ? bytes.take<std::uint8_t>() : flags & 3);
        state.form = static_cast<surefoot::CharacterForm>(odd_ ? bytes.take<std::uint8_t>() : flags >> 2 & 3);
        state.hold = static_cast<surefoot::Hold>(odd_ ? bytes.take<std::uint8_t>() : (flags >> 4 & 3) % 3);
        state.jump_held = flags >> 6 & 1;
        state.is_jumping = flags >> 7 & 1;
        state.dash_held = state.jump_held;
    }

    void take_neighbours(Bytes& bytes) {
        for (int count = bytes.take<std::uint8_t>() % 4; count > 0; --count) {
            const auto flags = bytes.take<std::uint8_t>();
            neighbours.push_back({.volume = (flags & 1) != 0 ? bytes.volume(odd_) : settings.volume,
                                  .position = (flags & 2) != 0 ? state.position : vector(bytes, odd_),
                                  .velocity = vector(bytes, odd_),
                                  .id = flags,
                                  .carrier = static_cast<std::uint32_t>(flags >> 4 & 1),
                                  .is_carried = (flags & 4) != 0,
                                  .firmness = (flags & 8) != 0 ? surefoot::Firmness::soft : surefoot::Firmness::hard});
        }
    }

    double number(Bytes& bytes) const { return odd_ ? any_number(bytes) : std::abs(bytes.number(false)); }

    bool odd_ = false;
    std::array<surefoot::SurfaceRule, 5> rules_{};
};

}  // namespace fuzz
