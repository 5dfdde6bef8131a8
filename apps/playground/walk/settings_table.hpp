/// Every field of `CharacterSettings` with its unit, the range that is sensible to play with, and what follows from it:
/// what the panel, the clipboard and the tests go over.
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <variant>

#include <surefoot/character_settings.hpp>

namespace surefoot::playground {

struct SettingRow {
    template <typename T>
    using Member = T CharacterSettings::*;
    using Field = std::variant<Member<double>, Member<bool>, Member<std::uint32_t>, Member<Response>,
                               Member<SlopeSpeed>, Member<Firmness>, Member<Volume>, Member<std::optional<Volume>>>;

    const char* name;  ///< the field's own
    Field field;
    const char* unit = "";
    double low = 0;
    double high = 0;
    const char* says = "";  ///< what follows from it, in a line or two
};

struct SettingGroup {
    const char* title;
    std::span<const SettingRow> rows;
};

/// All fields but `surfaces`, which belongs to the level, in the order of the struct.
[[nodiscard]] std::span<const SettingGroup> setting_groups();

/// The words for the values of an enumeration, in their order, as C++ writes them.
[[nodiscard]] std::span<const char* const> words_of(Response value);
[[nodiscard]] std::span<const char* const> words_of(SlopeSpeed value);
[[nodiscard]] std::span<const char* const> words_of(Firmness value);

/// Has the field the same value in both?
[[nodiscard]] bool same_field(const SettingRow& row, const CharacterSettings& a, const CharacterSettings& b);

/// Gives the field of `to` the value that it has in `from`.
void copy_field(const SettingRow& row, const CharacterSettings& from, CharacterSettings& to);

/// The six shapes by name, in the order of `Shape`, their dimensions, and one from them.
[[nodiscard]] std::span<const char* const> shape_names();
struct ShapeSize {
    const char* name;
    double value;
};
[[nodiscard]] std::span<const ShapeSize> sizes_of(const Shape& shape, std::span<ShapeSize, 3> room);
[[nodiscard]] Shape shape_from(std::size_t index, std::span<const double> sizes);

/// Another shape of about the same size: as wide, and as high where it has a height.
[[nodiscard]] Shape as_large(const Shape& shape, std::size_t index);

}  // namespace surefoot::playground
