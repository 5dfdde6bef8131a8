#include "platformer/screens/form.hpp"

#include <algorithm>

namespace surefoot::platformer {

bool FormField::is_answered() const {
    switch (kind) {
        case Kind::line:
            return text.find_first_not_of(' ') != std::string::npos;
        case Kind::choice:
            return chosen.has_value();
        case Kind::agree:
            return agreed;
    }
    return false;
}

std::string FormField::value() const {
    switch (kind) {
        case Kind::line:
            return text;
        case Kind::choice:
            return chosen ? choices[*chosen] : std::string("\u2013");
        case Kind::agree:
            return agreed ? "Yes" : "No";
    }
    return {};
}

void FormField::type(std::string_view letters) {
    if (kind == Kind::line && text.size() + letters.size() <= longest) text += letters;
}

void FormField::erase() {
    // Of a letter of several bytes all but the first begin with the bits 10.
    while (!text.empty() && (static_cast<unsigned char>(text.back()) & 0xC0U) == 0x80U) text.pop_back();
    if (!text.empty()) text.pop_back();
}

void FormField::step(int direction) {
    if (kind == Kind::agree) {
        agreed = !agreed;
    } else if (kind == Kind::choice) {
        const int count = static_cast<int>(choices.size());
        const int from = chosen ? static_cast<int>(*chosen) : (direction > 0 ? -1 : count);
        chosen = static_cast<std::size_t>((from + direction + count) % count);
    } else if (text.size() <= 1) {
        // What was typed is not lost to a key that was pressed by mistake.
        const bool is_letter = text.size() == 1 && text[0] >= 'A' && text[0] <= 'Z';
        const int from = is_letter ? text[0] - 'A' : (direction > 0 ? -1 : 26);
        text = std::string(1, static_cast<char>('A' + (from + direction + 26) % 26));
    }
}

bool Form::is_complete() const {
    return std::ranges::all_of(fields, [](const FormField& field) { return !field.required || field.is_answered(); });
}

const FormField& Form::operator[](std::string_view key) const {
    return *std::ranges::find(fields, key, &FormField::key);
}

}  // namespace surefoot::platformer
