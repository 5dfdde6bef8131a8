/// The lumps of an IBSP 46 file that collision needs, checked: every run and every index in them is within its lump.
/// Left to who uses them, because no file makes them check more than once what it has once: the mesh vertices of a
/// face, and whether its vertices are finite.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <surefoot/error.hpp>
#include <surefoot/math.hpp>

namespace surefoot::internal::quake3 {

enum class Lump : std::uint8_t {
    entities = 0,
    textures = 1,
    planes = 2,
    models = 7,
    brushes = 8,
    brush_sides = 9,
    vertices = 10,
    mesh_vertices = 11,
    faces = 13,
};

/// A run of elements of another lump.
struct Run {
    std::uint32_t first = 0;
    std::uint32_t count = 0;
};

struct Texture {
    std::string name;
    std::uint32_t surface_flags = 0;
    std::uint32_t content_flags = 0;
};

/// What is in front of it has normal . x > distance. Normals are unit to within a thousandth.
struct Plane {
    dvec3 normal{0, 0, 0};
    double distance = 0;
};

/// The world (the first), or what an entity moves or is triggered by.
struct Model {
    vec3 min{0, 0, 0};
    vec3 max{0, 0, 0};
    Run faces;
    Run brushes;
};

struct Brush {
    Run sides;
    std::uint32_t texture = 0;
};

struct BrushSide {
    std::uint32_t plane = 0;
    std::uint32_t texture = 0;
};

enum class FaceType : std::uint32_t { polygon = 1, patch = 2, mesh = 3, flare = 4 };

struct Face {
    std::uint32_t texture = 0;
    FaceType type = FaceType::flare;
    Run vertices;
    Run mesh_vertices;         ///< three a triangle, each counted from vertices.first
    std::uint32_t width = 0;   ///< control points of a patch
    std::uint32_t height = 0;  ///< ... whose product is vertices.count
};

/// The first byte and the length of a lump within the file.
struct Extent {
    std::uint64_t first = 0;
    std::uint64_t size = 0;
};

struct Map {
    std::array<Extent, 17> lumps{};
    std::string_view entities;  ///< of the bytes that were read
    std::vector<Texture> textures;
    std::vector<Plane> planes;
    std::vector<Model> models;  ///< at least one
    std::vector<Brush> brushes;
    std::vector<BrushSide> brush_sides;
    std::vector<vec3> vertices;                ///< may hold NaN and infinity
    std::vector<std::uint32_t> mesh_vertices;  ///< may be any numbers
    std::vector<Face> faces;
};

/// Any bytes are fine. Takes memory in proportion to them.
[[nodiscard]] Expected<Map> read_map(std::span<const std::byte> file);

/// "lump 13 (faces), face 17 at byte 4711: ..." with the code `invalid`.
[[nodiscard]] Error bad_element(const Map& map, Lump lump, std::uint64_t index, std::string_view what);

/// "lump 0 (entities), byte 4711: ..." for a place within the lump.
[[nodiscard]] Error bad_byte(const Map& map, Lump lump, std::uint64_t place, std::string_view what);

}  // namespace surefoot::internal::quake3
