#include "platformer/sound/effects.hpp"

#include <algorithm>
#include <array>

#include "platformer/sound/effects_parts.hpp"
#include "platformer/sound/envelope.hpp"
#include "platformer/sound/filter.hpp"

namespace surefoot::sound {

namespace {

using Workshop = Samples (*)(Effect, Random&);

struct Entry {
    std::string_view name;
    Workshop workshop;
    double loudness;  ///< RMS of its loudest twentieth of a second [dB below full scale]
    int variations;
};

constexpr std::array<Entry, effect_count> entries{{
    {"step_stone", make_of_feet, -30, 6},     {"step_grass", make_of_feet, -31, 6},
    {"step_wood", make_of_feet, -28, 6},      {"step_metal", make_of_feet, -29, 6},
    {"step_water", make_of_feet, -28, 6},     {"step_ice", make_of_feet, -30, 6},
    {"jump", make_of_moves, -23, 4},          {"double_jump", make_of_moves, -22, 4},
    {"wall_jump", make_of_moves, -21, 4},     {"land_soft", make_of_feet, -25, 4},
    {"land_hard", make_of_feet, -17, 4},      {"dash", make_of_moves, -21, 4},
    {"grab", make_of_moves, -23, 4},          {"climb", make_of_moves, -27, 4},
    {"slide", make_of_feet, -27, 4},          {"splash", make_of_feet, -18, 4},
    {"coin", make_of_things, -21, 2},         {"star", make_of_things, -18, 1},
    {"key", make_of_things, -20, 2},          {"door", make_of_things, -18, 2},
    {"checkpoint", make_of_things, -18, 1},   {"heart", make_of_things, -19, 1},
    {"bounce", make_of_moves, -19, 4},        {"crumble", make_of_things, -19, 4},
    {"hurt", make_of_moments, -16, 3},        {"death", make_of_moments, -16, 1},
    {"stomp", make_of_moves, -17, 4},         {"enemy_notice", make_of_moments, -21, 2},
    {"shot", make_of_moments, -20, 4},        {"win", make_of_moments, -15, 1},
    {"lose", make_of_moments, -17, 1},        {"menu_move", make_of_moments, -26, 2},
    {"menu_choose", make_of_moments, -22, 1}, {"pause", make_of_moments, -22, 1},
}};

const Entry& entry(Effect effect) {
    return entries[static_cast<std::size_t>(effect)];
}

}  // namespace

std::string_view name_of(Effect effect) {
    return entry(effect).name;
}

std::optional<Effect> effect_named(std::string_view name) {
    for (std::size_t i = 0; i < entries.size(); ++i) {
        if (entries[i].name == name) return static_cast<Effect>(i);
    }
    return std::nullopt;
}

int variations_of(Effect effect) {
    return entry(effect).variations;
}

Samples make(Effect effect, int variation) {
    Random random((static_cast<std::uint64_t>(effect) << 32) + static_cast<std::uint32_t>(variation));
    Samples made = entry(effect).workshop(effect, random);
    remove_rumble(made);
    trim(made);
    set_loudness(made, entry(effect).loudness);
    fade_ends(made, 0.001, std::min(0.03, 0.2 * double(made.size()) / rate));
    return made;
}

Samples puff(Random& random, double frequency, double q, double half_life, double seconds) {
    Filter filter(frequency, q);
    Decay fade(half_life);
    Samples made = generate(seconds, [&](double) { return fade.next() * filter.next(random.noise()).band; });
    fade_ends(made, 0, seconds / 3);
    return made;
}

Samples thump(double from, double to, double half_life, double seconds) {
    Decay fall(half_life / 3), fade(half_life);
    double phase = 0;
    Samples made = generate(seconds, [&](double) {
        phase += mix(to, from, fall.next()) / rate;
        return fade.next() * sine(phase);
    });
    fade_ends(made, 0, seconds / 3);
    return made;
}

}  // namespace surefoot::sound
