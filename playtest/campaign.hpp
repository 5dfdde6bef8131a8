/// Many runs of one level by bots of both kinds, and what came of them.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "playtest/atlas.hpp"
#include "playtest/run.hpp"

namespace surefoot::playtest {

struct CampaignOptions {
    int bots = 4;         ///< by turns a navigator and an explorer [>= 0]
    double hours = 0.25;  ///< of play, all bots together; each plays once at least
    std::uint64_t seed = 1;
    int threads = 2;
    double longest_run = 600;                ///< [s]
    double explorer_run = 240;               ///< [s]
    std::function<void(double)> progress{};  ///< [0 to 1]; called by one thread at a time
};

/// A run as it is kept.
struct PlayedRun {
    Telemetry telemetry;
    game::Recording recording;
    bool by_human = false;
};

struct Findings {
    std::shared_ptr<const game::Level> level;
    std::vector<PlayedRun> runs{};
    std::string unreachable{};  ///< why the goal is; empty if it is not
    double played = 0;          ///< [s of play]
    double took = 0;            ///< [s of the clock], all threads at once
    double atlas_seconds = 0;
    std::vector<std::uint32_t> never_taken{};  ///< coins, stars and keys that no run reached, of `Level::pickups`

    [[nodiscard]] std::size_t count(Incident::Kind kind) const;
    [[nodiscard]] std::size_t navigators() const;  ///< runs of those
    [[nodiscard]] std::size_t navigators_won() const;
    /// Is there something that a person has to look at: not to be finished, stuck, escaped, NaN?
    [[nodiscard]] bool is_fine() const;
};

/// Each bot has a number, a share of the hours and seeds of its own: the same options give the same runs, whatever the
/// threads. Fails as the atlas and `Game::start` do.
[[nodiscard]] Expected<Findings> run_campaign(std::shared_ptr<const game::Level> level,
                                              const CampaignOptions& options = {});

/// Which pickups nobody took.
void look_over(Findings& findings);

}  // namespace surefoot::playtest
