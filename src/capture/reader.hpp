// A reader of JSON for a form that is known beforehand: it takes what the form says and nothing else, and remembers the
// first thing that is wrong. Nothing is nested deeper than the form, so nothing of its recursion is the file's.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include <surefoot/error.hpp>
#include <surefoot/math.hpp>

#include "capture/number.hpp"

namespace surefoot::internal {

class JsonReader {
public:
    explicit JsonReader(std::string_view text) noexcept : text_(text) {}

    [[nodiscard]] bool good() const noexcept { return wrong_.empty(); }
    /// The first thing that was wrong, in words, and where.
    [[nodiscard]] const std::string& wrong() const noexcept { return wrong_; }
    [[nodiscard]] std::uint64_t byte() const noexcept { return wrong_byte_; }
    [[nodiscard]] ErrorCode code() const noexcept { return code_; }

    /// Remembers this as what is wrong here, unless something was wrong before.
    void fail(std::string what, ErrorCode code = ErrorCode::unreadable);

    /// The members of an object, in any order, each at most once: calls `read(index)` for each of `names`, after its
    /// name and colon. All of the first `required` must be there. Returns which were, a bit each.
    /// Requires: at most 64 names.
    template <typename Read>
    std::uint64_t object(std::span<const std::string_view> names, std::size_t required, const Read& read) {
        std::uint64_t seen = 0;
        take('{');
        if (!peek('}')) {
            do {
                const std::size_t index = member_name(names, seen);
                if (!good()) return seen;
                seen |= std::uint64_t{1} << index;
                read(index);
            } while (good() && take_if(','));
        }
        take('}');
        for (std::size_t i = 0; i < required && good(); ++i)
            if ((seen >> i & 1U) == 0) fail(joined({"\"", names[i], "\" is missing in this object"}));
        return seen;
    }

    /// Calls `read()` for each element of an array.
    template <typename Read>
    void array(const Read& read) {
        take('[');
        if (!peek(']')) {
            do {
                read();
            } while (good() && take_if(','));
        }
        take(']');
    }

    [[nodiscard]] double number();
    [[nodiscard]] std::uint32_t whole_number();
    [[nodiscard]] std::uint64_t bits();  ///< 16 hexadecimal digits, in quotes
    [[nodiscard]] bool yes();
    [[nodiscard]] std::string text();
    [[nodiscard]] dvec3 vector();
    [[nodiscard]] dquat turn();  ///< w, x, y, z
    void numbers(std::span<double> list);
    /// One of the words, as its index.
    [[nodiscard]] std::size_t one_of(std::span<const std::string_view> words);
    /// Takes `null` if it is there.
    [[nodiscard]] bool null();
    /// Takes `[]` if it is there.
    [[nodiscard]] bool empty_array();
    /// Nothing but white space may follow.
    void end();

    bool take(char wanted);  ///< after white space; fails if something else is there
    [[nodiscard]] bool take_if(char wanted);
    [[nodiscard]] bool peek(char wanted);

private:
    void skip_space() noexcept;
    std::size_t member_name(std::span<const std::string_view> names, std::uint64_t seen);
    void character(std::string& out);
    std::uint32_t four_digits();

    std::string_view text_;
    std::size_t at_ = 0;
    std::string wrong_;
    std::uint64_t wrong_byte_ = 0;
    ErrorCode code_ = ErrorCode::unreadable;
};

}  // namespace surefoot::internal
