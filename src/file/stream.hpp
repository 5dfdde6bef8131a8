// Small things one behind the other in the bytes of a section, little-endian, and reading them from bytes that may be
// anything.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace surefoot::internal {

class ByteWriter {
public:
    template <typename T>
    requires std::is_arithmetic_v<T>
    void put(T value) {
        const auto* const bytes = reinterpret_cast<const std::byte*>(&value);
        bytes_.insert(bytes_.end(), bytes, bytes + sizeof(T));
    }
    void put(std::string_view text) {
        put(static_cast<std::uint32_t>(text.size()));
        const auto* const bytes = reinterpret_cast<const std::byte*>(text.data());
        bytes_.insert(bytes_.end(), bytes, bytes + text.size());
    }
    [[nodiscard]] std::vector<std::byte> take() { return std::move(bytes_); }

private:
    std::vector<std::byte> bytes_;
};

/// Once something did not fit, everything after it reads as zeros and `good` says no.
class ByteReader {
public:
    explicit ByteReader(std::span<const std::byte> bytes) noexcept : rest_(bytes) {}

    template <typename T>
    requires std::is_arithmetic_v<T>
    [[nodiscard]] T take() noexcept {
        T value{};
        if (!has(sizeof(T))) return value;
        std::memcpy(&value, rest_.data(), sizeof(T));
        rest_ = rest_.subspan(sizeof(T));
        return value;
    }
    [[nodiscard]] std::string take_text() {
        const auto size = take<std::uint32_t>();
        if (!has(size)) return {};
        std::string text(reinterpret_cast<const char*>(rest_.data()), size);
        rest_ = rest_.subspan(size);
        return text;
    }
    /// How many things follow, each of at least this many bytes; 0 if there cannot be so many.
    [[nodiscard]] std::uint32_t take_count(std::size_t smallest) noexcept {
        const auto count = take<std::uint32_t>();
        return has(std::uint64_t{count} * smallest) ? count : 0;
    }
    [[nodiscard]] bool good() const noexcept { return good_; }

private:
    bool has(std::uint64_t size) noexcept {
        good_ = good_ && size <= rest_.size();
        return good_;
    }

    std::span<const std::byte> rest_;
    bool good_ = true;
};

}  // namespace surefoot::internal
