#include "platformer/hero/act.hpp"

#include <glm/geometric.hpp>

namespace surefoot::platformer {
namespace {

constexpr double hurt_time = 0.35;     // [s]
constexpr double walking_speed = 0.3;  // [m/s]
constexpr double sliding_speed = 3.2;  // crouched and faster than this it slides [m/s]

}  // namespace

HeroAct act_of(const HeroPose& pose, const CharacterState& before, const CharacterState& after,
               const CharacterEvents& events, const CharacterSettings& settings, const HeroFlags& flags) {
    if (flags.dead) return HeroAct::dead;
    if (flags.won) return HeroAct::win;
    if (flags.hurt || pose.since_hurt < hurt_time) return HeroAct::hurt;
    if (after.hold == Hold::climbing) return HeroAct::climb;
    if (after.hold == Hold::hanging || after.footing == Footing::ledge) return HeroAct::hang;
    if (settings.dash_speed > 0 && after.since_dash < settings.dash_time) return HeroAct::dash;
    if (events.has(CharacterEvent::climbing)) return HeroAct::ladder;
    if (flags.under_water) return HeroAct::swim;
    const double speed = glm::length(dvec3(after.velocity.x, 0, after.velocity.z));
    if (after.footing == Footing::ground || after.footing == Footing::steep) {
        if (after.footing == Footing::steep && speed > sliding_speed) return HeroAct::slide;
        if (after.form == CharacterForm::crouched) return speed > sliding_speed ? HeroAct::slide : HeroAct::crouch;
        return speed > walking_speed ? HeroAct::run : HeroAct::idle;
    }
    const bool held_by_wall = settings.wall_slide_speed > 0 && after.since_wall <= 0.02 && before.since_wall <= 0.05 &&
                              after.velocity.y < 0 && after.velocity.y > -1.2 * settings.wall_slide_speed;
    if (held_by_wall && glm::length(after.wall_normal) > 0.5) return HeroAct::wall_slide;
    // In a short hop down a step it keeps on running.
    const bool hops = pose.act == HeroAct::run && after.since_ground < 0.07 && after.is_jumping == 0;
    if (hops) return HeroAct::run;
    return after.velocity.y > -1.0 && after.since_ground < 5 && (after.is_jumping != 0 || after.velocity.y > 0)
               ? HeroAct::jump
               : HeroAct::fall;
}

}  // namespace surefoot::platformer
