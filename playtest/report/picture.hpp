/// Pictures in memory, and the addresses under which a page holds them and other files within itself.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace surefoot::playtest {

struct Picture {
    int width = 0;   ///< [pixels]
    int height = 0;  ///< [pixels]
    std::vector<std::uint8_t> rgba{};

    Picture() = default;
    /// Clear everywhere.
    Picture(int wide, int high) : width(wide), height(high), rgba(std::size_t(wide) * std::size_t(high) * 4) {}
};

/// As the bytes of a .png.
[[nodiscard]] std::string png(const Picture& picture);

[[nodiscard]] std::string base64(std::string_view bytes);

/// "data:image/png;base64,...".
[[nodiscard]] std::string data_uri(const Picture& picture);

}  // namespace surefoot::playtest
