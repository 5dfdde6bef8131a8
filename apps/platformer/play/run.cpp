#include "platformer/play/run.hpp"

#include <algorithm>
#include <cmath>

#include "platformer/hero/figure.hpp"
#include "platformer/hero/props.hpp"
#include "platformer/play/followed.hpp"

namespace surefoot::platformer {
namespace {

constexpr double most_open = 0.85;  // of a screen door before the hero, so that it is seen that something is there
constexpr double degree = 3.14159265358979323846 / 180;

HeroFlags flags_of(const game::Game& game, bool reduced_motion) {
    HeroFlags flags;
    flags.under_water = game.hero().in_water;
    flags.hurt = std::ranges::any_of(game.events(),
                                     [](const game::GameEvent& event) { return event.what == game::Happening::hurt; });
    flags.untouchable = game.hero().safe_for > 0 && game.hero().health < game::most_health;
    flags.dead = game.outcome() == game::Outcome::lost;
    flags.won = game.outcome() == game::Outcome::won;
    flags.reduced_motion = reduced_motion;
    return flags;
}

// Every tick is played, and none is drawn: so what follows is what followed then.
void wind_forward(Run::Prepared& made, const std::atomic<bool>* stop) {
    made.player.emplace(*made.plan.watched);
    while (made.game->seconds() < made.plan.watched_from - 0.5 * game::tick_seconds && (stop == nullptr || !*stop) &&
           made.player->tick(*made.game))
        for (const game::GameEvent& event : made.game->events())
            if (event.what == game::Happening::checkpoint) made.section_began = made.game->seconds();
}

}  // namespace

double facing_of(const dvec3& direction) {
    return std::atan2(direction.x, direction.z);
}

Expected<Run::Prepared> Run::prepare(Plan plan, const std::atomic<bool>* stop) {
    const std::uint32_t begins_at = plan.watched ? plan.watched->checkpoint : 0;
    auto game = game::Game::start(plan.level, {.checkpoint = begins_at, .stop = stop});
    if (!game) return tl::unexpected(game.error());
    Prepared made{.plan = std::move(plan), .game = std::move(*game)};
    if (const Mesh& decor = made.plan.level->decor; decor.triangle_count() > 0)
        if (auto added = made.decor.add(decor); !added) return tl::unexpected(added.error());
    if (made.plan.ghost) {
        auto ghost = game::Game::start(made.plan.level, {.checkpoint = made.plan.ghost->checkpoint, .stop = stop});
        if (!ghost) return tl::unexpected(ghost.error());
        made.ghost = std::move(*ghost);
    }
    if (made.plan.watched) wind_forward(made, stop);
    if (made.plan.pilot.study && !made.plan.watched) made.plan.pilot.study(*made.game);
    return made;
}

std::unique_ptr<Run> Run::start(Prepared prepared) {
    std::unique_ptr<Run> run(new Run(std::move(prepared.plan)));
    run->game_ = std::move(prepared.game);
    run->decor_ = std::move(prepared.decor);
    if (prepared.ghost) {
        run->ghost_.emplace(
            Ghost{.game = std::move(prepared.ghost), .player = std::make_unique<game::Player>(*run->plan_.ghost)});
        run->ghost_->pose = hero_at(run->ghost_->game->hero().body, run->game_->settings());
        run->ghost_->before = run->ghost_->pose;
    }
    run->player_ = prepared.player;
    run->section_began_ = prepared.section_began;
    run->actors_.emplace(*run->game_);
    run->stand();
    return run;
}

Run::Run(Plan plan) : plan_(std::move(plan)), look_(*plan_.level), recorder_(*plan_.level, plan_.player) {}

void Run::stand() {
    const double facing = facing_of(game_->hero().facing);
    pose_ = hero_at(game_->hero().body, game_->settings(), facing);
    pose_before_ = pose_;
    camera_ = camera_behind(scene(), followed(*game_, facing), {}, facing);
    camera_before_ = camera_;
}

game::HeroInput Run::input_of(const Asked& asked) const {
    game::HeroInput input;
    const dvec3 forward{std::sin(camera_.yaw), 0, std::cos(camera_.yaw)};
    const dvec3 right{-forward.z, 0, forward.x};
    const dvec3 way = right * asked.move.x + forward * asked.move.y;
    input.move_x = float(std::clamp(way.x, -1.0, 1.0));
    input.move_z = float(std::clamp(way.z, -1.0, 1.0));
    input.look_yaw_deg = float(std::remainder(camera_.yaw / degree + 180, 360));
    input.look_pitch_deg = float(-camera_.pitch / degree);
    if (asked.jump) press(input, game::Button::jump);
    if (asked.dash) press(input, game::Button::dash);
    if (asked.crouch) press(input, game::Button::crouch);
    return input;
}

void Run::tick(const Asked& asked, const CameraSettings& settings) {
    pose_before_ = pose_;
    camera_before_ = camera_;
    const CharacterState before = game_->hero().body;
    bool stands_anew = false;
    if (player_) {
        stands_anew = !player_->tick(*game_);
        if (stands_anew) is_over_ = true;
    } else {
        game::HeroInput input = plan_.pilot ? plan_.pilot.decide(*game_) : input_of(asked);
        game_->tick(input);
        if (game_->outcome() == game::Outcome::playing || !game_->events().empty()) recorder_.tick(input, *game_);
    }
    since_hurt_ += game::tick_seconds;
    since_coin_ += game::tick_seconds;
    for (const game::GameEvent& event : game_->events()) {
        if (event.what == game::Happening::hurt) {
            hurt_from_ = event.place;
            since_hurt_ = 0;
        }
        if (event.what == game::Happening::took_coin) since_coin_ = 0;
        if (event.what == game::Happening::checkpoint) section_began_ = game_->seconds();
    }
    pose_ = advance(pose_, before, game_->hero().body, game_->hero().events, game_->settings(),
                    flags_of(*game_, settings.reduced_motion), game::tick_seconds);
    CameraInput turn{.turn_left = -asked.turn.x, .turn_up = -asked.turn.y};
    camera_ = advance(camera_, scene(), followed(*game_, pose_.facing), settings, turn,
                      hint_at(*plan_.level, game_->hero().body.position), game::tick_seconds);
    actors_->tick(*game_, pose_, before, settings.reduced_motion);
    if (ghost_) {
        const CharacterState ghost_before = ghost_->game->hero().body;
        ghost_->before = ghost_->pose;
        ghost_->player->tick(*ghost_->game);
        ghost_->pose = advance(ghost_->pose, ghost_before, ghost_->game->hero().body, ghost_->game->hero().events,
                               game_->settings(), flags_of(*ghost_->game, settings.reduced_motion), game::tick_seconds);
    }
}

/// The hero is seen whatever is before them, and leaves that are close to the eye are not in the way.
view::ScreenDoor Run::door(double blend) const {
    const double height = half_height_of(game_->settings(), game_->hero().body.form);
    const dvec3 before = camera_before_.target;
    const bool was_put = glm::length(camera_.target - before) > teleport_distance;
    return {.middle = was_put ? camera_.target : before + (camera_.target - before) * blend,
            .half = {0.75, height + 0.3},
            .strength = most_open * (camera_before_.door + (camera_.door - camera_before_.door) * blend),
            .nearest = camera_.in_leaves ? leaves_reach : 0};
}

void Run::draw(view::Renderer& renderer, double blend, bool shows_volume) const {
    look_.draw(renderer, *game_, blend);
    actors_->draw(renderer, *game_, blend);
    const HeroPose now = between(pose_before_, pose_, blend);
    renderer.see_through(door(blend));
    draw_ground_shade(renderer, game_->world(), now.soles, 0.42);
    platformer::draw(renderer, pose_before_, pose_, blend, {.opacity = camera_.opacity});
    if (ghost_) platformer::draw(renderer, ghost_->before, ghost_->pose, blend, {.is_ghost = true});
    if (shows_volume) draw_volume(renderer, game_->settings(), game_->hero().body);
}

void Run::retry() {
    recorder_.decide(game::RunDecision::Kind::retry);
    game_->retry();
    stand();
}

void Run::give_up() {
    recorder_.decide(game::RunDecision::Kind::give_up);
    game_->give_up();
}

bool Run::is_at_end() const {
    return is_over_ || (player_ && game_->outcome() == game::Outcome::won);
}

}  // namespace surefoot::platformer
