#include "link_proof.hpp"

#include <algorithm>
#include <cmath>

#include <surefoot/navigation_drive.hpp>

#include "forbidden.hpp"

namespace surefoot {

namespace navigation {
namespace {

/// Whoever arrived has to keep standing for so long without a wish [s].
constexpr double stands_for = 0.5;
/// And not farther than this from where the link ends [m].
constexpr double strays = 0.6;
/// The speed of somebody who did not stop where the link begins [m/s].
constexpr double set_out = 1;

void record_input(NavigationLink& link, const CharacterInput& input) {
    const NavigationInput told{.wish = input.wish,
                               .ticks = 1,
                               .jump = input.jump ? std::uint8_t{1} : std::uint8_t{0},
                               .crouch = input.crouch ? std::uint8_t{1} : std::uint8_t{0}};
    if (!link.inputs.empty() && link.inputs.back().wish == told.wish && link.inputs.back().jump == told.jump &&
        link.inputs.back().crouch == told.crouch)
        ++link.inputs.back().ticks;
    else
        link.inputs.push_back(told);
}

}  // namespace

static CharacterState stand_at(const World& world, const CharacterSettings& settings, const NavigationAgent& agent,
                               const dvec3& feet, const dvec3& up, double tick) {
    // A little above, since the mesh follows the ground only so finely; then it comes down and to rest.
    constexpr double above = 0.1;
    constexpr int longest = 60;
    CharacterState state;
    const dvec3 unit = up / length(up);
    state.position = feet + unit * (agent.feet + above);
    for (int i = 0; i < longest; ++i) {
        const CharacterState before = state;
        state = step(world, settings, {.up = unit}, tick, state).state;
        if (state.footing == Footing::ground && before.footing == Footing::ground && state.position == before.position)
            break;
    }
    return state;
}

LinkProof::LinkProof(const World& world, const CharacterSettings& settings, const NavigationMesh& mesh,
                     const Islands& islands, const NavigationLinkOptions& options)
    : world_(world),
      settings_(settings),
      islands_(islands),
      options_(options),
      agent_(mesh.agent()),
      up_(mesh.up()),
      query_(mesh, 16, NavigationDoors::open) {}

bool LinkProof::is_forbidden(const CharacterState& state) const {
    return Forbidden{options_.regions, options_.surface_areas}.holds(state, state.position - up_ * agent_.feet);
}

bool LinkProof::stands(CharacterState state, const dvec3& to, std::uint32_t island) {
    const int rest = static_cast<int>(stands_for / options_.tick);
    for (int i = 0; i < rest; ++i) state = step(world_, settings_, {.up = up_}, options_.tick, state).state;
    ticks_ += static_cast<std::uint64_t>(rest);
    const dvec3 feet = state.position - up_ * agent_.feet;
    if (state.footing != Footing::ground || length(feet - to) > strays) return false;
    const auto ground = query_.nearest(feet, agent_.radius, std::max(agent_.climb, 0.2));
    return ground && islands_.of(ground->polygon.id) == island;
}

bool LinkProof::gets_over(const NavigationLink& link, std::uint32_t island, NavigationLink* record) {
    const CharacterState state = stand_at(world_, settings_, agent_, link.from, up_, options_.tick);
    return state.footing == Footing::ground && gets_over(link, state, island, record);
}

bool LinkProof::begins_beside(const NavigationLink& link, const dvec3& forward, std::uint32_t island) {
    const dvec3 left = cross(up_, forward);
    for (const dvec3& aside : {forward, -forward, left, -left}) {
        const dvec3 place = link.from + aside * options_.margins.begin;
        CharacterState state = stand_at(world_, settings_, agent_, place, up_, options_.tick);
        // Nobody sets out from where nobody stands.
        if (state.footing != Footing::ground || length(state.position - up_ * agent_.feet - place) > strays) continue;
        state.velocity = aside * set_out;
        if (!gets_over(link, state, island, nullptr)) return false;
    }
    return true;
}

bool LinkProof::gets_over(const NavigationLink& link, CharacterState state, std::uint32_t island,
                          NavigationLink* record) {
    NavigationDrive driver{.up = up_, .feet = agent_.feet};
    std::uint32_t ticks = 0;
    for (;;) {
        const CharacterInput input = drive(link, driver, state, settings_, options_.tick);
        if (driver.status == NavigationDriveStatus::failed || is_forbidden(state)) return false;
        if (driver.status == NavigationDriveStatus::arrived) break;
        if (record != nullptr) record_input(*record, input);
        state = step(world_, settings_, input, options_.tick, state).state;
        ++ticks;
        ++ticks_;
    }
    if (record != nullptr) {
        record->seconds = ticks * options_.tick;
        record->end = state.position - up_ * agent_.feet;
    }
    return stands(state, link.to, island);
}

bool LinkProof::holds(NavigationLink& link, std::uint32_t island) {
    NavigationLink proven = link;
    proven.tick = options_.tick;
    proven.inputs.clear();
    if (!gets_over(link, island, &proven)) return false;

    const dvec3 across = link.to - link.from;
    dvec3 forward = across - up_ * dot(across, up_);
    if (const double size = length(forward); size > 1e-9) forward /= size;
    const dvec3 aside = cross(forward, up_) * (options_.margins.aside * agent_.radius);
    const dvec3 along = forward * options_.margins.along;
    const auto still_holds = [&](const dvec3& from, const dvec3& takeoff, double speed) {
        NavigationLink off = proven;
        off.inputs.clear();
        off.from += from;
        off.takeoff += takeoff;
        off.speed *= speed;
        return gets_over(off, island, nullptr);
    };
    const dvec3 none{0, 0, 0};
    // A jump is early or late where it leaves the ground; whatever else, where it begins.
    const bool jumps = link.kind == NavigationLinkKind::jump && link.takeoff != link.from;
    const auto shifted = [&](const dvec3& by) {
        return jumps ? still_holds(none, by, 1) : still_holds(by, link.takeoff == link.from ? by : none, 1);
    };
    if (options_.margins.along > 0 && (!shifted(along) || !shifted(-along))) return false;
    if (options_.margins.aside > 0 && (!still_holds(aside, aside, 1) || !still_holds(-aside, -aside, 1))) return false;
    if (options_.margins.begin > 0 && !begins_beside(proven, forward, island)) return false;
    if (options_.margins.speed > 0 &&
        (!still_holds(none, none, 1 - options_.margins.speed) || !still_holds(none, none, 1 + options_.margins.speed)))
        return false;
    link = std::move(proven);
    return true;
}

}  // namespace navigation

inline namespace v0 {

CharacterState stand_at(const World& world, const CharacterSettings& settings, const dvec3& feet, const dvec3& up,
                        double tick) noexcept {
    return navigation::stand_at(world, settings, navigation_agent(settings), feet, up, tick);
}

}  // namespace v0
}  // namespace surefoot
