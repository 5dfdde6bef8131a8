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
    /// A file that is no level, and why.
    struct Broken {
        std::string file;
        std::string why;
    };

    /// Begins to read the levels of these folders, and `file` alone of its folder (empty: none); of two with one id the
    /// later one counts. `at_once`: and waits.
    void open(const std::vector<std::string>& folders, const std::string& file, bool at_once);

    /// True once, when all are read.
    [[nodiscard]] bool update();
    [[nodiscard]] bool is_ready() const { return ready_; }

    /// In the order of playing: those of the campaign, then the player's own by their `order`; secret ones last of
    /// each.
    [[nodiscard]] const std::vector<std::shared_ptr<const game::Level>>& levels() const { return levels_; }
    [[nodiscard]] std::shared_ptr<const game::Level> find(const std::string& id) const;

    /// What could not be read.
    [[nodiscard]] const std::vector<Broken>& broken() const { return broken_; }

    /// For the level select. `recordings` is where the best runs are kept.
    [[nodiscard]] std::vector<LevelCard> cards(const game::Progress& progress, const std::string& recordings) const;

private:
    struct Read {
        std::vector<std::shared_ptr<const game::Level>> levels;
        std::vector<std::string> campaign;
        std::vector<Broken> broken;
    };
    static Read read(const std::vector<std::string>& folders, const std::string& file);
    [[nodiscard]] bool is_own(const game::Level& level) const;
    void take(Read read);

    std::future<Read> reading_;
    std::vector<std::shared_ptr<const game::Level>> levels_;
    std::vector<std::string> campaign_;  // ids
    std::vector<Broken> broken_;
    bool ready_ = false;
};

/// Where the best run of a level is kept.
[[nodiscard]] std::string best_run_path(const std::string& recordings, const std::string& level);

}  // namespace surefoot::platformer
