#include "view/picture.hpp"

#include <algorithm>
#include <set>
#include <stb/stb_image_write.h>

#include "view/gl.hpp"

namespace surefoot::view {

std::size_t Picture::colours(std::size_t most) const {
    std::set<std::uint32_t> seen;
    for (const Colour& c : pixels) {
        seen.insert(std::uint32_t{c.r} | std::uint32_t{c.g} << 8U | std::uint32_t{c.b} << 16U);
        if (seen.size() >= most) break;
    }
    return seen.size();
}

Picture read_picture(unsigned framebuffer, const ivec2& size) {
    Picture picture{size, std::vector<Colour>(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y))};
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, size.x, size.y, GL_RGBA, GL_UNSIGNED_BYTE, picture.pixels.data());
    const auto row = [&](int y) { return picture.pixels.begin() + std::ptrdiff_t{y} * size.x; };
    for (int y = 0; y < size.y / 2; ++y) std::swap_ranges(row(y), row(y) + size.x, row(size.y - 1 - y));
    for (Colour& c : picture.pixels) c.a = 255;
    return picture;
}

Expected<void> write_png(const Picture& picture, const std::string& path) {
    constexpr int channels = 4;
    if (stbi_write_png(path.c_str(), picture.size.x, picture.size.y, channels, picture.pixels.data(),
                       picture.size.x * channels) != 0)
        return {};
    return tl::unexpected(Error{ErrorCode::write_failed,
                                path + ": the picture cannot be written; is there such a folder, and room on the disk?",
                                path, 0});
}

}  // namespace surefoot::view
