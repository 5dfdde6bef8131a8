#include "platformer/play/play_session.hpp"

#include <algorithm>
#include <chrono>
#include <ctime>
#include <filesystem>
#include <fmt/chrono.h>
#include <fmt/format.h>

#include "game/whole_file.hpp"

namespace surefoot::platformer {
namespace {

namespace fs = std::filesystem;
using Kind = FormField::Kind;

/// What may stand in the name of a file, everywhere.
std::string plain(const std::string& text) {
    std::string name;
    for (const char letter : text.substr(0, 40)) {
        const bool is_plain = (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') ||
                              (letter >= '0' && letter <= '9') || letter == '_';
        if (is_plain)
            name += letter;
        else if (!name.empty() && name.back() != '-')
            name += '-';
    }
    while (!name.empty() && name.back() == '-') name.pop_back();
    return name.empty() ? "player" : name;
}

/// `name`, or `name-2` and so on: the first that is free.
template <typename IsTaken>
std::string free_name(const std::string& name, const IsTaken& is_taken) {
    if (!is_taken(name)) return name;
    for (int i = 2;; ++i)
        if (std::string next = fmt::format("{}-{}", name, i); !is_taken(next)) return next;
}

FormField choice(const char* key, const char* label, std::vector<std::string> choices) {
    return {.kind = Kind::choice, .key = key, .label = label, .choices = std::move(choices), .required = true};
}

/// A question of the end, from 1 to 5: nobody is made to answer.
FormField question(const char* key, const char* label, const char* hint) {
    return {.kind = Kind::choice, .key = key, .label = label, .hint = hint, .choices = {"1", "2", "3", "4", "5"}};
}

int mark_of(const FormField& field) {
    return field.chosen ? static_cast<int>(*field.chosen) + 1 : 0;
}

}  // namespace

std::string today() {
    return fmt::format("{:%Y-%m-%d}", fmt::localtime(std::time(nullptr)));
}

Form PlaySession::start_form() {
    return {.id = "start",
            .title = "Before you play",
            .subtitle = "We test the game and not you.",
            .words = {"Kept in a folder on this machine: what you press, where you go in the game,",
                      "notes of whoever sits beside you, and your answers. Nothing is sent anywhere.",
                      "You may stop at any time, and have the folder deleted."},
            .fields = {{.kind = Kind::line,
                        .key = "player",
                        .label = "Your name, or a letter",
                        .hint = "Type it. Left and right go from letter to letter.",
                        .required = true},
                       choice("plays", "How often do you play games?", {"never", "sometimes", "often"}),
                       choice("device", "With what do you play now?", {"keyboard", "keyboard and mouse", "gamepad"}),
                       {.kind = Kind::agree, .key = "before", .label = "I have played this game before"},
                       {.kind = Kind::agree,
                        .key = "consent",
                        .label = "I agree that this is kept",
                        .hint = "Without it nothing is kept, and the session does not begin.",
                        .required = true}},
            .done = "Begin",
            .dismiss = "Not now"};
}

Form PlaySession::note_form() {
    return {.id = "note",
            .title = "A note",
            .subtitle = "The game waits. A word is enough.",
            .fields = {{.kind = Kind::line,
                        .key = "text",
                        .label = "What happened?",
                        .hint = "Enter keeps it, Escape forgets it. F10 marks a moment without words.",
                        .required = true}},
            .done = "Keep it",
            .dismiss = "Forget it"};
}

Form PlaySession::end_form() {
    return {.id = "end",
            .title = "How was it?",
            .subtitle = "From 1 to 5. What you do not want to answer stays open.",
            .fields = {question("fun", "Was it fun?", "1: not at all. 5: very much."),
                       question("difficulty", "How hard was it?", "1: too easy. 3: right. 5: too hard."),
                       question("control", "Did the hero do what you wanted?", "1: never. 5: as if by itself."),
                       question("way", "Did you know where to go?", "1: never. 5: always."),
                       question("again", "Would you go on playing?", "1: no. 5: at once."),
                       {.kind = Kind::line,
                        .key = "remark",
                        .label = "Anything else?",
                        .hint = "What was best, what was worst, where were you lost?"}},
            .done = "Done, thank you",
            .dismiss = "Leave it open"};
}

Expected<void> PlaySession::begin(const Form& start, const std::string& day) {
    const FormField& plays = start["plays"];
    const FormField& device = start["device"];
    session_.start = {.player = start["player"].text,
                      .plays_games = plays.value(),
                      .device = device.value(),
                      .played_before = start["before"].agreed,
                      .consent = start["consent"].agreed};
    const auto in_afternoon = [&](const std::string& name) { return (fs::path(afternoon_) / name).string(); };
    const std::string name = free_name(day + "-" + plain(session_.start.player), [&](const std::string& taken) {
        std::error_code error;
        return fs::exists(in_afternoon(taken), error);
    });
    session_.folder = in_afternoon(name);
    auto written = playtest::write_session(session_);
    if (!written) session_.folder.clear();
    return written;
}

bool PlaySession::is_taken(const std::string& run) const {
    return std::ranges::find(session_.runs, run) != session_.runs.end();
}

void PlaySession::begin_run(const game::Level& level) {
    if (!has_begun()) return;
    run_ = free_name(plain(level.id), [&](const std::string& name) { return is_taken(name); });
    observer_.emplace(level, session_.start.player);
}

void PlaySession::tick(const game::HeroInput& input, const game::Game& game) {
    if (observer_) observer_->tick(input, game);
}

Expected<void> PlaySession::keep_run(const game::Recording& recording) {
    if (run_.empty()) return {};
    const std::string stem = (fs::path(session_.folder) / run_).string();
    auto written = game::write_recording(stem + ".run", recording);
    if (written) written = game::write_whole(stem + ".json", playtest::to_json(observer_->telemetry()) + "\n");
    // It is named only when it is there, so that whoever reads finds all that is named.
    if (written) {
        session_.runs.push_back(run_);
        written = playtest::write_session(session_);
    }
    run_.clear();
    observer_.reset();
    return written;
}

Expected<void> PlaySession::note(const std::string& text, double seconds) {
    session_.notes.push_back({.run = run_, .seconds = run_.empty() ? 0 : seconds, .text = text});
    return playtest::write_session(session_);
}

Expected<void> PlaySession::answer(const Form& end) {
    session_.answers = {.fun = mark_of(end["fun"]),
                        .difficulty = mark_of(end["difficulty"]),
                        .control = mark_of(end["control"]),
                        .way = mark_of(end["way"]),
                        .again = mark_of(end["again"]),
                        .remark = end["remark"].text};
    return playtest::write_session(session_);
}

}  // namespace surefoot::platformer
