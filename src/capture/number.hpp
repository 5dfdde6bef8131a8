// Pieces of text: numbers that read back to the same bits, whatever the locale.
#pragma once

#include <charconv>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>

namespace surefoot::internal {

/// The shortest decimal text that reads back to the same number.
/// Requires: a finite one.
template <typename Number>
void append_shortest(std::string& out, Number value) {
    char text[40];
    const auto [end, error] = std::to_chars(text, text + sizeof text, value);
    static_cast<void>(error);  // 40 characters hold every number
    out.append(text, end);
}

/// 16 hexadecimal digits.
inline void append_bits(std::string& out, std::uint64_t bits) {
    for (int shift = 60; shift >= 0; shift -= 4) out += "0123456789abcdef"[(bits >> shift) & 15U];
}

/// One after the other.
inline std::string joined(std::initializer_list<std::string_view> parts) {
    std::string out;
    for (const std::string_view part : parts) out += part;
    return out;
}

}  // namespace surefoot::internal
