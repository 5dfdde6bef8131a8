/// Many runs of one level by bots of both kinds, and what came of them.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "playtest/bots/atlas.hpp"
#include "playtest/run.hpp"

namespace surefoot::playtest {

struct CampaignOptions {
    int bots = 4;         ///< by turns a navigator and an explorer [>= 0]
    double hours = 0.25;  ///< of play, all bots together; each plays once at least
    std::uint64_t seed = 1;
    int threads = 2;
    double longest_run = 600;                ///< [s]
    double explorer_run = 240;               ///< so long an explorer stays in one section at most [s]
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

    /// Of all who played. Bots that know the way and people begin at the spawn; explorers play equally long in every
    /// section, so that where they die says how deadly it is, and not how seldom anybody gets there.
    [[nodiscard]] std::vector<std::uint32_t> deaths_by_section() const;
    /// What is wrong with where they die: nobody anywhere, or more than half in one section. Empty if nothing is, or if
    /// explorers have not been in every section and for long enough to say.
    [[nodiscard]] std::string death_fault() const;

    /// Is there something that a person has to look at: not to be finished, stuck, escaped, NaN, deaths?
    [[nodiscard]] bool is_fine() const;
};

/// Of how many died where: what that says about a section.
[[nodiscard]] std::string death_verdict(std::span<const std::uint32_t> deaths_by_section, std::size_t section);

/// Each bot has a number, a share of the hours and seeds of its own: the same options give the same runs, whatever the
/// threads. Fails as the atlas and `Game::start` do.
[[nodiscard]] Expected<Findings> run_campaign(std::shared_ptr<const game::Level> level,
                                              const CampaignOptions& options = {});

/// Which pickups nobody took.
void look_over(Findings& findings);

}  // namespace surefoot::playtest
