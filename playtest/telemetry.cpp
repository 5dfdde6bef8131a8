#include "playtest/telemetry.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <fmt/format.h>

#include "playtest/vectors.hpp"

namespace surefoot::playtest {
namespace {

constexpr std::size_t trail_ticks = 300;      // five seconds
constexpr std::size_t trail_every = 6;        // ticks between two points of it
constexpr std::uint64_t failed_within = 180;  // ticks from the jump to the fall
constexpr double fell_by = 2.5;               // below where it jumped off, a jump has failed [m]
constexpr double wants_to_go = 2;             // m/s
constexpr double gets_nowhere = 0.3;          // m
constexpr int stuck_for = 120;                // ticks
constexpr int stuck_in_one_direction = 300;   // ticks
constexpr int stands_for = 30;                // of them, ticks
constexpr int gets_away_in = 30;              // ticks
constexpr double escaped_by = 2;              // outside of the level's box [m]
constexpr double looks_far = 25;              // m
constexpr std::size_t most_captures = 20;     // of one run

std::array<int, 2> cell_of(const dvec3& place) {
    return {int(std::floor(place.x / heat_cell)), int(std::floor(place.z / heat_cell))};
}

}  // namespace

std::string_view name_of(Incident::Kind kind) {
    switch (kind) {
        case Incident::Kind::death:
            return "death";
        case Incident::Kind::failed_jump:
            return "failed jump";
        case Incident::Kind::stuck:
            return "stuck";
        case Incident::Kind::escape:
            return "escape";
        case Incident::Kind::not_a_number:
            return "NaN";
        case Incident::Kind::overflow:
            return "overflow";
    }
    return {};
}

std::size_t Telemetry::count(Incident::Kind kind) const {
    return std::size_t(std::ranges::count(incidents, kind, &Incident::kind));
}

Observer::Observer(const game::Level& level, std::string player, std::uint32_t checkpoint) {
    told_.level = level.id;
    told_.player = std::move(player);
    told_.section_seconds.resize(level.checkpoints.size());
    told_.section_deaths.resize(level.checkpoints.size());
    told_.section_reached.resize(level.checkpoints.size());
    told_.begun_in = checkpoint;
    told_.section = checkpoint;
    told_.section_reached[checkpoint] = true;
}

void Observer::add(Incident::Kind kind, const game::Game& game, game::Cause cause, std::string note) {
    Incident incident{.kind = kind,
                      .cause = cause,
                      .section = game.checkpoint(),
                      .tick = game.ticks(),
                      .place = game.feet(),
                      .note = std::move(note)};
    if (kind == Incident::Kind::death && !trail_.empty()) incident.place = trail_.back();
    for (std::size_t i = 0; i < trail_.size(); i += trail_every) incident.trail.push_back(trail_[i]);
    told_.incidents.push_back(std::move(incident));
}

void Observer::tick(const game::HeroInput& input, const game::Game& game) {
    told_.seconds = game.seconds();
    told_.won = game.outcome() == game::Outcome::won;
    told_.section = game.checkpoint();
    told_.section_seconds[game.checkpoint()] += game::tick_seconds;
    told_.section_reached[game.checkpoint()] = true;
    told_.presses += std::uint64_t(std::popcount(std::uint8_t(input.buttons & ~buttons_)));
    buttons_ = input.buttons;

    watch_events(game);
    trail_.push_back(game.feet());
    if (trail_.size() > trail_ticks) trail_.pop_front();
    watch_jump(game);
    watch_stuck(input, game);
    watch_sanity(game);
    watch_look(input, game);
}

void Observer::watch_events(const game::Game& game) {
    bool dies = false;
    game::Cause cause = game::Cause::none;
    for (const game::GameEvent& event : game.events()) {
        switch (event.what) {
            case game::Happening::fell:
            case game::Happening::lost:
                dies = true;
                cause = event.cause;
                break;
            case game::Happening::jumped:
                ++told_.jumps;
                jump_at_ = game.ticks();
                jump_from_ = event.place;
                break;
            case game::Happening::took_coin:
            case game::Happening::took_star:
            case game::Happening::took_heart:
            case game::Happening::took_key:
                for (std::uint32_t i = 0; i < game.level().pickups.size(); ++i)
                    if (game.level().pickups[i].place == event.place) told_.taken.push_back(i);
                break;
            default:
                break;
        }
    }
    if (!dies) return;
    ++told_.section_deaths[game.checkpoint()];
    if (jump_at_ && game.ticks() - *jump_at_ <= failed_within && cause != game::Cause::gave_up) {
        add(Incident::Kind::failed_jump, game, cause);
        told_.incidents.back().place = jump_from_;
    }
    jump_at_.reset();
    add(Incident::Kind::death, game, cause);
    wishes_for_ = 0;
}

void Observer::watch_jump(const game::Game& game) {
    if (!jump_at_) return;
    if (game.ticks() - *jump_at_ > failed_within) {
        jump_at_.reset();
    } else if (game.hero().body.footing == Footing::ground && game.ticks() > *jump_at_ + 3) {
        if (game.feet().y < jump_from_.y - fell_by) {
            add(Incident::Kind::failed_jump, game);
            told_.incidents.back().place = jump_from_;
        }
        jump_at_.reset();
    }
}

// To press against a wall for two seconds is not to be stuck; to press in other directions, too, and to come back to
// the same place from every jump is. Nor is who hangs on an edge, as long as they have not tried to let go of it. Nor
// is who slid down a shaft to where they began and goes elsewhere from there: some of the time they have to stand.
void Observer::watch_stuck(const game::HeroInput& input, const game::Game& game) {
    const dvec3 wish = dvec3{double(input.move_x), 0, double(input.move_z)} * game::run_speed;
    const bool in_air = game.hero().body.footing == Footing::air && !game.hero().in_water;
    if (wishes_for_ == 0 || (!in_air && length(game.feet() - stuck_from_) >= gets_nowhere)) {
        stuck_from_ = game.feet();
        stuck_wish_ = wish;
        wishes_for_ = 0;
        turned_for_ = 0;
        lets_go_ = false;
        stood_for_ = 0;
    }
    lets_go_ = lets_go_ || holds(input, game::Button::crouch);
    if (length(wish) <= wants_to_go || game.outcome() != game::Outcome::playing) {
        if (length(wish) <= wants_to_go && wishes_for_ > 0 && turned_for_ > 0) return;  // a pause for breath in a pit
        wishes_for_ = 0;
        return;
    }
    ++wishes_for_;
    // The other way, and for as long as it takes to get away.
    turned_for_ += dot(unit(wish), unit(stuck_wish_)) < 0 ? 1 : 0;
    const bool turned = turned_for_ > gets_away_in;
    const bool hangs = game.hero().body.footing == Footing::ledge && !lets_go_;
    if (!in_air) ++stood_for_;
    if (in_air || hangs || stood_for_ < stands_for) return;
    if (wishes_for_ < (turned ? stuck_for : stuck_in_one_direction)) return;
    wishes_for_ = 0;
    add(Incident::Kind::stuck, game);
    if (told_.count(Incident::Kind::stuck) > most_captures) return;
    told_.incidents.back().capture =
        capture_step(game.world(), game.settings(), game.last_input(), game::tick_seconds, game.hero_before().body);
    told_.incidents.back().capture->note = fmt::format("{} of {}: wants to go and gets nowhere, {:.1f} s into the run",
                                                       told_.player, told_.level, game.seconds());
}

void Observer::watch_sanity(const game::Game& game) {
    if (game.ticks() < quiet_until_) return;
    const dvec3 place = game.hero().body.position;
    const CharacterEvents& events = game.hero().events;
    const Bounds box = game.level().ground.bounds();
    const bool finite = std::isfinite(place.x + place.y + place.z) && std::isfinite(length(game.hero().body.velocity));
    const std::size_t before = told_.incidents.size();
    if (!finite) add(Incident::Kind::not_a_number, game);
    if (events.has(CharacterEvent::overflow) || events.has(CharacterEvent::invalid))
        add(Incident::Kind::overflow, game, game::Cause::none,
            events.has(CharacterEvent::invalid) ? "invalid" : "overflow");
    // Who stands beyond the level's box stands on nothing that anybody built; who falls is on the way to fall out.
    const bool outside = place.x < box.min.x - escaped_by || place.x > box.max.x + escaped_by ||
                         place.z < box.min.z - escaped_by || place.z > box.max.z + escaped_by ||
                         place.y < box.min.y - escaped_by;
    bool carried = false;
    for (const game::MovingBody& body : game.bodies()) carried = carried || body.body == game.hero().body.ground_body;
    if (outside && game.hero().body.footing == Footing::ground && !carried) add(Incident::Kind::escape, game);
    if (told_.incidents.size() != before) quiet_until_ = game.ticks() + 120;
}

void Observer::watch_look(const game::HeroInput& input, const game::Game& game) {
    if (game.hero().body.footing == Footing::ground) ++told_.stood[cell_of(game.feet())];
    if (game.ticks() % 6 != 0) return;
    const double yaw = double(input.look_yaw_deg) * (3.14159265358979323846 / 180);
    const double pitch = double(input.look_pitch_deg) * (3.14159265358979323846 / 180);
    const dvec3 ahead{-std::sin(yaw) * std::cos(pitch), std::sin(pitch), -std::cos(yaw) * std::cos(pitch)};
    const dvec3 eye = game.hero().body.position + dvec3{0, 0.6, 0};
    const auto hit = game.world().ray({eye, eye + ahead * looks_far}, {.begin = 1, .end = 1});
    ++told_.looked[cell_of(hit ? hit->point : eye + ahead * 8.0)];
}

}  // namespace surefoot::playtest
