// Room for many plain values on the stack that is not written before it is used.
#pragma once

#include <cstddef>
#include <new>
#include <span>
#include <type_traits>

namespace surefoot::internal {

/// Requires: a value is read only after it was written.
template <typename T, std::size_t room>
class RawArray {
    static_assert(std::is_trivially_copyable_v<T> && std::is_trivially_destructible_v<T>);

public:
    static constexpr std::size_t size = room;

    [[nodiscard]] T* data() noexcept { return std::launder(reinterpret_cast<T*>(bytes_)); }
    [[nodiscard]] const T* data() const noexcept { return std::launder(reinterpret_cast<const T*>(bytes_)); }
    [[nodiscard]] T& operator[](std::size_t i) noexcept { return data()[i]; }
    [[nodiscard]] const T& operator[](std::size_t i) const noexcept { return data()[i]; }
    [[nodiscard]] std::span<T> all() noexcept { return {data(), room}; }

private:
    alignas(T) std::byte bytes_[room * sizeof(T)];
};

}  // namespace surefoot::internal
