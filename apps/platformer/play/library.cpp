#include "platformer/play/library.hpp"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fmt/format.h>
#include <map>
#include <tuple>

#include "game/campaign.hpp"

namespace surefoot::platformer {

std::string best_run_path(const std::string& recordings, const std::string& level) {
    return (std::filesystem::path(recordings) / (level + ".best.run")).string();
}

Library::Read Library::read(const std::vector<std::string>& folders, const std::string& file) {
    Read made;
    std::map<std::string, std::shared_ptr<const game::Level>> by_id;
    const auto take = [&](const std::string& path) {
        auto level = game::read_level(path);
        if (!level) {
            made.broken.push_back({path, level.error().text});
            return;
        }
        auto kept = std::make_shared<const game::Level>(std::move(*level));
        by_id.insert_or_assign(kept->id, kept);
    };
    for (const std::string& folder : folders) {
        for (const std::string& id : game::campaign_in(folder)) made.campaign.push_back(id);
        for (const std::string& path : game::levels_in(folder)) take(path);
    }
    if (!file.empty()) take(file);
    for (auto& [id, level] : by_id) made.levels.push_back(std::move(level));
    std::ranges::stable_sort(made.levels, {}, [&](const std::shared_ptr<const game::Level>& level) {
        const auto place = std::ranges::find(made.campaign, level->id) - made.campaign.begin();
        return std::tuple(place == std::ssize(made.campaign), level->secret, place, level->order, level->id);
    });
    return made;
}

void Library::open(const std::vector<std::string>& folders, const std::string& file, bool at_once) {
    ready_ = false;
    reading_ = std::async(std::launch::async, read, folders, file);
    if (at_once) take(reading_.get());
}

void Library::take(Read read) {
    levels_ = std::move(read.levels);
    campaign_ = std::move(read.campaign);
    broken_ = std::move(read.broken);
    ready_ = true;
}

bool Library::is_own(const game::Level& level) const {
    return std::ranges::find(campaign_, level.id) == campaign_.end();
}

bool Library::update() {
    if (!reading_.valid() || reading_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return false;
    take(reading_.get());
    return true;
}

std::shared_ptr<const game::Level> Library::find(const std::string& id) const {
    const auto found = std::ranges::find(levels_, id, [](const auto& level) { return level->id; });
    return found == levels_.end() ? nullptr : *found;
}

std::vector<LevelCard> Library::cards(const game::Progress& progress, const std::string& recordings) const {
    std::vector<const game::Level*> campaign;
    for (const auto& level : levels_)
        if (!is_own(*level)) campaign.push_back(level.get());
    std::vector<LevelCard> made;
    const game::Level* before = nullptr;
    for (const auto& level : levels_) {
        const auto found = progress.levels.find(level->id);
        const game::LevelProgress done = found == progress.levels.end() ? game::LevelProgress{} : found->second;
        LevelCard card{.id = level->id,
                       .title = level->title,
                       .idea = level->idea,
                       .gold = level->medals.gold,
                       .silver = level->medals.silver,
                       .bronze = level->medals.bronze,
                       .medal = static_cast<Medal>(done.medal),
                       .stars = int(done.stars.size()),
                       .stars_all = level->count(game::PickupKind::star),
                       .coins = done.best_coins,
                       .coins_all = level->count(game::PickupKind::coin),
                       .locked = !progress.is_open(*level, campaign),
                       .secret = level->secret,
                       .own = is_own(*level)};
        if (done.won) card.best = done.best_seconds;
        if (card.locked)
            card.locked_why =
                level->stars_needed > 0
                    ? fmt::format("It opens with {} stars; you have {}.", level->stars_needed, progress.stars())
                    : fmt::format("Win {} first.", before == nullptr ? "another level" : before->title);
        std::error_code error;
        card.has_recording = std::filesystem::exists(best_run_path(recordings, level->id), error);
        if (!level->secret) before = level.get();
        made.push_back(std::move(card));
    }
    return made;
}

}  // namespace surefoot::platformer
