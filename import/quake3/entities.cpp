#include "entities.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>

namespace surefoot::internal::quake3 {
namespace {

char lower(char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

bool equal_without_case(std::string_view a, std::string_view b) {
    return std::ranges::equal(a, b, {}, lower, lower);
}

bool is_blank(char c) {
    return static_cast<unsigned char>(c) <= ' ';
}

/// Takes a number off the front, a float as in the game; 0 for what is none, which stays.
double take_number(std::string_view& text) {
    while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
    if (text.starts_with('+')) text.remove_prefix(1);
    float value = 0;
    const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error == std::errc::invalid_argument) return 0;
    text.remove_prefix(static_cast<std::size_t>(stop - text.data()));
    return error == std::errc{} && std::isfinite(value) ? static_cast<double>(value) : 0;
}

class Parser {
public:
    explicit Parser(const Map& map) : map_(map), text_(map.entities) {}

    Expected<std::vector<Entity>> parse() {
        for (skip(); place_ < text_.size(); skip()) {
            if (text_[place_] != '{') return refuse("an entity begins with {, and here is something else");
            Entity entity;
            entity.byte = place_++;
            for (skip(); !take('}'); skip()) {
                const auto key = word();
                skip();
                const auto value = key ? word() : key;
                if (!value) return refuse("a key or a value in quotes, or }, should be here");
                entity.pairs.emplace_back(*key, *value);
            }
            entities_.push_back(std::move(entity));
        }
        return std::move(entities_);
    }

private:
    [[nodiscard]] tl::unexpected<Error> refuse(std::string_view what) const {
        return tl::unexpected(bad_byte(map_, Lump::entities, place_,
                                       std::string(what) + "; the text is damaged, so compile the map again"));
    }

    /// Over blanks and comments to the end of the line.
    void skip() {
        while (place_ < text_.size()) {
            if (is_blank(text_[place_])) {
                ++place_;
            } else if (text_.substr(place_, 2) == "//") {
                place_ = std::min(text_.find('\n', place_), text_.size());
            } else {
                return;
            }
        }
    }

    bool take(char c) {
        if (place_ >= text_.size() || text_[place_] != c) return false;
        ++place_;
        return true;
    }

    /// None at a brace, at the end of the text, and at a quote that is never closed.
    std::optional<std::string_view> word() {
        if (take('"')) {
            const std::size_t end = text_.find('"', place_);
            if (end == std::string_view::npos) return std::nullopt;
            const std::string_view quoted = text_.substr(place_, end - place_);
            place_ = end + 1;
            return quoted;
        }
        const std::size_t begin = place_;
        while (place_ < text_.size() && !is_blank(text_[place_]) && text_[place_] != '{' && text_[place_] != '}')
            ++place_;
        if (place_ == begin) return std::nullopt;
        return text_.substr(begin, place_ - begin);
    }

    const Map& map_;
    std::string_view text_;
    std::size_t place_ = 0;
    std::vector<Entity> entities_;
};

}  // namespace

std::string_view Entity::value(std::string_view key) const {
    const auto found = std::find_if(pairs.rbegin(), pairs.rend(),
                                    [&](const auto& pair) { return equal_without_case(pair.first, key); });
    return found == pairs.rend() ? std::string_view{} : found->second;
}

std::optional<double> Entity::number(std::string_view key) const {
    std::string_view text = value(key);
    if (text.empty()) return std::nullopt;
    return take_number(text);
}

std::optional<dvec3> Entity::vector(std::string_view key) const {
    std::string_view text = value(key);
    if (text.empty()) return std::nullopt;
    const double x = take_number(text);
    const double y = take_number(text);
    return dvec3(x, y, take_number(text));
}

std::optional<std::uint32_t> Entity::model(std::size_t count) const {
    std::string_view text = value("model");
    if (!text.starts_with('*')) return std::nullopt;
    text.remove_prefix(1);
    std::uint32_t number = 0;
    const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc{} || stop != text.data() + text.size() || number >= count) return std::nullopt;
    return number;
}

Expected<std::vector<Entity>> read_entities(const Map& map) {
    return Parser(map).parse();
}

}  // namespace surefoot::internal::quake3
