// Many characters in spans: what belongs to which.
#pragma once

#include <cstddef>
#include <span>

#include <surefoot/character.hpp>

namespace surefoot::internal {

/// A span holds one for each, or one for all.
template <typename T>
[[nodiscard]] const T& one_of(std::span<const T> all, std::size_t index) noexcept {
    return all[all.size() == 1 ? 0 : index];
}

[[nodiscard]] inline bool fit_together(const Characters& characters) noexcept {
    const std::size_t count = characters.before.size();
    const auto fits = [&](std::size_t size) noexcept { return size == 1 || size >= count; };
    const auto has_room = [&](std::size_t size) noexcept { return size == 0 || size >= count; };
    return count == 0 || (fits(characters.settings.size()) && fits(characters.inputs.size()) &&
                          characters.after.size() >= count && has_room(characters.events.size()) &&
                          has_room(characters.contacts.size()) && has_room(characters.ids.size()));
}

template <typename Visit>
void each_in(const Characters& characters, const StepRange& range, const Visit& visit) noexcept {
    const std::size_t count = characters.before.size();
    const std::size_t end = range.end < count ? range.end : count;
    for (std::size_t i = range.begin; i < end; ++i) visit(i);
}

inline void answer(const Characters& characters, std::size_t index, const StepResult& result) noexcept {
    characters.after[index] = result.state;
    if (!characters.events.empty()) characters.events[index] = result.events;
    if (!characters.contacts.empty()) characters.contacts[index] = result.contacts;
}

}  // namespace surefoot::internal
