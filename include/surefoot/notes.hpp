/// What a level says besides its triangles: what its surfaces are called, which triangles had one name, and the places
/// that mean something to the game.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <surefoot/math.hpp>

namespace [[gnu::visibility("default")]] surefoot {
inline namespace v0 {

/// A run of triangles that had one name in the file: a node, an object or a group.
struct Part {
    std::string name;                  ///< as in the file, empty if it has none; names may repeat
    std::uint32_t first_triangle = 0;  ///< id of its first triangle
    std::uint32_t triangle_count = 0;  ///< at least 1; parts lie one after the other and cover all triangles
};

/// A named place with meaning for the game: a spawn, a goal, a platform's path.
struct Marker {
    std::string name;               ///< the node's name, empty if it has none
    std::string kind;               ///< `extras.surefoot.kind`, else `extras.kind`, if that is text; else empty
    std::string extras;             ///< the node's extras, JSON text in the order of the file; empty if it has none
    dvec3 position{0, 0, 0};        ///< in the level's axes [m]
    dquat orientation{1, 0, 0, 0};  ///< unit; turns the node's own axes (+Y up) into the level's
    dvec3 scale{1, 1, 1};           ///< along the node's own axes; x < 0 if mirrored
};

/// All of it. A cooked file carries it beside the triangles.
struct LevelNotes {
    std::vector<std::string> surface_names;   ///< by surface number; [0] is "": nothing is said
    std::vector<std::string> surface_extras;  ///< one a surface: JSON text, or empty; or none at all
    std::vector<Part> parts;
    std::vector<Marker> markers;
};

}  // namespace v0
}  // namespace surefoot
