/// Reads levels beside the drawing, so that the window stays alive.
#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <future>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <surefoot/cook.hpp>
#include <surefoot/error.hpp>

#include "level.hpp"

namespace surefoot::playground {

/// A level with everything that was found out about it.
struct LoadedLevel {
    tools::Level level;
    CookReport report;
};

class LevelLoader {
public:
    using Loaded = std::shared_ptr<const LoadedLevel>;
    using Done = std::function<void(const Loaded& level)>;
    using Failed = std::function<void(const std::string& why)>;

    /// At once and not beside: for runs that have to go the same way every time.
    explicit LevelLoader(bool at_once) : at_once_(at_once) {}

    /// Begins to load; what is loading already is forgotten. One of the two is called by `update`.
    void load(const std::string& path, Done done, Failed failed);

    /// Forgets what is loading: nobody is called back.
    void forget();

    /// Calls back when the level is there; true while one is loading.
    bool update();

    /// What is loading, or empty.
    [[nodiscard]] const std::string& loading() const { return path_; }

    /// What is being done with it, for the user; how much of that is done [per cent], where it is known; and since when
    /// it is loading [s].
    [[nodiscard]] std::string_view step() const;
    [[nodiscard]] std::optional<int> percent() const;
    [[nodiscard]] double seconds() const;

private:
    using Result = Expected<Loaded>;
    /// How far a load has come; its thread writes it. One aligned word, so that clang too needs no lock.
    struct alignas(8) Stage {
        tools::LoadStep step = tools::LoadStep::opening;
        std::int32_t percent = 0;
    };
    static_assert(std::atomic<Stage>::is_always_lock_free);
    using Progress = std::shared_ptr<std::atomic<Stage>>;
    static Result read(const std::string& path, const Progress& progress);

    bool at_once_;
    std::string path_;
    Progress progress_;
    std::chrono::steady_clock::time_point began_;
    std::future<Result> result_;
    std::vector<std::future<Result>> forgotten_;  // a future waits for its thread when it goes
    Done done_;
    Failed failed_;
};

}  // namespace surefoot::playground
