#include "playground/walk/settings_text.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <type_traits>

#include "playground/walk/settings_table.hpp"

namespace surefoot::playground {
namespace {

using nlohmann::ordered_json;

template <typename T>
ordered_json to_json(const T& value) {
    if constexpr (std::is_enum_v<T>) {
        return words_of(value)[static_cast<std::size_t>(value)];
    } else {
        return value;
    }
}

ordered_json to_json(const Volume& volume) {
    ordered_json shape = ordered_json::array({shape_names()[volume.shape.index()]});
    std::array<ShapeSize, 3> room;
    for (const ShapeSize& size : sizes_of(volume.shape, room)) shape.push_back(size.value);
    return shape;
}

ordered_json to_json(const std::optional<Volume>& volume) {
    return volume ? to_json(*volume) : ordered_json();
}

// Each is true if the value fits.
bool read(const ordered_json& json, double& value) {
    if (!json.is_number()) return false;
    value = json.get<double>();
    return true;
}

bool read(const ordered_json& json, bool& value) {
    if (!json.is_boolean()) return false;
    value = json.get<bool>();
    return true;
}

bool read(const ordered_json& json, std::uint32_t& value) {
    if (!json.is_number_unsigned() || json.get<std::uint64_t>() > 0xFFFFFFFF) return false;
    value = json.get<std::uint32_t>();
    return true;
}

/// The place of a text among these; their count if it is none of them.
std::size_t place_of(const ordered_json& json, std::span<const char* const> words) {
    if (!json.is_string()) return words.size();
    const auto& text = json.get_ref<const std::string&>();
    return static_cast<std::size_t>(std::find(words.begin(), words.end(), text) - words.begin());
}

template <typename T>
requires std::is_enum_v<T>
bool read(const ordered_json& json, T& value) {
    const auto words = words_of(T{});
    const std::size_t place = place_of(json, words);
    if (place == words.size()) return false;
    value = static_cast<T>(place);
    return true;
}

bool read(const ordered_json& json, Volume& value) {
    if (!json.is_array() || json.empty()) return false;
    const std::size_t index = place_of(json[0], shape_names());
    if (index == shape_names().size()) return false;
    std::vector<double> sizes;
    for (std::size_t i = 1; i < json.size(); ++i)
        if (!read(json[i], sizes.emplace_back())) return false;
    std::array<ShapeSize, 3> room;
    if (sizes.size() != sizes_of(shape_from(index, sizes), room).size()) return false;
    value = Volume(shape_from(index, sizes));
    return true;
}

bool read(const ordered_json& json, std::optional<Volume>& value) {
    if (json.is_null()) {
        value.reset();
        return true;
    }
    return read(json, value.emplace());
}

std::string to_cpp(const Volume& volume) {
    const char* const name = shape_names()[volume.shape.index()];
    std::array<ShapeSize, 3> room;
    std::string numbers;
    for (const ShapeSize& size : sizes_of(volume.shape, room))
        numbers += fmt::format("{}{}", numbers.empty() ? "" : ", ", size.value);
    const bool has_vector = volume.shape.index() == 1 || volume.shape.index() == 3;
    if (has_vector) numbers = "{" + numbers + "}";
    return fmt::format("surefoot::{}{{{}}}", name, numbers);
}

std::string to_cpp(const std::optional<Volume>& volume) {
    return volume ? to_cpp(*volume) : "std::nullopt";
}

std::string to_cpp(bool value) {
    return value ? "true" : "false";
}

std::string to_cpp(double value) {
    return fmt::format("{}", value);
}

std::string to_cpp(std::uint32_t value) {
    return fmt::format("{}", value);
}

template <typename T>
std::string enum_cpp(const char* type, T value) {
    return fmt::format("surefoot::{}::{}", type, words_of(value)[static_cast<std::size_t>(value)]);
}

std::string to_cpp(Response value) {
    return enum_cpp("Response", value);
}

std::string to_cpp(SlopeSpeed value) {
    return enum_cpp("SlopeSpeed", value);
}

std::string to_cpp(Firmness value) {
    return enum_cpp("Firmness", value);
}

tl::unexpected<Error> wrong(const std::string& text) {
    return tl::unexpected(Error{ErrorCode::invalid, text, {}, 0});
}

const SettingRow* row_named(std::string_view name) {
    for (const SettingGroup& group : setting_groups())
        for (const SettingRow& row : group.rows)
            if (row.name == name) return &row;
    return nullptr;
}

}  // namespace

std::string settings_json(const CharacterSettings& settings) {
    ordered_json json;
    for (const SettingGroup& group : setting_groups())
        for (const SettingRow& row : group.rows)
            json[row.name] = std::visit([&](auto field) { return to_json(settings.*field); }, row.field);
    return json.dump(2);
}

Expected<CharacterSettings> parse_settings(std::string_view text, const CharacterSettings& base) {
    const ordered_json json = ordered_json::parse(text, nullptr, false);
    if (!json.is_object()) return wrong("These are no settings: copy some first.");
    CharacterSettings settings = base;
    for (const auto& [name, value] : json.items()) {
        const SettingRow* const row = row_named(name);
        if (row == nullptr) return wrong("No setting is called \"" + name + "\".");
        if (!std::visit([&, &v = value](auto field) { return read(v, settings.*field); }, row->field))
            return wrong("The value of \"" + name + "\" does not fit: " + value.dump() + ".");
    }
    if (!is_valid(settings)) return wrong("With these settings nobody can walk: a number is out of its range.");
    return settings;
}

std::string settings_cpp(const CharacterSettings& settings) {
    const CharacterSettings defaults;
    std::string text = "const surefoot::CharacterSettings hero{";
    for (const SettingGroup& group : setting_groups())
        for (const SettingRow& row : group.rows) {
            if (same_field(row, settings, defaults)) continue;
            text += fmt::format("\n    .{} = {},", row.name,
                                std::visit([&](auto field) { return to_cpp(settings.*field); }, row.field));
        }
    return text + (text.ends_with('{') ? "};\n" : "\n};\n");
}

}  // namespace surefoot::playground
