// The bits: id Software, "Quake III Arena shader manual", surfaceparm; their numbers are those that its compiler
// writes.
#include "flags.hpp"

#include <array>
#include <string_view>

namespace surefoot::internal::quake3 {
namespace {

struct Flag {
    std::uint32_t bit;
    std::string_view name;
};

constexpr std::array surface_names{Flag{0x1, "nodamage"},
                                   Flag{surface_slick, "slick"},
                                   Flag{0x4, "sky"},
                                   Flag{surface_ladder, "ladder"},
                                   Flag{0x10, "noimpact"},
                                   Flag{0x20, "nomarks"},
                                   Flag{0x40, "flesh"},
                                   Flag{surface_nodraw, "nodraw"},
                                   Flag{0x100, "hint"},
                                   Flag{0x200, "skip"},
                                   Flag{0x400, "nolightmap"},
                                   Flag{0x800, "pointlight"},
                                   Flag{0x1000, "metalsteps"},
                                   Flag{0x2000, "nosteps"},
                                   Flag{0x4000, "nonsolid"},
                                   Flag{0x8000, "lightfilter"},
                                   Flag{0x10000, "alphashadow"},
                                   Flag{0x20000, "nodlight"},
                                   Flag{0x40000, "dust"}};

// Without "detail" and "structural", which tell the compiler how to cut the map and a player nothing: a texture often
// occurs both ways and is one surface all the same.
constexpr std::array content_names{Flag{contents_solid, "solid"},
                                   Flag{0x8, "lava"},
                                   Flag{0x10, "slime"},
                                   Flag{0x20, "water"},
                                   Flag{0x40, "fog"},
                                   Flag{0x80, "notteam1"},
                                   Flag{0x100, "notteam2"},
                                   Flag{0x200, "nobotclip"},
                                   Flag{0x8000, "areaportal"},
                                   Flag{contents_player_clip, "playerclip"},
                                   Flag{0x20000, "monsterclip"},
                                   Flag{0x40000, "teleporter"},
                                   Flag{0x80000, "jumppad"},
                                   Flag{0x100000, "clusterportal"},
                                   Flag{0x200000, "donotenter"},
                                   Flag{0x400000, "botclip"},
                                   Flag{0x800000, "mover"},
                                   Flag{0x1000000, "origin"},
                                   Flag{0x20000000, "translucent"},
                                   Flag{0x40000000, "trigger"},
                                   Flag{0x80000000, "nodrop"}};

template <std::size_t n>
std::string names_of(std::uint32_t flags, const std::array<Flag, n>& known) {
    std::string list = "[";
    for (const Flag& flag : known) {
        if ((flags & flag.bit) == 0) continue;
        if (list.size() > 1) list += ',';
        list += '"';
        list += flag.name;
        list += '"';
    }
    return list + ']';
}

}  // namespace

std::string surface_extras(std::uint32_t surface_flags, std::uint32_t content_flags) {
    std::string extras = "{";
    if ((surface_flags & surface_slick) != 0) {
        extras += R"("surefoot":{"friction":0,"slippery":1},)";
    } else if ((surface_flags & surface_ladder) != 0) {
        extras += R"("surefoot":{"ladder":1},)";
    }
    return extras + R"("quake3":{"surface":)" + names_of(surface_flags, surface_names) + R"(,"contents":)" +
           names_of(content_flags, content_names) + "}}";
}

}  // namespace surefoot::internal::quake3
