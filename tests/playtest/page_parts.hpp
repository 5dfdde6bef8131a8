/// A page taken apart again: what it refers to, and what it holds within itself.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace surefoot::test {

/// What stands between each `before` and the next `after`.
inline std::vector<std::string> all_between(const std::string& page, std::string_view before, std::string_view after) {
    std::vector<std::string> found;
    for (std::size_t at = page.find(before); at != std::string::npos; at = page.find(before, at)) {
        at += before.size();
        found.push_back(page.substr(at, page.find(after, at) - at));
    }
    return found;
}

/// The bytes of base64; empty if it is none.
inline std::string bytes_of_base64(std::string_view text) {
    constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string bytes;
    std::uint32_t bits = 0;
    int count = 0;
    for (const char letter : text) {
        if (letter == '=') break;
        const std::size_t value = letters.find(letter);
        if (value == std::string_view::npos) return {};
        bits = bits << 6U | std::uint32_t(value);
        count += 6;
        if (count < 8) continue;
        count -= 8;
        bytes += char(bits >> std::uint32_t(count) & 255U);
    }
    return bytes;
}

/// What a picture within the page decodes to.
struct Decoded {
    int width = 0;  ///< 0 if it does not
    int height = 0;
    std::size_t colours = 0;
};
[[nodiscard]] Decoded decoded(const std::string& png);

}  // namespace surefoot::test
