#include "playground/level_loader.hpp"

#include <chrono>
#include <new>

#include "command.hpp"

namespace surefoot::playground {

LevelLoader::Result LevelLoader::read(const std::string& path, const Progress& progress) {
    const auto failed = [&](const std::string& text) {
        return tl::unexpected(Error{ErrorCode::unreadable, text, path, 0});
    };
    try {
        tools::LevelOptions options;
        options.file = path;
        auto level = std::make_shared<LoadedLevel>(
            LoadedLevel{tools::load_level(options,
                                          [&](tools::LoadStep step, double done) {
                                              progress->store({step, static_cast<std::int32_t>(100 * done)});
                                          }),
                        {}});
        const auto report = cook_report(level->level.mesh);
        if (!report) return failed(path + ": " + report.error().text);
        level->report = *report;
        return Loaded(std::move(level));
    } catch (const tools::Failure& failure) {
        return failed(failure.text);
    } catch (const std::bad_alloc&) {
        return failed(path + ": the level is too large for this machine's memory");
    }
}

void LevelLoader::load(const std::string& path, Done done, Failed failed) {
    forget();
    path_ = path;
    progress_ = std::make_shared<std::atomic<Stage>>(Stage{});
    began_ = std::chrono::steady_clock::now();
    done_ = std::move(done);
    failed_ = std::move(failed);
    result_ = std::async(at_once_ ? std::launch::deferred : std::launch::async, read, path, progress_);
}

void LevelLoader::forget() {
    if (result_.valid()) forgotten_.push_back(std::move(result_));
    result_ = {};
    path_.clear();
    done_ = nullptr;
    failed_ = nullptr;
}

std::string_view LevelLoader::step() const {
    if (path_.empty()) return {};
    switch (progress_->load().step) {
        case tools::LoadStep::reading:
            return "reading";
        case tools::LoadStep::cooking:
            return "cooking";
        case tools::LoadStep::opening:
            break;
    }
    return "opening";
}

std::optional<int> LevelLoader::percent() const {
    if (path_.empty()) return std::nullopt;
    const Stage stage = progress_->load();
    return stage.step == tools::LoadStep::cooking ? std::optional<int>(stage.percent) : std::nullopt;
}

double LevelLoader::seconds() const {
    if (path_.empty()) return 0;
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - began_).count();
}

bool LevelLoader::update() {
    const auto ready = [](const std::future<Result>& f) {
        return f.wait_for(std::chrono::seconds(0)) != std::future_status::timeout;
    };
    std::erase_if(forgotten_, ready);
    if (!result_.valid()) return false;
    if (!ready(result_)) return true;
    const Result result = result_.get();
    path_.clear();
    // Either may load the next one.
    if (result) {
        const Done done = std::move(done_);
        done(*result);
    } else {
        const Failed failed = std::move(failed_);
        failed(result.error().text);
    }
    return result_.valid();
}

}  // namespace surefoot::playground
