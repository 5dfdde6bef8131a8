#include "platformer/play/library.hpp"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fmt/format.h>
#include <map>
#include <tuple>

namespace surefoot::platformer {

std::string best_run_path(const std::string& recordings, const std::string& level) {
    return (std::filesystem::path(recordings) / (level + ".best.run")).string();
}

Library::Read Library::read(const std::vector<std::string>& folders) {
    Read made;
    std::map<std::string, std::shared_ptr<const game::Level>> by_id;
    for (const std::string& folder : folders)
        for (const std::string& path : game::levels_in(folder)) {
            auto level = game::read_level(path);
            if (!level) {
                made.complaints.push_back(level.error().text);
                continue;
            }
            auto kept = std::make_shared<const game::Level>(std::move(*level));
            by_id.insert_or_assign(kept->id, kept);
        }
    for (auto& [id, level] : by_id) made.levels.push_back(std::move(level));
    std::ranges::stable_sort(made.levels, {}, [](const std::shared_ptr<const game::Level>& level) {
        return std::tuple(level->secret, level->order, level->id);
    });
    return made;
}

void Library::open(const std::vector<std::string>& folders, bool at_once) {
    ready_ = false;
    reading_ = std::async(std::launch::async, read, folders);
    if (at_once) take(reading_.get());
}

void Library::take(Read read) {
    levels_ = std::move(read.levels);
    complaints_ = std::move(read.complaints);
    ready_ = true;
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
    std::vector<const game::Level*> all;
    for (const auto& level : levels_) all.push_back(level.get());
    std::vector<LevelCard> made;
    const game::Level* before = nullptr;
    for (const game::Level* level : all) {
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
                       .locked = !progress.is_open(*level, all),
                       .secret = level->secret};
        if (done.won) card.best = done.best_seconds;
        if (card.locked)
            card.locked_why =
                level->stars_needed > 0
                    ? fmt::format("It opens with {} stars; you have {}.", level->stars_needed, progress.stars())
                    : fmt::format("Win {} first.", before == nullptr ? "another level" : before->title);
        std::error_code error;
        card.has_recording = std::filesystem::exists(best_run_path(recordings, level->id), error);
        if (!level->secret) before = level;
        made.push_back(std::move(card));
    }
    return made;
}

}  // namespace surefoot::platformer
