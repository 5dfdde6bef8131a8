/// What the runs say, as one page that needs nothing else: numbers, plans, heat maps, incidents with their replays.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "playtest/campaign.hpp"
#include "playtest/session.hpp"

namespace surefoot::playtest {

/// A file that the page refers to, to be written beside it.
struct ReportFile {
    std::string name;  ///< within the report's folder of files
    std::size_t level = 0;
    std::size_t run = 0;
    std::optional<std::size_t> incident{};  ///< a step's capture; else the run's recording
};

struct Report {
    std::string html;
    std::vector<ReportFile> files;
};

/// `folder`: how the page calls the folder of its files, beside it.
[[nodiscard]] Report make_report(std::span<const Findings> levels, std::span<const Session> sessions,
                                 const std::string& folder);

/// Writes the page and its files. Fails with `write_failed`.
[[nodiscard]] Expected<void> write_report(const std::string& path, std::span<const Findings> levels,
                                          std::span<const Session> sessions = {});

}  // namespace surefoot::playtest
