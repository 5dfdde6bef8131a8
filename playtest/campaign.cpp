#include "playtest/campaign.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <mutex>
#include <optional>
#include <thread>

#include "playtest/explorer.hpp"
#include "playtest/navigator.hpp"

namespace surefoot::playtest {
namespace {

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
        // Every other navigator takes what lies about: where nobody gets to a coin, somebody tried.
        auto made = Navigator::make(atlas_, {.seed = seed, .collects = bot % 4 == 2});
        if (!made) return tl::unexpected(made.error());
        return std::unique_ptr<Bot>(std::move(*made));
    }

    [[nodiscard]] Expected<void> play_one(int bot) {
        const double share = options_.hours * 3600 / options_.bots;
        double played = 0;
        for (std::uint64_t turn = 0; turn == 0 || played < share; ++turn) {
            const std::uint64_t seed = options_.seed * 1000003 + std::uint64_t(bot) * 7919 + turn;
            auto player = make(bot, seed);
            if (!player) return tl::unexpected(player.error());
            const double longest = bot % 2 == 1 ? options_.explorer_run : options_.longest_run;
            auto run = play(level_, **player, {.most_seconds = longest});
            if (!run) return tl::unexpected(run.error());
            played += run->telemetry.seconds;
            runs_[std::size_t(bot)].push_back({std::move(run->telemetry), std::move(run->recording)});
            const std::lock_guard lock(mutex_);
            told_ += runs_[std::size_t(bot)].back().telemetry.seconds;
            if (options_.progress) options_.progress(std::min(1.0, told_ / std::max(1.0, options_.hours * 3600)));
            if (runs_[std::size_t(bot)].back().telemetry.seconds == 0) break;  // it gave up before it began
        }
        return {};
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
           navigators_won() == navigators();
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
