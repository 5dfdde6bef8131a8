#include <bit>

#include <surefoot/character.hpp>
#include <surefoot/file.hpp>

#include "character/fields.hpp"
#include "ieee_guard.hpp"

namespace surefoot {
inline namespace v0 {

std::uint64_t hash(const CharacterState& state) noexcept {
    const internal::IeeeGuard guard;
    std::uint64_t words[sizeof(CharacterState)];
    std::size_t count = 0;
    internal::visit_fields(state, [&](const char*, const auto& field) {
        using Field = std::remove_cvref_t<decltype(field)>;
        // 0 is added because -0 + 0 is 0: they compare as equal, so they hash alike.
        const auto add = [&](double value) { words[count++] = std::bit_cast<std::uint64_t>(value + 0.0); };
        if constexpr (std::is_same_v<Field, dvec3>) {
            add(field.x);
            add(field.y);
            add(field.z);
        } else if constexpr (std::is_same_v<Field, double>) {
            add(field);
        } else {
            words[count++] = static_cast<std::uint64_t>(field);
        }
    });
    return hash_bytes(std::as_bytes(std::span(words).first(count)));
}

}  // namespace v0
}  // namespace surefoot
