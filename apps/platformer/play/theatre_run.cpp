// The run that the theatre shows: its ticks, its end, and what is kept of it.
#include <algorithm>
#include <cmath>
#include <utility>

#include "game/file_lock.hpp"
#include "platformer/play/theatre.hpp"

namespace surefoot::platformer {
namespace {

constexpr double show_win_after = 2.2;   // [s]: the hero dances first
constexpr double show_lose_after = 1.2;  // [s]
constexpr double pilot_waits = 4;        // [s] on a screen that only somebody who watches could leave
constexpr int pilot_tries = 20;          // from checkpoints, and then the level is too hard for it

}  // namespace

/// Another program may have won something meanwhile.
void Theatre::merge_progress() {
    if (options_.progress.empty()) return;
    if (const auto kept = game::read_progress(options_.progress)) progress_.merge(*kept);
}

void Theatre::keep_run() {
    if (run_->is_watched() || kept_ || run_->game().ticks() == 0) return;
    kept_ = true;
    if (session_) note_wrong(session_->keep_run(run_->recording()));
    const game::Game& game = run_->game();
    if (run_->is_piloted()) {
        (void)progress_.add(game);  // what somebody else did is no progress to keep
        return;
    }
    std::optional<game::FileLock> lock;
    if (!options_.progress.empty()) lock.emplace(options_.progress);
    merge_progress();
    const bool is_best = progress_.add(game);
    if (!options_.progress.empty()) note_wrong(game::write_progress(options_.progress, progress_));
    if (is_best && !options_.recordings.empty())
        note_wrong(game::write_recording(best_run_path(options_.recordings, game.level().id), run_->recording()));
}

void Theatre::end_of_run() {
    const game::Game& game = run_->game();
    const game::Level& level = game.level();
    if (run_->is_watched()) {
        if (run_->is_at_end()) screens_.show_replay_end();
        shown_end_ = run_->is_at_end();
        return;
    }
    if (game.outcome() == game::Outcome::won) {
        WinResult result{.seconds = game.seconds(),
                         .medal = static_cast<Medal>(level.medal(game.seconds())),
                         .coins = game.coins(),
                         .coins_all = level.count(game::PickupKind::coin),
                         .stars = game.stars(),
                         .stars_all = level.count(game::PickupKind::star),
                         .deaths = int(game.deaths())};
        merge_progress();
        const auto before = progress_.levels.find(level.id);
        if (before != progress_.levels.end() && before->second.won) result.best_before = before->second.best_seconds;
        shown_end_ = true;
        keep_run();
        show_cards();
        screens_.show_win(result);
    } else {
        shown_end_ = true;
        screens_.show_lose(
            {.why = "The hero " + std::string(sentence(game.cause())) + ".",
             .section = game.checkpoint() == 0 ? std::string() : level.checkpoints[game.checkpoint()].section,
             .seconds = game.seconds(),
             .can_retry = game.can_retry()});
    }
}

void Theatre::tick_run() {
    Asked asked = controls_.take(screens_.settings(), game::tick_seconds);
    if (asked.retry && run_->game().outcome() == game::Outcome::playing) run_->retry();
    const std::size_t recorded = run_->recording().inputs.size();
    run_->tick(asked, camera_settings_);
    if (session_ && run_->recording().inputs.size() > recorded)
        session_->tick(run_->recording().inputs.back(), run_->game());
    teach();
    ears_.tick(run_->game(), run_->pose_before(), run_->pose());
    ears_.listen(run_->camera_at(1));
    const bool is_over = run_->game().outcome() != game::Outcome::playing || run_->is_at_end();
    over_for_ = is_over ? over_for_ + game::tick_seconds : 0;
    const double wait = run_->game().outcome() == game::Outcome::won ? show_win_after : show_lose_after;
    if (is_over && !shown_end_ && over_for_ >= wait) end_of_run();
}

/// What no level has a place for: it is told when it happens for the first time to whoever plays here.
void Theatre::teach() {
    hint_left_ = run_->game().prompt() == nullptr ? std::max(0.0, hint_left_ - game::tick_seconds) : hint_left_;
    if (run_->is_watched() || run_->is_piloted()) return;
    const auto tell = [&](const char* what, const char* words) {
        if (!progress_.taught.insert(what).second) return;
        hint_ = words;
        hint_left_ = 7;
    };
    for (const game::GameEvent& event : run_->game().events()) {
        if (event.what == game::Happening::hurt || event.what == game::Happening::fell)
            tell("hearts", "That cost a heart. {retry} takes you back to the last flag and costs none.");
        if (event.what == game::Happening::took_star)
            tell("stars", "A star! Three are hidden in each level; twelve open the secret one.");
    }
}

/// A bot has no hands for screens: it tries again, and goes on to the next level.
void Theatre::go_on_by_itself() {
    if (!run_ || !run_->is_piloted() || screens_.is_playing()) return;
    const bool has_lost = screens_.top() == ScreenId::lose;
    if (!has_lost && screens_.top() != ScreenId::win) return;
    idle_ += game::tick_seconds;
    if (idle_ < pilot_waits) return;
    idle_ = 0;
    if (has_lost && run_->game().can_retry() && tries_ < pilot_tries) {
        ++tries_;
        screens_.choose(Act::retry);
    } else if (!has_lost && options_.pilot_goes_on) {
        screens_.choose(Act::next);
    }
}

void Theatre::note_wrong(const Expected<void>& kept) {
    if (!kept) note(kept.error().text);
}

void Theatre::note(const std::string& text) {
    notices_.push_back(text);
    unsaid_.push_back(text);
}

/// Nothing of it stands over the game: it waits for a screen.
void Theatre::show_notices() {
    mark_left_ -= game::tick_seconds;
    if (mark_left_ <= 0) mark_.clear();
    if (screens_.is_playing() || unsaid_.empty() || !screens_.notice().empty()) return;
    screens_.say(unsaid_.front());
    unsaid_.erase(unsaid_.begin());
}

/// What was to be played cannot be, and the reason stays until it was read.
void Theatre::trouble(const std::string& title, const std::string& why) {
    if (std::exchange(is_named_, false) && failure_.empty()) failure_ = why;
    close_run();
    screens_.open_title();
    screens_.show_trouble(title, why);
}

Expected<void> Theatre::keep() {
    if (options_.settings.empty()) return {};
    // A window that is opened is made larger by the scale of its screen, where that counts in pixels.
    const view::dvec2 size = view::dvec2(display_.size()) / display_.scale();
    const view::ivec2 units(int(std::lround(size.x)), int(std::lround(size.y)));
    const bool is_resized = options_.keeps_window && !display_.is_full_screen() &&
                            units != view::ivec2(screens_.settings().width, screens_.settings().height);
    if (is_resized) screens_.set_window_size(units);
    if (!is_resized && settings_kept_) return {};
    return write_game_settings(screens_.settings(), options_.settings);
}

}  // namespace surefoot::platformer
