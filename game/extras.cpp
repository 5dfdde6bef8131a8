#include "game/extras.hpp"

#include <cmath>
#include <fmt/format.h>

namespace surefoot::game {

using nlohmann::json;

Extras::Extras(const std::string& text, std::string where) : where_(std::move(where)) {
    if (text.empty()) return;
    json_ = json::parse(text, nullptr, false);
    if (!json_.is_object()) {
        wrong("its extras are no JSON object");
        return;
    }
    // Both {"surefoot": {...}} and the bare keys are taken, as the importer does for `kind`.
    const auto inner = json_.find("surefoot");
    if (inner != json_.end() && inner->is_object()) json_ = json(*inner);
}

void Extras::wrong(const std::string& what) {
    if (error_.empty()) error_ = fmt::format("'{}': {}", where_, what);
}

const json* Extras::find(std::string_view key) const {
    if (!json_.is_object()) return nullptr;
    const auto found = json_.find(key);
    return found == json_.end() ? nullptr : &*found;
}

bool Extras::has(std::string_view key) const {
    return find(key) != nullptr;
}

double Extras::number(std::string_view key, double otherwise, double low, double high) {
    const json* const value = find(key);
    if (value == nullptr) return otherwise;
    const double number = value->is_number() ? value->get<double>() : std::nan("");
    if (number >= low && number <= high) return number;
    wrong(fmt::format("'{}' is {}, and has to be a number from {} to {}", key, value->dump(), low, high));
    return otherwise;
}

int Extras::whole(std::string_view key, int otherwise, int low, int high) {
    const double value = number(key, otherwise, low, high);
    if (value != std::floor(value)) wrong(fmt::format("'{}' is {}, and has to be a whole number", key, value));
    return int(value);
}

bool Extras::flag(std::string_view key, bool otherwise) {
    const json* const value = find(key);
    if (value == nullptr) return otherwise;
    if (value->is_boolean()) return value->get<bool>();
    if (value->is_number()) return value->get<double>() != 0;  // Blender 3.4 writes its booleans as 0 and 1
    wrong(fmt::format("'{}' is {}, and has to be true or false", key, value->dump()));
    return otherwise;
}

std::string Extras::text(std::string_view key, const std::string& otherwise) {
    const json* const value = find(key);
    if (value == nullptr) return otherwise;
    if (value->is_string()) return value->get<std::string>();
    wrong(fmt::format("'{}' is {}, and has to be text", key, value->dump()));
    return otherwise;
}

std::optional<dvec3> Extras::as_vector(const json& value) const {
    if (!value.is_array() || value.size() != 3) return std::nullopt;
    dvec3 made{0, 0, 0};
    for (int i = 0; i < 3; ++i) {
        const json& part = value[std::size_t(i)];
        if (!part.is_number() || !(std::abs(part.get<double>()) <= 1e6)) return std::nullopt;
        made[i] = part.get<double>();
    }
    return made;
}

dvec3 Extras::vector(std::string_view key, const dvec3& otherwise) {
    const json* const value = find(key);
    if (value == nullptr) return otherwise;
    if (const auto made = as_vector(*value)) return *made;
    wrong(fmt::format("'{}' is {}, and has to be three numbers like [1, 2, 3]", key, value->dump()));
    return otherwise;
}

std::vector<dvec3> Extras::vectors(std::string_view key) {
    std::vector<dvec3> made;
    const json* const value = find(key);
    if (value == nullptr) return made;
    const auto complain = [&] {
        wrong(fmt::format("'{}' has to be a list of places like [[0, 0, 0], [0, 4, 0]]", key));
    };
    if (!value->is_array()) {
        complain();
        return made;
    }
    // The exporter flattens lists of lists of equal length in some versions: three numbers a place either way.
    if (!value->empty() && (*value)[0].is_number()) {
        if (value->size() % 3 != 0) complain();
        for (std::size_t i = 0; i + 2 < value->size(); i += 3)
            if (const auto place = as_vector(json::array({(*value)[i], (*value)[i + 1], (*value)[i + 2]})))
                made.push_back(*place);
            else
                complain();
        return made;
    }
    for (const json& item : *value)
        if (const auto place = as_vector(item))
            made.push_back(*place);
        else
            complain();
    return made;
}

std::size_t Extras::place_of(std::string_view key, std::initializer_list<std::string_view> words) {
    const json* const value = find(key);
    if (value == nullptr) return 0;
    if (value->is_string()) {
        std::size_t place = 0;
        for (const std::string_view word : words) {
            if (value->get_ref<const std::string&>() == word) return place;
            ++place;
        }
    }
    std::string all;
    for (const std::string_view word : words) all += fmt::format("{}\"{}\"", all.empty() ? "" : ", ", word);
    wrong(fmt::format("'{}' is {}, and has to be one of {}", key, value->dump(), all));
    return 0;
}

}  // namespace surefoot::game
