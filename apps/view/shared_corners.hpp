/// Corners of triangles that are one vertex, so that a graphics card, or a processor in its place, works each out once.
#pragma once

#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "view/colour.hpp"
#include "view/gl.hpp"

namespace surefoot::view {

/// A direction in bytes, and the pattern of the triangle whose last corner has it.
struct SmallNormal {
    std::int8_t x, y, z, pattern;
    bool operator==(const SmallNormal&) const = default;
};

/// What a triangle is as a whole (its colour and, if triangles are flat, its normal) is read from its last corner. So a
/// vertex may be that of many triangles, but the last one only of those that look alike: a common mesh comes to about
/// as many vertices as triangles, a third of what there are otherwise.
class SharedCorners {
public:
    struct Vertex {
        gl::vec3 position;
        SmallNormal normal;
        Colour colour;
    };
    static_assert(sizeof(Vertex) == 20);

    struct Corner {
        gl::vec3 position;
        SmallNormal normal;
    };
    struct Face {
        std::array<Corner, 3> corners;
        Colour colour;
    };

    /// Flat triangles share corners whose normals differ; others have to agree there.
    explicit SharedCorners(bool flat) : flat_(flat) {}

    /// What comes now shares nothing with what came before: vertices of a chunk lie together.
    void begin_chunk() { newest_at_.clear(); }
    void add(const Face& face);

    [[nodiscard]] const std::vector<Vertex>& vertices() const { return vertices_; }

    /// Three for every face, wound as it was.
    [[nodiscard]] const std::vector<std::uint32_t>& indices() const { return indices_; }

private:
    using Place = std::array<std::uint32_t, 4>;  // bits of a position and, if they matter, of a normal
    struct PlaceHash {
        std::size_t operator()(const Place& place) const;
    };
    static constexpr std::uint32_t none = ~0U;

    [[nodiscard]] Place place_of(const Corner& corner) const;
    [[nodiscard]] std::uint32_t newest_at(const Corner& corner) const;
    std::uint32_t make(const Corner& corner, Colour colour);
    /// A vertex at this corner that may be the last of a face: one that is already and looks alike, or one that is not
    /// yet.
    [[nodiscard]] std::uint32_t find_last(const Corner& corner, Colour colour, bool alike) const;

    bool flat_;
    std::vector<Vertex> vertices_;
    std::vector<std::uint32_t> older_;  // another vertex at the same place, or none
    std::vector<char> is_last_;         // of some face
    std::vector<std::uint32_t> indices_;
    std::unordered_map<Place, std::uint32_t, PlaceHash> newest_at_;
};

}  // namespace surefoot::view
