#include "character_words.hpp"

#include <array>
#include <fmt/format.h>

namespace surefoot::tools {

std::string events_text(const CharacterEvents& events) {
    constexpr std::array names{"jumped",
                               "landed",
                               "left ground",
                               "stepped up",
                               "snapped down",
                               "blocked",
                               "hit a ceiling",
                               "crushed",
                               "stuck",
                               "recovered",
                               "sub-stepped",
                               "overflow",
                               "pushed",
                               "dashed",
                               "climbing",
                               "no room",
                               "invalid",
                               "grabbed a ledge",
                               "dropped from a ledge",
                               "climbed a ledge",
                               "vaulted",
                               "met a neighbour"};
    std::string text;
    for (std::size_t i = 0; i < names.size(); ++i) {
        if ((events.set >> i & 1U) != 0) text += fmt::format("{}{}", text.empty() ? "" : ", ", names[i]);
    }
    return text.empty() ? "none" : text;
}

std::string footing_text(Footing footing) {
    switch (footing) {
        case Footing::air:
            return "in the air";
        case Footing::ground:
            return "on ground";
        case Footing::steep:
            return "on something too steep";
        case Footing::ledge:
            break;
    }
    return "holding an edge";
}

}  // namespace surefoot::tools
