// The progress of a navigation mesh, part by part.
#pragma once

#include <optional>

#include <surefoot/navigation_check.hpp>

#include "progress.hpp"

namespace surefoot::tools {

/// A bar for each part, one after the other.
class CheckBars {
public:
    void show(NavigationCheckPart part, std::size_t done, std::size_t all) {
        constexpr const char* names[] = {"looking for ground", "looking for links", "walking everywhere", "rehearsing",
                                         "walking random paths"};
        if (!bar_ || part != part_) bar_.emplace(names[static_cast<std::size_t>(part)]);
        part_ = part;
        bar_->show(all == 0 ? 1 : static_cast<double>(done) / static_cast<double>(all));
    }
    void end() { bar_.reset(); }

private:
    std::optional<ProgressBar> bar_;
    NavigationCheckPart part_ = NavigationCheckPart::build;
};

}  // namespace surefoot::tools
