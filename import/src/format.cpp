#include "format.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

namespace surefoot::internal {
namespace {

constexpr std::array<std::pair<std::string_view, Format>, 11> endings{{{"obj", Format::obj},
                                                                       {"gltf", Format::gltf},
                                                                       {"glb", Format::glb},
                                                                       {"ply", Format::ply},
                                                                       {"stl", Format::stl},
                                                                       {"ac", Format::ac},
                                                                       {"ac3d", Format::ac},
                                                                       {"acc", Format::ac},
                                                                       {"blend", Format::blend},
                                                                       {"bsp", Format::bsp},
                                                                       {"pk3", Format::pk3}}};

std::string ending_of(const std::string& path) {
    const std::size_t slash = path.find_last_of("/\\");
    const std::size_t dot = path.find_last_of('.');
    if (dot == std::string::npos || (slash != std::string::npos && dot < slash)) return {};
    std::string ending = path.substr(dot + 1);
    for (char& c : ending) {
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    }
    return ending;
}

}  // namespace

Expected<Format> format_of(const std::string& path) {
    const std::string ending = ending_of(path);
    const auto* const found =
        std::ranges::find(endings, std::string_view(ending), &std::pair<std::string_view, Format>::first);
    if (found != endings.end()) return found->second;
    return tl::unexpected(
        Error{.code = ErrorCode::unsupported,
              .text = (ending.empty() ? std::string("its name does not tell what kind of file it is")
                                      : "files ending in ." + ending + " are not read here") +
                      "; export the level as .glb, .gltf, .obj, .ply, .stl, .ac, .blend, .bsp or .pk3",
              .file = path});
}

UpAxis usual_up(Format format) noexcept {
    switch (format) {
        case Format::stl:
        case Format::ply:
        case Format::blend:
        case Format::bsp:
        case Format::pk3:
            return UpAxis::z;
        case Format::obj:
        case Format::gltf:
        case Format::glb:
        case Format::ac:
            break;
    }
    return UpAxis::y;
}

double usual_scale(Format format) noexcept {
    return format == Format::bsp || format == Format::pk3 ? 1.0 / 32 : 1.0;
}

BlendAge blend_age(std::string_view head) noexcept {
    // "BLENDER", the size of a pointer, the order of bytes, and the version in three digits. Blender 3.0 and later may
    // pack all of it with Zstandard, whose files begin so; older ones with gzip, behind which any age can hide.
    if (head.starts_with("\x28\xb5\x2f\xfd") || head.starts_with("\x1f\x8b")) return BlendAge::current;
    if (!head.starts_with("BLENDER") || head.size() < 12) return BlendAge::no_blend;
    const std::string_view version = head.substr(9, 3);
    if (!std::ranges::all_of(version, [](char c) { return c >= '0' && c <= '9'; })) return BlendAge::current;
    return version < "280" ? BlendAge::old : BlendAge::current;
}

}  // namespace surefoot::internal
