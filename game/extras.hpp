/// The glTF extras of a node or a material, asked by name. The first thing that is wrong is kept, as a sentence that
/// names node, key and range; whoever asked looks once, in the end.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <surefoot/math.hpp>

namespace surefoot::game {

class Extras {
public:
    /// `where` names the node or the material in errors. Text that is no JSON object is wrong; empty text is no extras.
    Extras(const std::string& json, std::string where);

    [[nodiscard]] double number(std::string_view key, double otherwise, double low, double high);
    [[nodiscard]] int whole(std::string_view key, int otherwise, int low, int high);
    [[nodiscard]] bool flag(std::string_view key, bool otherwise = false);
    [[nodiscard]] std::string text(std::string_view key, const std::string& otherwise = {});
    [[nodiscard]] dvec3 vector(std::string_view key, const dvec3& otherwise);
    [[nodiscard]] std::vector<dvec3> vectors(std::string_view key);
    [[nodiscard]] bool has(std::string_view key) const;

    /// One of these words, by its place; the first of them if there is none.
    template <typename Enum>
    [[nodiscard]] Enum one_of(std::string_view key, std::initializer_list<std::string_view> words) {
        return static_cast<Enum>(place_of(key, words));
    }

    void wrong(const std::string& what);

    /// The first thing that was wrong, or empty.
    [[nodiscard]] const std::string& error() const { return error_; }
    [[nodiscard]] const std::string& where() const { return where_; }

private:
    [[nodiscard]] const nlohmann::json* find(std::string_view key) const;
    [[nodiscard]] std::optional<dvec3> as_vector(const nlohmann::json& value) const;
    [[nodiscard]] std::size_t place_of(std::string_view key, std::initializer_list<std::string_view> words);

    nlohmann::json json_;
    std::string where_;
    std::string error_;
};

}  // namespace surefoot::game
