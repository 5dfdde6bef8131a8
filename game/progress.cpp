#include "game/progress.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "game/whole_file.hpp"

namespace surefoot::game {

int Progress::stars() const {
    int sum = 0;
    for (const auto& [id, level] : levels) sum += int(level.stars.size());
    return sum;
}

bool Progress::is_open(const Level& level, std::span<const Level* const> campaign) const {
    const auto is_won = [&](const Level& one) {
        const auto found = levels.find(one.id);
        return found != levels.end() && found->second.won;
    };
    if (is_won(level)) return true;
    if (level.secret || level.stars_needed > 0) return stars() >= level.stars_needed;
    const Level* before = nullptr;
    for (const Level* other : campaign) {
        if (other == &level) return before == nullptr || is_won(*before);
        if (!other->secret) before = other;
    }
    return true;
}

bool Progress::add(const Game& game) {
    const Level& level = game.level();
    LevelProgress& progress = levels[level.id];
    ++progress.runs;
    progress.deaths += game.deaths();
    if (game.outcome() != Outcome::won || game.begun_at() != 0) return false;
    std::uint32_t order = 0;
    for (std::uint32_t plan = 0; plan < level.pickups.size(); ++plan) {
        if (level.pickups[plan].kind != PickupKind::star) continue;
        if (game.has_star(plan)) progress.stars.insert(order);
        ++order;
    }
    progress.best_coins = std::max(progress.best_coins, game.coins());
    const bool is_best = !progress.won || game.seconds() < progress.best_seconds;
    progress.won = true;
    if (is_best) progress.best_seconds = game.seconds();
    progress.medal = std::max(progress.medal, level.medal(game.seconds()));
    return is_best;
}

void Progress::merge(const Progress& other) {
    for (const auto& [id, theirs] : other.levels) {
        LevelProgress& ours = levels[id];
        if (theirs.won && (!ours.won || theirs.best_seconds < ours.best_seconds))
            ours.best_seconds = theirs.best_seconds;
        ours.won = ours.won || theirs.won;
        ours.medal = std::max(ours.medal, theirs.medal);
        ours.best_coins = std::max(ours.best_coins, theirs.best_coins);
        ours.stars.insert(theirs.stars.begin(), theirs.stars.end());
        ours.runs = std::max(ours.runs, theirs.runs);
        ours.deaths = std::max(ours.deaths, theirs.deaths);
    }
    taught.insert(other.taught.begin(), other.taught.end());
}

Expected<Progress> read_progress(const std::string& path) {
    const auto text = read_whole(path);
    if (!text) return Progress{};
    const auto damaged = [&] {
        return tl::unexpected(Error{ErrorCode::unreadable,
                                    path + ": the progress is damaged, so the game begins anew; the file is replaced "
                                           "when a level ends: copy it first if you want to mend it",
                                    path, 0});
    };
    const auto json = nlohmann::json::parse(*text, nullptr, false);
    if (!json.is_object()) return damaged();
    Progress made;
    try {
        for (const auto& [id, level] : json.at("levels").items()) {
            LevelProgress progress;
            progress.won = level.at("won").get<bool>();
            progress.best_seconds = level.at("best_seconds").get<double>();
            progress.medal = static_cast<Medal>(std::clamp(level.at("medal").get<int>(), 0, 3));
            progress.best_coins = level.at("best_coins").get<int>();
            progress.stars = level.at("stars").get<std::set<std::uint32_t>>();
            progress.runs = level.at("runs").get<std::uint32_t>();
            progress.deaths = level.at("deaths").get<std::uint32_t>();
            made.levels[id] = std::move(progress);
        }
        made.taught = json.value("taught", std::set<std::string>{});
    } catch (const nlohmann::json::exception&) {
        return damaged();
    }
    return made;
}

Expected<void> write_progress(const std::string& path, const Progress& progress) {
    nlohmann::json levels = nlohmann::json::object();
    for (const auto& [id, level] : progress.levels)
        levels[id] = {{"won", level.won},          {"best_seconds", level.best_seconds},
                      {"medal", int(level.medal)}, {"best_coins", level.best_coins},
                      {"stars", level.stars},      {"runs", level.runs},
                      {"deaths", level.deaths}};
    const nlohmann::json json{{"version", 1}, {"levels", levels}, {"taught", progress.taught}};
    return write_whole(path, json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
}

}  // namespace surefoot::game
