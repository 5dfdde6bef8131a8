/// A picture in memory: what a framebuffer holds, and the PNG that is made of it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <surefoot/error.hpp>

#include "view/colour.hpp"
#include "view/input.hpp"

namespace surefoot::view {

struct Picture {
    ivec2 size{0, 0};
    std::vector<Colour> pixels;  ///< row by row from the top

    [[nodiscard]] const Colour& at(int x, int y) const {
        return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(size.x) + static_cast<std::size_t>(x)];
    }

    /// How many different colours there are, counted up to `most`.
    [[nodiscard]] std::size_t colours(std::size_t most = 4096) const;
};

/// Reads a framebuffer object.
[[nodiscard]] Picture read_picture(unsigned framebuffer, const ivec2& size);

/// Writes a PNG; the folder has to be there.
[[nodiscard]] Expected<void> write_png(const Picture& picture, const std::string& path);

}  // namespace surefoot::view
