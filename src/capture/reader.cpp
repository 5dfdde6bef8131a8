#include "capture/reader.hpp"

#include <bit>
#include <charconv>
#include <limits>

#include "capture/number.hpp"
#include "capture/words.hpp"

namespace surefoot::internal {

namespace {

bool is_digit(char c) noexcept {
    return c >= '0' && c <= '9';
}

// How many of the characters from `at` on are digits.
std::size_t digits_at(std::string_view text, std::size_t at) noexcept {
    std::size_t count = 0;
    while (at + count < text.size() && is_digit(text[at + count])) ++count;
    return count;
}

// How long the number at the front is, by the grammar of JSON; 0 if there is none.
std::size_t number_length(std::string_view text) noexcept {
    std::size_t at = !text.empty() && text[0] == '-' ? 1 : 0;
    const std::size_t whole = digits_at(text, at);
    if (whole == 0 || (whole > 1 && text[at] == '0')) return 0;
    at += whole;
    if (at < text.size() && text[at] == '.') {
        const std::size_t part = digits_at(text, at + 1);
        if (part == 0) return 0;
        at += 1 + part;
    }
    if (at < text.size() && (text[at] == 'e' || text[at] == 'E')) {
        const bool has_sign = at + 1 < text.size() && (text[at + 1] == '+' || text[at + 1] == '-');
        const std::size_t digits = digits_at(text, at + 1 + (has_sign ? 1 : 0));
        if (digits == 0) return 0;
        at += 1 + (has_sign ? 1 : 0) + digits;
    }
    return at;
}

void append_utf8(std::string& out, std::uint32_t code) {
    const auto byte = [&](std::uint32_t value) { out += static_cast<char>(static_cast<unsigned char>(value)); };
    if (code < 0x80) return byte(code);
    if (code < 0x800) {
        byte(0xc0 | code >> 6U);
    } else {
        if (code < 0x10000) {
            byte(0xe0 | code >> 12U);
        } else {
            byte(0xf0 | code >> 18U);
            byte(0x80 | (code >> 12U & 0x3fU));
        }
        byte(0x80 | (code >> 6U & 0x3fU));
    }
    byte(0x80 | (code & 0x3fU));
}

}  // namespace

void JsonReader::fail(std::string what, ErrorCode code) {
    if (!good()) return;
    wrong_ = std::move(what);
    wrong_byte_ = at_;
    code_ = code;
}

void JsonReader::skip_space() noexcept {
    while (at_ < text_.size() &&
           (text_[at_] == ' ' || text_[at_] == '\n' || text_[at_] == '\r' || text_[at_] == '\t')) {
        ++at_;
    }
}

bool JsonReader::peek(char wanted) {
    skip_space();
    return at_ < text_.size() && text_[at_] == wanted;
}

bool JsonReader::take_if(char wanted) {
    const bool there = peek(wanted);
    if (there) ++at_;
    return there;
}

bool JsonReader::take(char wanted) {
    if (!good()) return false;
    if (take_if(wanted)) return true;
    fail(at_ == text_.size() ? "it ends here, in the middle" : joined({"a '", {&wanted, 1}, "' must be here"}));
    return false;
}

bool JsonReader::null() {
    skip_space();
    if (!good() || text_.substr(at_, 4) != "null") return false;
    at_ += 4;
    return true;
}

bool JsonReader::empty_array() {
    const std::size_t begin = at_;
    if (good() && take_if('[') && take_if(']')) return true;
    at_ = begin;
    return false;
}

void JsonReader::end() {
    skip_space();
    if (at_ != text_.size()) fail("nothing may follow the last brace");
}

std::size_t JsonReader::member_name(std::span<const std::string_view> names, std::uint64_t seen) {
    skip_space();
    const std::size_t begin = at_;
    const std::string name = text();
    for (std::size_t i = 0; i < names.size() && good(); ++i) {
        if (name != names[i]) continue;
        if ((seen >> i & 1U) != 0) {
            at_ = begin;
            fail(joined({"\"", name, "\" is there twice"}));
        }
        take(':');
        return i;
    }
    at_ = good() ? begin : at_;
    fail("a member with this name means nothing here");
    return 0;
}

double JsonReader::number() {
    skip_space();
    if (!good()) return 0;
    if (at_ < text_.size() && text_[at_] == '"') {
        const std::size_t begin = at_;
        const std::string word = text();
        if (word == infinity_word) return std::numeric_limits<double>::infinity();
        if (word == minus_infinity_word) return -std::numeric_limits<double>::infinity();
        constexpr std::size_t digits = 16;
        if (word.size() == nan_word.size() + digits && word.starts_with(nan_word)) {
            std::uint64_t bits = 0;
            const char* const last = word.data() + word.size();
            const auto read = std::from_chars(last - digits, last, bits, 16);
            const double value = std::bit_cast<double>(bits);
            if (read.ec == std::errc() && read.ptr == last && value != value) return value;
        }
        at_ = good() ? begin : at_;
        fail("a number must be here, or one of \"inf\", \"-inf\" and \"nan:\" with its 16 digits");
        return 0;
    }
    const std::size_t length = number_length(text_.substr(at_));
    double value = 0;
    const char* const first = text_.data() + at_;
    const auto read = std::from_chars(first, first + length, value);
    if (length == 0 || read.ec != std::errc() || read.ptr != first + length) {
        fail(length == 0 ? "a number must be here" : "no double is as large, or as small, as this number");
        return 0;
    }
    at_ += length;
    return value;
}

std::uint32_t JsonReader::whole_number() {
    skip_space();
    if (!good()) return 0;
    const std::size_t length = number_length(text_.substr(at_));
    std::uint32_t value = 0;
    const char* const first = text_.data() + at_;
    const auto read = std::from_chars(first, first + length, value);
    if (length == 0 || read.ec != std::errc() || read.ptr != first + length) {
        fail("a whole number from 0 to 4294967295 must be here");
        return 0;
    }
    at_ += length;
    return value;
}

std::uint64_t JsonReader::bits() {
    skip_space();
    const std::size_t begin = at_;
    const std::string word = text();
    std::uint64_t value = 0;
    const char* const last = word.data() + word.size();
    const auto read = std::from_chars(word.data(), last, value, 16);
    if (word.size() == 16 && read.ec == std::errc() && read.ptr == last) return value;
    at_ = good() ? begin : at_;
    fail("16 hexadecimal digits in quotes must be here");
    return 0;
}

bool JsonReader::yes() {
    skip_space();
    for (const auto& [word, value] : {std::pair<std::string_view, bool>{"true", true}, {"false", false}}) {
        if (!good() || text_.substr(at_, word.size()) != word) continue;
        at_ += word.size();
        return value;
    }
    fail("true or false must be here");
    return false;
}

std::uint32_t JsonReader::four_digits() {
    std::uint32_t code = 0;
    const std::string_view digits = text_.substr(at_, 4);
    const auto read = std::from_chars(digits.data(), digits.data() + digits.size(), code, 16);
    if (digits.size() != 4 || read.ec != std::errc() || read.ptr != digits.data() + 4) {
        fail("four hexadecimal digits must be here");
    } else {
        at_ += 4;
    }
    return code;
}

// After a backslash.
void JsonReader::character(std::string& out) {
    constexpr std::string_view written = "\"\\/bfnrt";
    constexpr std::string_view meant = "\"\\/\b\f\n\r\t";
    const char c = at_ < text_.size() ? text_[at_] : '\0';
    if (const std::size_t i = written.find(c); i != written.npos) {
        out += meant[i];
        ++at_;
        return;
    }
    if (c != 'u') return fail("no such escape");
    ++at_;
    std::uint32_t code = four_digits();
    if (code >= 0xd800 && code < 0xdc00) {
        if (text_.substr(at_, 2) != "\\u") return fail("the second half of a surrogate pair must be here");
        at_ += 2;
        const std::uint32_t second = four_digits();
        if (second < 0xdc00 || second > 0xdfff) return fail("the second half of a surrogate pair must be here");
        code = 0x10000 + ((code - 0xd800) << 10U) + (second - 0xdc00);
    } else if (code >= 0xdc00 && code <= 0xdfff) {
        return fail("half of a surrogate pair");
    }
    if (good()) append_utf8(out, code);
}

std::string JsonReader::text() {
    std::string out;
    take('"');
    while (good()) {
        if (at_ == text_.size()) {
            fail("it ends here, in the middle of a text");
        } else if (const char c = text_[at_]; c == '"') {
            ++at_;
            break;
        } else if (c == '\\') {
            ++at_;
            character(out);
        } else if (static_cast<unsigned char>(c) < 0x20) {
            fail("a control character in a text must be escaped");
        } else {
            out += c;
            ++at_;
        }
    }
    return out;
}

void JsonReader::numbers(std::span<double> list) {
    take('[');
    for (std::size_t i = 0; i < list.size() && good(); ++i) {
        if (i > 0) take(',');
        list[i] = number();
    }
    take(']');
}

dvec3 JsonReader::vector() {
    std::array<double, 3> v{};
    numbers(v);
    return {v[0], v[1], v[2]};
}

dquat JsonReader::turn() {
    std::array<double, 4> q{};
    numbers(q);
    return dquat(q[0], q[1], q[2], q[3]);
}

std::size_t JsonReader::one_of(std::span<const std::string_view> words) {
    skip_space();
    const std::size_t begin = at_;
    const std::string word = text();
    std::string known;
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (word == words[i]) return i;
        known += joined({i == 0 ? "\"" : ", \"", words[i], "\""});
    }
    at_ = good() ? begin : at_;
    fail(joined({"one of ", known, " must be here"}));
    return 0;
}

}  // namespace surefoot::internal
