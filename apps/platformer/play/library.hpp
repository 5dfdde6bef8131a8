/// The levels that there are to play, read beside the drawing.
#pragma once

#include <atomic>
#include <future>
#include <memory>
#include <string>
#include <vector>

#include "game/level.hpp"
#include "game/progress.hpp"
#include "platformer/screens/menu.hpp"

namespace surefoot::platformer {

class Library {
public:
    /// Begins to read the levels of these folders; of two with one id the later folder's counts. `at_once`: and waits.
    void open(const std::vector<std::string>& folders, bool at_once);

    /// True once, when all are read.
    [[nodiscard]] bool update();
    [[nodiscard]] bool is_ready() const { return ready_; }

    /// In the order of playing: by `order`, secret ones last.
    [[nodiscard]] const std::vector<std::shared_ptr<const game::Level>>& levels() const { return levels_; }
    [[nodiscard]] std::shared_ptr<const game::Level> find(const std::string& id) const;

    /// What could not be read, in words.
    [[nodiscard]] const std::vector<std::string>& complaints() const { return complaints_; }

    /// For the level select. `recordings` is where the best runs are kept.
    [[nodiscard]] std::vector<LevelCard> cards(const game::Progress& progress, const std::string& recordings) const;

private:
    struct Read {
        std::vector<std::shared_ptr<const game::Level>> levels;
        std::vector<std::string> complaints;
    };
    static Read read(const std::vector<std::string>& folders);
    void take(Read read);

    std::future<Read> reading_;
    std::vector<std::shared_ptr<const game::Level>> levels_;
    std::vector<std::string> complaints_;
    bool ready_ = false;
};

/// Where the best run of a level is kept.
[[nodiscard]] std::string best_run_path(const std::string& recordings, const std::string& level);

}  // namespace surefoot::platformer
