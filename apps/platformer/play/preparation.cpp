#include "platformer/play/preparation.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

namespace surefoot::platformer {

template <typename Made>
bool Job<Made>::is_ready() const {
    return made.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
}

Preparation::~Preparation() {
    forget();
    if (warmed_) *warmed_->stop = true;
}

void Preparation::forget() {
    if (!asked_) return;
    *asked_->stop = true;
    forgotten_.push_back(std::move(*asked_));
    asked_.reset();
}

void Preparation::ask(Run::Plan plan, double seconds) {
    forget();
    Asked& job = asked_.emplace();
    // What is being looked for already is not looked for twice, and what nobody waits for makes way.
    std::shared_future<void> before;
    if (is_warming() && warmed_level_ == plan.level)
        before = warmed_->made;
    else if (is_warming())
        *warmed_->stop = true;
    job.made = std::async(std::launch::async, [plan = std::move(plan), before, stop = job.stop]() mutable {
        if (before.valid()) before.wait();
        return Run::prepare(std::move(plan), stop.get());
    });
    (void)job.made.wait_for(std::chrono::duration<double>(seconds));
}

std::optional<Expected<Run::Prepared>> Preparation::take() {
    std::erase_if(forgotten_, [](const Asked& job) { return job.is_ready(); });
    if (!asked_ || !asked_->is_ready()) return std::nullopt;
    Expected<Run::Prepared> made = asked_->made.get();
    asked_.reset();
    return made;
}

void Preparation::warm(const std::shared_ptr<const game::Level>& level) {
    if (is_warming() || !has_jumpers(*level)) return;
    Warmed& job = warmed_.emplace();
    warmed_level_ = level;
    job.made = std::async(std::launch::async, [level, stop = job.stop] {
                   (void)game::Game::start(level, {.stop = stop.get()});  // what goes wrong is told when it is played
               }).share();
}

bool has_jumpers(const game::Level& level) {
    return std::ranges::any_of(level.enemies,
                               [](const game::EnemyPlan& plan) { return plan.kind == game::EnemyKind::jumper; });
}

bool Preparation::is_warming() const {
    return warmed_ && !warmed_->is_ready();
}

}  // namespace surefoot::platformer
