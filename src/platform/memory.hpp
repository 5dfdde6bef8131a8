// Memory as the operating system hands it out.
#pragma once

#include <cstddef>
#include <span>

namespace surefoot::internal {

/// Large blocks begin where a huge page may begin.
constexpr std::size_t alignment_for(std::size_t size) noexcept {
    constexpr std::size_t cache_line = 64;
    constexpr std::size_t huge_page = std::size_t{1} << 21U;
    return size >= huge_page ? huge_page : cache_line;
}

/// Asks for huge pages under freshly allocated memory. Advice only: without them it is slower, not wrong.
void advise_huge_pages(void* memory, std::size_t size) noexcept;

/// Gives back what `MappedFile` mapped.
void unmap(std::span<const std::byte> bytes) noexcept;

}  // namespace surefoot::internal
