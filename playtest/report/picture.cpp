#include "playtest/report/picture.hpp"

#include <algorithm>
// The pictures are small and their bytes are wanted in memory; nothing here is called from elsewhere.
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
#endif
#include <stb/stb_image_write.h>
#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif

namespace surefoot::playtest {

std::string base64(std::string_view bytes) {
    static constexpr char letters[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string out;
    out.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const auto byte = [&](std::size_t k) { return k < bytes.size() ? std::uint32_t(std::uint8_t(bytes[k])) : 0U; };
        const std::uint32_t three = byte(i) << 16U | byte(i + 1) << 8U | byte(i + 2);
        out += letters[three >> 18U & 63U];
        out += letters[three >> 12U & 63U];
        out += i + 1 < bytes.size() ? letters[three >> 6U & 63U] : '=';
        out += i + 2 < bytes.size() ? letters[three & 63U] : '=';
    }
    return out;
}

std::string png(const Picture& picture) {
    std::string bytes;
    const auto take = [](void* context, void* data, int size) {
        static_cast<std::string*>(context)->append(static_cast<const char*>(data), std::size_t(size));
    };
    // What is opaque everywhere needs no fourth channel.
    const std::size_t pixels = std::size_t(picture.width) * std::size_t(picture.height);
    bool is_opaque = true;
    for (std::size_t i = 0; i < pixels; ++i) is_opaque = is_opaque && picture.rgba[4 * i + 3] == 255;
    if (is_opaque) {
        std::vector<std::uint8_t> rgb(pixels * 3);
        for (std::size_t i = 0; i < pixels; ++i) std::copy_n(&picture.rgba[4 * i], 3, &rgb[3 * i]);
        stbi_write_png_to_func(take, &bytes, picture.width, picture.height, 3, rgb.data(), picture.width * 3);
    } else {
        stbi_write_png_to_func(take, &bytes, picture.width, picture.height, 4, picture.rgba.data(), picture.width * 4);
    }
    return bytes;
}

std::string data_uri(const Picture& picture) {
    return "data:image/png;base64," + base64(png(picture));
}

}  // namespace surefoot::playtest
