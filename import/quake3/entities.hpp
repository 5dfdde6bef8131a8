/// The text in a map that says what is where: `{ "classname" "weapon_shotgun" "origin" "64 -128 24" }` and so on.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include <surefoot/error.hpp>
#include <surefoot/math.hpp>

#include "map.hpp"

namespace surefoot::internal::quake3 {

/// Keys and values in the order of the file. The text belongs to the bytes that were read.
class Entity {
public:
    std::uint64_t byte = 0;  ///< of its opening brace, within the text
    std::vector<std::pair<std::string_view, std::string_view>> pairs;

    /// The value of the last such key, as in the game; empty if there is none. Keys know no capitals.
    [[nodiscard]] std::string_view value(std::string_view key) const;

    /// Numbers at the front of the value. What is no finite number counts as 0, as in the game.
    [[nodiscard]] std::optional<double> number(std::string_view key) const;
    [[nodiscard]] std::optional<dvec3> vector(std::string_view key) const;

    /// Which model it moves or is triggered by ("*3"): below `count`; none if it has none.
    [[nodiscard]] std::optional<std::uint32_t> model(std::size_t count) const;
};

/// Fails with `invalid` when braces or quotes do not pair; the error names the byte.
[[nodiscard]] Expected<std::vector<Entity>> read_entities(const Map& map);

}  // namespace surefoot::internal::quake3
