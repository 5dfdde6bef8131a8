// Where two plain structs of a character differ, bit for bit, by the names of their fields.
#pragma once

#include <bit>
#include <cstdint>
#include <string>
#include <type_traits>

#include "capture/number.hpp"
#include "character/fields.hpp"

namespace surefoot::internal {

inline bool same_bits(double a, double b) noexcept {
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}
inline bool same_bits(const dvec3& a, const dvec3& b) noexcept {
    return same_bits(a.x, b.x) && same_bits(a.y, b.y) && same_bits(a.z, b.z);
}
template <typename T>
requires(std::is_enum_v<T> || std::is_integral_v<T>) bool same_bits(T a, T b) noexcept {
    return a == b;
}

inline std::string field_text(double value) {
    std::string text;
    append_shortest(text, value);
    return text;
}
inline std::string field_text(const dvec3& v) {
    return joined({"(", field_text(v.x), ", ", field_text(v.y), ", ", field_text(v.z), ")"});
}
template <typename T>
requires(std::is_enum_v<T> || std::is_integral_v<T>) std::string field_text(T value) {
    return std::to_string(static_cast<std::uint32_t>(value));
}

/// "position, (0, 1, 0) then and (0, 2, 0) now"; empty if no bit differs. For structs without shapes.
template <typename Struct>
std::string first_difference(const Struct& then, const Struct& now) {
    std::string text;
    std::size_t place = 0;
    visit_fields(then, [&](const char* name, const auto& field) {
        std::size_t other_place = 0;
        visit_fields(now, [&](const char*, const auto& other) {
            if constexpr (std::is_same_v<decltype(field), decltype(other)>) {
                if (other_place == place && text.empty() && !same_bits(field, other)) {
                    text = joined({name, ", ", field_text(field), " then and ", field_text(other), " now"});
                }
            }
            ++other_place;
        });
        ++place;
    });
    return text;
}

}  // namespace surefoot::internal
