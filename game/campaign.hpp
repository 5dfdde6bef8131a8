/// Which levels are played one after the other. All others are somebody's own: they are open from the beginning.
#pragma once

#include <string>
#include <vector>

namespace surefoot::game {

/// The ids in a folder's `campaign.txt`, one a line, in the order of playing; `#` begins a remark. None if there is no
/// such file.
[[nodiscard]] std::vector<std::string> campaign_in(const std::string& folder);

}  // namespace surefoot::game
