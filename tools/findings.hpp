/// What cooking found, for people and for programs.
#pragma once

#include <string>

#include <surefoot/cook.hpp>

namespace surefoot::tools {

/// A paragraph: what was changed, and each finding with its first places; "nothing odd" if there is none.
[[nodiscard]] std::string findings_text(const CookReport& report, std::size_t most_places);

/// An object: all counts, and the places that were kept.
[[nodiscard]] std::string findings_json(const CookReport& report);

}  // namespace surefoot::tools
