#include "page_parts.hpp"

#include <set>
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#endif
#include <stb/stb_image.h>
#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif

namespace surefoot::test {

Decoded decoded(const std::string& png) {
    Decoded made;
    int channels = 0;
    stbi_uc* const pixels = stbi_load_from_memory(reinterpret_cast<const stbi_uc*>(png.data()), int(png.size()),
                                                  &made.width, &made.height, &channels, 3);
    if (pixels == nullptr) return {};
    std::set<std::uint32_t> colours;
    for (int i = 0; i < made.width * made.height; ++i)
        colours.insert(std::uint32_t(pixels[3 * i]) << 16U | std::uint32_t(pixels[3 * i + 1]) << 8U |
                       std::uint32_t(pixels[3 * i + 2]));
    made.colours = colours.size();
    stbi_image_free(pixels);
    return made;
}

}  // namespace surefoot::test
