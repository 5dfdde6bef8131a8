/// Games made ready beside the drawing: where enemies jump, the ways they take are looked for when their level is begun
/// for the first time, and that takes seconds.
#pragma once

#include <atomic>
#include <future>
#include <memory>
#include <optional>
#include <vector>

#include "platformer/play/run.hpp"

namespace surefoot::platformer {

/// Something that is being made on another thread, and may be stopped.
template <typename Made>
struct Job {
    std::shared_ptr<std::atomic<bool>> stop = std::make_shared<std::atomic<bool>>(false);
    Made made{};
    [[nodiscard]] bool is_ready() const;
};

class Preparation {
public:
    Preparation() = default;
    ~Preparation();
    Preparation(const Preparation&) = delete;
    Preparation& operator=(const Preparation&) = delete;

    /// In place of what was asked for before. Waits for it for up to `seconds`.
    void ask(Run::Plan plan, double seconds);

    /// Nobody waits any more for what was asked for.
    void forget();
    [[nodiscard]] bool is_asked() const { return asked_.has_value(); }

    /// What was asked for, once, when it is ready.
    [[nodiscard]] std::optional<Expected<Run::Prepared>> take();

    /// Looks for what is kept on disk, so that a level can be begun at once later. Does nothing for a level that has
    /// nothing to look for, and while it is at another.
    void warm(const std::shared_ptr<const game::Level>& level);
    [[nodiscard]] bool is_warming() const;

private:
    using Asked = Job<std::future<Expected<Run::Prepared>>>;
    using Warmed = Job<std::shared_future<void>>;

    std::optional<Asked> asked_;
    std::vector<Asked> forgotten_;  // until they notice
    std::optional<Warmed> warmed_;
    std::shared_ptr<const game::Level> warmed_level_;
};

/// Does its first start take long?
[[nodiscard]] bool has_jumpers(const game::Level& level);

}  // namespace surefoot::platformer
