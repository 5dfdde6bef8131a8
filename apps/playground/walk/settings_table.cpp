#include "playground/walk/settings_table.hpp"

#include <algorithm>
#include <array>

namespace surefoot::playground {
namespace {

using S = CharacterSettings;

constexpr SettingRow bodies[] = {
    {"volume", &S::volume, "m", 0.05, 3, "The body that meets the world. Its feet stay where they are."},
    {"crouched", &S::crouched, "m", 0.05, 3, "The body while crouch is held. None: it cannot crouch."},
    {"in_air", &S::in_air, "m", 0.05, 3, "The body while nothing carries it. None: the same as on the ground."},
    {"on_ramp", &S::on_ramp, "m", 0.05, 3, "The body on ground that is not level. None: the same everywhere."},
    {"on_ledge", &S::on_ledge, "m", 0.05, 3, "The body while it hangs on an edge or climbs. None: no other."},
    {"skin", &S::skin, "m", 0.0005, 0.1,
     "How far it is kept from everything. Bumps below half of it are not felt; large: a gap that is seen."},
};

constexpr SettingRow ground[] = {
    {"slope_limit_deg", &S::slope_limit_deg, "deg", 0, 89, "The steepest ground to stand on. Steeper: it slides down."},
    {"step_up", &S::step_up, "m", 0, 1.5, "The highest step walked up without a jump. 0: none."},
    {"step_depth", &S::step_depth, "m", 0.01, 1,
     "How much ground a step must offer. Small: narrow ledges count; large: spiral stairs get refused."},
    {"snap_down", &S::snap_down, "m", 0, 1.5, "How far the ground may drop away under it. 0: every bump is a jump."},
    {"perch_distance", &S::perch_distance, "m", 0, 1, "How far from its axis an edge may hold it. Farther: it slips."},
    {"firmness", &S::firmness, "", 0, 0, "How other characters meet this one. Nobody else is here."},
    {"flat_foot", &S::flat_foot, "", 0, 0, "Beside an edge it keeps the floor's height, where a round body would dip."},
    {"response", &S::response, "", 0, 0, "What becomes of the rest of a move that something stopped."},
    {"slope_speed", &S::slope_speed, "", 0, 0, "Is the speed meant as seen from above, or along the ground?"},
};

constexpr SettingRow motion[] = {
    {"gravity", &S::gravity, "m/s^2", 0, 60, "Twice the Earth's feels right in most games."},
    {"terminal_speed", &S::terminal_speed, "m/s", 0, 200, "The fastest fall."},
    {"acceleration", &S::acceleration, "m/s^2", 0, 300, "Towards the wish, on the ground. Small: as if it were heavy."},
    {"braking", &S::braking, "m/s^2", 0, 300, "When less is wished than it has, on the ground. Small: it drifts."},
    {"air_acceleration", &S::air_acceleration, "m/s^2", 0, 300, "Towards the wish, in the air. 0: no control there."},
};

constexpr SettingRow jump[] = {
    {"jump_height", &S::jump_height, "m", 0, 6, "How high a full jump goes, whatever gravity is."},
    {"jump_cut", &S::jump_cut, "", 1, 10, "Gravity is so many times as strong while rising with jump let go."},
    {"coyote_time", &S::coyote_time, "s", 0, 0.5, "How long after leaving an edge a jump still counts."},
    {"jump_buffer", &S::jump_buffer, "s", 0, 0.5, "How long before landing a press of jump is remembered."},
    {"keeps_ground_velocity", &S::keeps_ground_velocity, "", 0, 0,
     "Takes the speed of a lift along when it leaves it."},
    {"air_jumps", &S::air_jumps, "", 0, 5, "Jumps that need no ground, until the next landing."},
    {"wall_slide_speed", &S::wall_slide_speed, "m/s", 0, 20, "The fastest fall while pressed against a wall. 0: none."},
    {"wall_jump_speed", &S::wall_jump_speed, "m/s", 0, 20, "Away from the wall, in a jump off it. 0: there are none."},
    {"wall_coyote_time", &S::wall_coyote_time, "s", 0, 0.5, "How long after a touch a jump is still off the wall."},
};

constexpr SettingRow other[] = {
    {"dash_speed", &S::dash_speed, "m/s", 0, 40, "In the direction of the wish, without gravity. 0: there is none."},
    {"dash_time", &S::dash_time, "s", 0, 1, "How long a dash is."},
    {"dash_pause", &S::dash_pause, "s", 0, 3, "How long after one the next may begin."},
    {"swim_acceleration", &S::swim_acceleration, "m/s^2", 0, 100, "Towards the wish, under water."},
    {"sink_speed", &S::sink_speed, "m/s", -3, 3, "Downwards, under water without a wish. Below 0: it floats up."},
    {"fly_acceleration", &S::fly_acceleration, "m/s^2", 0, 200, "Towards the wish, flying freely."},
    {"ladder_speed", &S::ladder_speed, "m/s", 0, 10, "Up surfaces that are ladders. 0: none is."},
};

constexpr SettingRow hands[] = {
    {"ledge_reach", &S::ledge_reach, "m", 0, 1.5, "How far ahead hands reach for an edge. 0: it holds none."},
    {"hands_height", &S::hands_height, "m", 0.1, 3, "From the feet up to the hands that hold an edge."},
    {"climb_speed", &S::climb_speed, "m/s", 0.1, 10, "Up over an edge that it holds."},
    {"shimmy_speed", &S::shimmy_speed, "m/s", 0, 5, "Sideways along an edge, hanging."},
    {"vault_height", &S::vault_height, "m", 0, 2, "What is at most so high is climbed by a press of jump. 0: nothing."},
    {"longest_tick", &S::longest_tick, "s", 0.01, 1, "A longer tick is done in equal parts. Ticks here are 1/60 s."},
};

constexpr SettingGroup groups[] = {
    {"Body", bodies}, {"Ground", ground}, {"Motion", motion}, {"Jump", jump}, {"Dash, water, ladders", other},
    {"Hands", hands}};

constexpr std::array<const char*, 6> names{"Sphere", "Ellipsoid", "Capsule", "Box", "Cylinder", "Cone"};

bool same(const Volume& a, const Volume& b) {
    std::array<ShapeSize, 3> room_a;
    std::array<ShapeSize, 3> room_b;
    const auto x = sizes_of(a.shape, room_a);
    const auto y = sizes_of(b.shape, room_b);
    return a.shape.index() == b.shape.index() && a.orientation == b.orientation &&
           std::equal(x.begin(), x.end(), y.begin(), y.end(),
                      [](const ShapeSize& p, const ShapeSize& q) { return p.value == q.value; });
}

template <typename T>
bool same(const T& a, const T& b) {
    return a == b;
}

bool same(const std::optional<Volume>& a, const std::optional<Volume>& b) {
    return a.has_value() == b.has_value() && (!a || same(*a, *b));
}

}  // namespace

std::span<const SettingGroup> setting_groups() {
    return groups;
}

std::span<const char* const> words_of(Response /*value*/) {
    static constexpr std::array<const char*, 2> words{"slide", "stop"};
    return words;
}

std::span<const char* const> words_of(SlopeSpeed /*value*/) {
    static constexpr std::array<const char*, 2> words{"level", "along"};
    return words;
}

std::span<const char* const> words_of(Firmness /*value*/) {
    static constexpr std::array<const char*, 2> words{"hard", "soft"};
    return words;
}

bool same_field(const SettingRow& row, const CharacterSettings& a, const CharacterSettings& b) {
    return std::visit([&](auto field) { return same(a.*field, b.*field); }, row.field);
}

void copy_field(const SettingRow& row, const CharacterSettings& from, CharacterSettings& to) {
    std::visit([&](auto field) { to.*field = from.*field; }, row.field);
}

std::span<const char* const> shape_names() {
    return names;
}

std::span<const ShapeSize> sizes_of(const Shape& shape, std::span<ShapeSize, 3> room) {
    const auto put = [&](std::initializer_list<ShapeSize> sizes) {
        std::copy(sizes.begin(), sizes.end(), room.begin());
        return room.first(sizes.size());
    };
    if (const auto* const s = std::get_if<Sphere>(&shape)) return put({{"radius", s->radius}});
    if (const auto* const s = std::get_if<Ellipsoid>(&shape))
        return put({{"radius x", s->radii.x}, {"radius y", s->radii.y}, {"radius z", s->radii.z}});
    if (const auto* const s = std::get_if<Capsule>(&shape))
        return put({{"radius", s->radius}, {"half height", s->half_height}});
    if (const auto* const s = std::get_if<Box>(&shape))
        return put({{"half x", s->half_extents.x}, {"half y", s->half_extents.y}, {"half z", s->half_extents.z}});
    if (const auto* const s = std::get_if<Cylinder>(&shape))
        return put({{"radius", s->radius}, {"half height", s->half_height}});
    const auto& cone = std::get<Cone>(shape);
    return put({{"radius", cone.radius}, {"height", cone.height}});
}

Shape shape_from(std::size_t index, std::span<const double> sizes) {
    const auto size = [&](std::size_t i) { return i < sizes.size() ? sizes[i] : 0; };
    switch (index) {
        case 0:
            return Sphere{size(0)};
        case 1:
            return Ellipsoid{{size(0), size(1), size(2)}};
        case 2:
            return Capsule{size(0), size(1)};
        case 3:
            return Box{{size(0), size(1), size(2)}};
        case 4:
            return Cylinder{size(0), size(1)};
        default:
            return Cone{size(0), size(1)};
    }
}

Shape as_large(const Shape& shape, std::size_t index) {
    std::array<ShapeSize, 3> room;
    const auto sizes = sizes_of(shape, room);
    const double wide = sizes[0].value;
    double high = wide;  // half of it
    if (shape.index() == 1 || shape.index() == 3 || shape.index() == 4) high = sizes[1].value;
    if (shape.index() == 2) high = wide + sizes[1].value;
    if (shape.index() == 5) high = sizes[1].value / 2;
    const double two[2] = {wide, index == 2 ? std::max(high - wide, 0.0) : index == 5 ? 2 * high : high};
    const double three[3] = {wide, high, wide};
    return index == 1 || index == 3 ? shape_from(index, three) : shape_from(index, two);
}

}  // namespace surefoot::playground
