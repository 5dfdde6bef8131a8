/// What the runs say, as one page that needs nothing else: numbers, plans, heat maps, incidents with their replays.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "playtest/campaign.hpp"
#include "playtest/session.hpp"

namespace surefoot::playtest {

/// A file that found no room in the page, to be written beside it.
struct ReportFile {
    std::string name;  ///< within the report's folder of files
    std::string bytes;
};

struct ReportOptions {
    int framed = 10;                         ///< places of a level of which frames are drawn [>= 0]
    std::size_t most_bytes = 10'000'000;     ///< of the page, as long as its text alone is no longer
    std::function<void(double)> progress{};  ///< [0 to 1]; called between incidents' runs
};

struct Report {
    std::string html;
    std::vector<ReportFile> files;
};

/// `folder`: how the page calls the folder of its files, beside it. Plays the runs again whose incidents it shows.
[[nodiscard]] Report make_report(std::span<const Findings> levels, std::span<const Session> sessions,
                                 const std::string& folder, const ReportOptions& options = {});

/// Writes the page, and its files if there are any. Fails with `write_failed`.
[[nodiscard]] Expected<void> write_report(const std::string& path, std::span<const Findings> levels,
                                          std::span<const Session> sessions = {}, const ReportOptions& options = {});

}  // namespace surefoot::playtest
