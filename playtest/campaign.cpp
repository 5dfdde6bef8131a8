#include "playtest/campaign.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <mutex>
#include <optional>
#include <thread>

#include "playtest/bots/explorer.hpp"
#include "playtest/bots/navigator.hpp"

namespace surefoot::playtest {
namespace {

constexpr int most_runs = 100;  // of one explorer in a section at a time: who begins beside the next is there at once
constexpr double shortest_round = 120;   // of a collector from one checkpoint [s]
constexpr double enough_to_judge = 300;  // of explorers, where deaths are [s]
constexpr double shortest_stay = 20;     // of an explorer in a section, in a short campaign [s]

class Campaign {
public:
    Campaign(std::shared_ptr<const game::Level> level, std::shared_ptr<const Atlas> atlas,
             const CampaignOptions& options)
        : level_(std::move(level)), atlas_(std::move(atlas)), options_(options), runs_(std::size_t(options.bots)) {}

    [[nodiscard]] Expected<void> play_all() {
        std::vector<std::jthread> helpers;
        for (int i = 1; i < std::min(options_.threads, options_.bots); ++i) helpers.emplace_back([this] { work(); });
        work();
        helpers.clear();
        if (error_) return tl::unexpected(*error_);
        return {};
    }

    void take(Findings& into) {
        for (std::vector<PlayedRun>& of : runs_)
            for (PlayedRun& run : of) {
                into.played += run.telemetry.seconds;
                into.runs.push_back(std::move(run));
            }
    }

private:
    void work() {
        for (int bot = next_++; bot < options_.bots; bot = next_++)
            if (const auto played = play_one(bot); !played) {
                const std::lock_guard lock(mutex_);
                error_ = played.error();
            }
    }

    [[nodiscard]] Expected<std::unique_ptr<Bot>> make(int bot, std::uint64_t seed) const {
        if (bot % 2 == 1) return std::make_unique<Explorer>(seed);
        auto made = Navigator::make(atlas_, {.seed = seed, .collects = collects(bot)});
        if (!made) return tl::unexpected(made.error());
        return std::unique_ptr<Bot>(std::move(*made));
    }

    [[nodiscard]] Expected<void> play_one(int bot) {
        if (bot % 2 == 1) return explore(bot);
        return collects(bot) ? collect(bot) : navigate(bot);
    }

    // Every other navigator takes what lies about: where nobody gets to a coin, somebody tried.
    [[nodiscard]] static bool collects(int bot) { return bot % 4 == 2; }

    [[nodiscard]] Expected<void> navigate(int bot) {
        const double share = options_.hours * 3600 / options_.bots;
        double played = 0;
        for (std::uint64_t turn = 0; turn == 0 || played < share; ++turn) {
            const auto seconds = play_once(bot, turn, {.most_seconds = options_.longest_run});
            if (!seconds) return tl::unexpected(seconds.error());
            if (*seconds == 0) break;  // it gave up before it began
            played += *seconds;
        }
        return {};
    }

    // From the spawn, and then from every checkpoint in turn: what hangs late in a level is gone for, too.
    [[nodiscard]] Expected<void> collect(int bot) {
        const double share = options_.hours * 3600 / options_.bots;
        const auto sections = std::uint64_t(level_->checkpoints.size());
        const double longest =
            std::clamp(share / double(sections), std::min(shortest_round, options_.longest_run), options_.longest_run);
        double played = 0;
        for (std::uint64_t turn = 0; turn == 0 || played < share; ++turn) {
            const auto begins_at = std::uint32_t((turn + std::uint64_t(bot / 4) * (sections / 2)) % sections);
            const auto seconds = play_once(bot, turn, {.most_seconds = longest, .checkpoint = begins_at});
            if (!seconds) return tl::unexpected(seconds.error());
            if (*seconds == 0) break;
            played += *seconds;
        }
        return {};
    }

    // In every section for the same time, whatever becomes of it there: where an explorer dies says something about the
    // section then, and not about how seldom it gets that far.
    [[nodiscard]] Expected<void> explore(int bot) {
        const double share = options_.hours * 3600 / options_.bots;
        const double sections = double(level_->checkpoints.size());
        const double rounds = std::max(1.0, std::ceil(share / (sections * options_.explorer_run)));
        const double stay = std::max(share / (sections * rounds), std::min(shortest_stay, options_.explorer_run));
        const auto turns = std::max<std::uint64_t>(1, std::uint64_t(std::round(share / stay)));
        std::uint64_t runs = 0;
        for (std::uint64_t turn = 0; turn < turns; ++turn) {
            const auto section = std::uint32_t((std::uint64_t(bot / 2) + turn) % level_->checkpoints.size());
            double played = 0;
            for (int i = 0; i < most_runs && played < stay - 0.5; ++i) {
                const auto seconds =
                    play_once(bot, runs++, {.most_seconds = stay - played, .checkpoint = section, .one_section = true});
                if (!seconds) return tl::unexpected(seconds.error());
                played += *seconds;
            }
        }
        return {};
    }

