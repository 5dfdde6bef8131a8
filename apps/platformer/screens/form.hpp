/// What somebody is asked on a screen, and what they answered: lines to type, choices, something to agree to.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace surefoot::platformer {

struct FormField {
    enum class Kind : std::uint8_t {
        line,    ///< is typed; without a keyboard it is a letter, by left and right
        choice,  ///< one of `choices`; none of them in the beginning
        agree,   ///< yes or no
    };
    Kind kind = Kind::line;
    std::string key{};    ///< for whoever reads the answers
    std::string label{};  ///< what is asked
    std::string hint{};
    std::vector<std::string> choices{};
    bool required = false;  ///< else it may be left as it is

    std::string text{};
    std::optional<std::size_t> chosen{};
    bool agreed = false;

    [[nodiscard]] bool is_answered() const;
    [[nodiscard]] std::string value() const;  ///< as it is shown

    /// What the keyboard brought; a line has room for so many letters.
    static constexpr std::size_t longest = 200;
    void type(std::string_view letters);
    void erase();

    /// To the next choice, round and round; a line goes from letter to letter.
    void step(int direction);
};

struct Form {
    std::string id{};
    std::string title{};
    std::string subtitle{};
    std::vector<std::string> words{};  ///< above the fields, a row each
    std::vector<FormField> fields{};
    std::string done = "Done";
    std::string dismiss = "Back";

    [[nodiscard]] bool is_complete() const;

    /// Requires: there is one.
    [[nodiscard]] const FormField& operator[](std::string_view key) const;
};

}  // namespace surefoot::platformer
