#include "game/campaign.hpp"

#include <filesystem>
#include <sstream>

#include "game/whole_file.hpp"

namespace surefoot::game {

std::vector<std::string> campaign_in(const std::string& folder) {
    std::vector<std::string> ids;
    const auto text = read_whole((std::filesystem::path(folder) / "campaign.txt").string());
    if (!text) return ids;
    std::istringstream lines(*text);
    for (std::string line; std::getline(lines, line);) {
        line = line.substr(0, line.find('#'));
        const auto first = line.find_first_not_of(" \t\r");
        if (first != std::string::npos) ids.push_back(line.substr(first, line.find_last_not_of(" \t\r") - first + 1));
    }
    return ids;
}

}  // namespace surefoot::game