    // How long it played [s].
    [[nodiscard]] Expected<double> play_once(int bot, std::uint64_t turn, const RunOptions& how) {
        const std::uint64_t seed = options_.seed * 1000003 + std::uint64_t(bot) * 7919 + turn;
        auto player = make(bot, seed);
        if (!player) return tl::unexpected(player.error());
        auto run = play(level_, **player, how);
        if (!run) return tl::unexpected(run.error());
        const double seconds = run->telemetry.seconds;
        runs_[std::size_t(bot)].push_back({std::move(run->telemetry), std::move(run->recording)});
        const std::lock_guard lock(mutex_);
        told_ += seconds;
        if (options_.progress) options_.progress(std::min(1.0, told_ / std::max(1.0, options_.hours * 3600)));
        return seconds;
    }

    std::shared_ptr<const game::Level> level_;
    std::shared_ptr<const Atlas> atlas_;
    CampaignOptions options_;
    std::vector<std::vector<PlayedRun>> runs_;
    std::atomic<int> next_ = 0;
    std::mutex mutex_;
    std::optional<Error> error_;
    double told_ = 0;
};

}  // namespace

std::size_t Findings::count(Incident::Kind kind) const {
    std::size_t sum = 0;
    for (const PlayedRun& run : runs) sum += run.telemetry.count(kind);
    return sum;
}

std::size_t Findings::navigators() const {
    return std::size_t(
        std::ranges::count(runs, "navigator", [](const PlayedRun& run) { return run.telemetry.player; }));
}

std::size_t Findings::navigators_won() const {
    return std::size_t(std::ranges::count_if(
        runs, [](const PlayedRun& run) { return run.telemetry.player == "navigator" && run.telemetry.won; }));
}

bool Findings::is_fine() const {
    return unreachable.empty() && count(Incident::Kind::stuck) == 0 && count(Incident::Kind::escape) == 0 &&
           count(Incident::Kind::not_a_number) == 0 && count(Incident::Kind::overflow) == 0 &&
           navigators_won() == navigators() && death_fault().empty();
}

std::vector<std::uint32_t> Findings::deaths_by_section() const {
    std::vector<std::uint32_t> deaths(level->checkpoints.size(), 0);
    for (const PlayedRun& run : runs)
        for (std::size_t i = 0; i < std::min(deaths.size(), run.telemetry.section_deaths.size()); ++i)
            deaths[i] += run.telemetry.section_deaths[i];
    return deaths;
}

std::string Findings::death_fault() const {
    std::vector<bool> explored(level->checkpoints.size(), false);
    double seconds = 0;
    for (const PlayedRun& run : runs) {
        if (run.telemetry.player != "explorer") continue;
        explored[run.telemetry.begun_in] = true;
        seconds += run.telemetry.seconds;
    }
    if (seconds < enough_to_judge || std::ranges::find(explored, false) != explored.end()) return {};
    const std::vector<std::uint32_t> deaths = deaths_by_section();
    for (std::size_t i = 0; i < deaths.size(); ++i)
        if (std::string verdict = death_verdict(deaths, i); !verdict.empty())
            return level->checkpoints[i].section + ": " + verdict;
    return {};
}

std::string death_verdict(std::span<const std::uint32_t> deaths, std::size_t section) {
    std::uint32_t all = 0;
    for (const std::uint32_t of : deaths) all += of;
    if (all == 0) return "nobody dies anywhere: is it too easy?";
    if (deaths.size() > 1 && all >= 4 && 2 * deaths[section] > all) return "more than half of all deaths are here";
    return "";
}

void look_over(Findings& findings) {
    const std::vector<game::PickupPlan>& pickups = findings.level->pickups;
    std::vector<bool> taken(pickups.size(), false);
    for (const PlayedRun& run : findings.runs)
        for (const std::uint32_t pickup : run.telemetry.taken)
            if (pickup < taken.size()) taken[pickup] = true;
    findings.never_taken.clear();
    for (std::uint32_t i = 0; i < pickups.size(); ++i)
        if (!taken[i] && pickups[i].kind != game::PickupKind::heart) findings.never_taken.push_back(i);
}

Expected<Findings> run_campaign(std::shared_ptr<const game::Level> level, const CampaignOptions& options) {
    Findings findings{.level = level};
    auto atlas = Atlas::make(level, {.threads = options.threads});
    if (!atlas) return tl::unexpected(atlas.error());
    findings.atlas_seconds = (*atlas)->seconds();
    if (options.bots == 0) {  // people alone
        look_over(findings);
        return findings;
    }
    const auto first = Navigator::make(*atlas, {.seed = options.seed});
    if (!first) return tl::unexpected(first.error());
    findings.unreachable = (*first)->gave_up();

    const auto start = std::chrono::steady_clock::now();
    Campaign campaign(std::move(level), *atlas, options);
    if (auto played = campaign.play_all(); !played) return tl::unexpected(played.error());
    findings.took = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    campaign.take(findings);
    look_over(findings);
    return findings;
}

}  // namespace surefoot::playtest
