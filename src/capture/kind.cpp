#include <surefoot/capture.hpp>

namespace surefoot {
inline namespace v0 {

namespace {

// Within a text of JSON no quote stands without a backslash, so a name in quotes with a colon after it is a member.
bool has_member(std::string_view text, std::string_view quoted) noexcept {
    for (std::size_t at = text.find(quoted); at != text.npos; at = text.find(quoted, at + 1)) {
        const std::size_t next = text.find_first_not_of(" \n\r\t", at + quoted.size());
        if (next != text.npos && text[next] == ':') return true;
    }
    return false;
}

}  // namespace

SavedKind saved_kind(std::string_view text) noexcept {
    if (has_member(text, "\"surefoot_session\"")) return SavedKind::session;
    return has_member(text, "\"step\"") ? SavedKind::step : SavedKind::question;
}

}  // namespace v0
}  // namespace surefoot
