// The plain structs of a character as objects of JSON: each field a member by its own name.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <type_traits>
#include <vector>

#include "capture/parts.hpp"
#include "capture/reader.hpp"
#include "capture/words.hpp"
#include "capture/writer.hpp"
#include "character/fields.hpp"

namespace surefoot::internal {

/// The words of an enumeration that stands in a field.
[[nodiscard]] constexpr const auto& words_of(Response) noexcept {
    return response_words;
}
[[nodiscard]] constexpr const auto& words_of(Firmness) noexcept {
    return firmness_words;
}
[[nodiscard]] constexpr const auto& words_of(SlopeSpeed) noexcept {
    return slope_speed_words;
}
[[nodiscard]] constexpr const auto& words_of(Footing) noexcept {
    return footing_words;
}
[[nodiscard]] constexpr const auto& words_of(CharacterMode) noexcept {
    return mode_words;
}
[[nodiscard]] constexpr const auto& words_of(CharacterForm) noexcept {
    return form_words;
}
[[nodiscard]] constexpr const auto& words_of(Hold) noexcept {
    return hold_words;
}
[[nodiscard]] constexpr const auto& words_of(StepAct) noexcept {
    return act_words;
}
[[nodiscard]] constexpr const auto& words_of(StepRule) noexcept {
    return rule_words;
}
[[nodiscard]] constexpr const auto& words_of(Feature) noexcept {
    return feature_words;
}

/// On one line, or a member a line, each after `before`.
template <typename Struct>
void write_fields(Writer& w, const Struct& from, std::string_view before = {});

inline void write_field(Writer& w, double value) {
    w.number(value);
}
inline void write_field(Writer& w, bool value) {
    w.yes(value);
}
inline void write_field(Writer& w, const dvec3& value) {
    w.list(value);
}
inline void write_field(Writer& w, const Volume& value) {
    w.word("{");
    write_volume(w, value, ", ");
    w.word("}");
}
inline void write_field(Writer& w, const std::optional<Volume>& value) {
    if (value) return write_field(w, *value);
    w.word("null");
}
inline void write_field(Writer& w, const SurfaceRules& rules) {
    w.word("[");
    for (const SurfaceRule& rule : rules.all()) {
        if (&rule != rules.all().data()) w.word(", ");
        write_fields(w, rule);
    }
    w.word("]");
}
template <typename T>
requires(std::is_enum_v<T> || std::is_unsigned_v<T>) void write_field(Writer& w, T value) {
    if constexpr (std::is_enum_v<T>) {
        w.text(word_of(words_of(value), value));
    } else {
        w.number(static_cast<std::uint32_t>(value));
    }
}

template <typename Struct>
void write_fields(Writer& w, const Struct& from, std::string_view before) {
    w.word("{");
    bool is_first = true;
    visit_fields(from, [&](const char* name, const auto& field) {
        if (!is_first) w.word(before.empty() ? ", " : ",");
        is_first = false;
        w.word(before);
        w.word("\"");
        w.word(name);
        w.word("\": ");
        write_field(w, field);
    });
    w.word(before.substr(0, before.empty() ? 0 : before.size() - 2));
    w.word("}");
}

/// Each after `before`, or all on one line.
inline void write_neighbours(Writer& w, const std::vector<Neighbour>& neighbours, std::string_view before = {}) {
    w.word("\"neighbours\": [");
    for (const Neighbour& one : neighbours) {
        if (&one != neighbours.data()) w.word(before.empty() ? ", " : ",");
        w.word(before);
        write_fields(w, one);
    }
    w.word("]");
}

/// How many of a struct's fields, the last ones, came with the newest form of the files.
template <typename Struct>
inline constexpr std::size_t newest_fields = 0;
template <>
inline constexpr std::size_t newest_fields<CharacterSettings> = 3;  // firmness, flat_foot, on_ledge

/// Settings of the newest form have its fields, those of an older one none. Otherwise it fails. `on_ledge` came last
/// and may be missing; then there is no such body. `are_there`: a bit for each.
inline void check_newest_settings(JsonReader& in, std::uint64_t are_there, bool is_newest) {
    check_newest(in, "firmness\", \"flat_foot\" or \"on_ledge", is_newest ? (are_there & 3U) == 3U : are_there != 0,
                 is_newest);
}

/// Reads objects that `write_fields` has written. Rules for surfaces are put into a list of the caller's.
class FieldReader {
public:
    static constexpr std::size_t most_surfaces = std::size_t{1} << 16U;

    FieldReader(JsonReader& in, std::vector<SurfaceRule>& surfaces) noexcept : in_(in), surfaces_(surfaces) {}

    /// Which of the newest fields are there, a bit for each.
    template <typename Struct>
    std::uint64_t read(Struct& to) {
        std::array<std::string_view, 64> names;
        std::size_t count = 0;
        visit_fields(to, [&](const char* name, auto&) { names[count++] = name; });
        const std::size_t required = count - newest_fields<Struct>;
        const auto seen = in_.object(std::span(names).first(count), required, [&](std::size_t wanted) {
            std::size_t i = 0;
            visit_fields(to, [&](const char*, auto& field) {
                if (i++ == wanted) read_field(field);
            });
        });
        return seen >> required;
    }

    /// Fails if `to` would get more than `most`.
    void read_neighbours(std::vector<Neighbour>& to, std::size_t most) {
        in_.array([&] {
            Neighbour one;
            read(one);
            if (to.size() == most) in_.fail("more neighbours than there may be", ErrorCode::limit);
            if (in_.good()) to.push_back(one);
        });
    }

private:
    void read_field(double& field) { field = in_.number(); }
    void read_field(bool& field) { field = in_.yes(); }
    void read_field(dvec3& field) { field = in_.vector(); }
    void read_field(std::uint32_t& field) { field = in_.whole_number(); }
    void read_field(std::uint8_t& field) {
        const std::uint32_t value = in_.whole_number();
        if (value > 1) in_.fail("0 or 1 must be here");
        field = static_cast<std::uint8_t>(value);
    }
    void read_field(Volume& field) {
        constexpr std::array<std::string_view, 2> names{"shape", "rotate"};
        in_.object(names, names.size(), [&](std::size_t i) {
            if (i == 0) field.shape = read_shape(in_);
            if (i == 1) field.orientation = in_.turn();
        });
    }
    void read_field(std::optional<Volume>& field) {
        if (!in_.null()) read_field(field.emplace());
    }
    void read_field(SurfaceRules&) {
        in_.array([&] {
            SurfaceRule rule;
            read(rule);
            if (surfaces_.size() == most_surfaces) in_.fail("more surfaces than a step may have", ErrorCode::limit);
            if (in_.good()) surfaces_.push_back(rule);
        });
    }
    template <typename T>
    requires(std::is_enum_v<T>) void read_field(T& field) { field = static_cast<T>(in_.one_of(words_of(T{}))); }

    JsonReader& in_;
    std::vector<SurfaceRule>& surfaces_;
};

}  // namespace surefoot::internal
