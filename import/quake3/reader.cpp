#include "reader.hpp"

#include <cmath>
#include <string>
#include <vector>

#include "brush.hpp"
#include "entities.hpp"
#include "flags.hpp"
#include "map.hpp"
#include "markers.hpp"
#include "patch.hpp"

namespace surefoot::internal::quake3 {
namespace {

// A large map has 3,000 patches, 50,000 control points and, at the usual tolerance, 500,000 triangles of patches.
constexpr std::uint64_t max_patch_points = std::uint64_t{1} << 22;
constexpr std::uint64_t max_patch_triangles = std::uint64_t{1} << 24;

/// Models whose triangles stand in the level: the world, and what an entity shows and moves.
struct Placed {
    std::uint32_t model = 0;
    std::string name;
    dvec3 origin{0, 0, 0};
};

struct PlacedPatch {
    std::uint32_t face = 0;
    std::size_t placed = 0;
};

class MapBuilder {
public:
    MapBuilder(const Map& map, const Placement& placement, const ReadLimits& limits, const MapOptions& options)
        : map_(map),
          placement_(placement),
          options_(options),
          builder_(limits),
          cutter_(options.tolerance / placement.scale) {
        for (const Texture& texture : map.textures)
            extras_.push_back(surface_extras(texture.surface_flags, texture.content_flags));
    }

    Expected<ImportedLevel> build(const std::vector<Entity>& entities) {
        place_models(entities);
        if (auto error = add_patches()) return tl::unexpected(std::move(*error));
        for (std::size_t i = 0; i < placed_.size(); ++i) {
            if (auto error = add_model(i)) return tl::unexpected(std::move(*error));
        }
        const ImportNotes notes = builder_.notes();
        ImportedLevel level = builder_.take();
        level.notes = notes;
        if (level.indices.empty()) {
            return tl::unexpected(
                bad_element(map_, Lump::models, 0, "nothing in the map stops a player; is it a map, and not a model?"));
        }
        level.markers = markers_of(map_, entities, placement_);
        return level;
    }

private:
    using Result = std::optional<Error>;

    [[nodiscard]] bool draws() const { return options_.solids == Quake3Solids::drawn; }

    /// Triggers are no bodies, whatever they are made of, and a model of which no entity tells is nowhere.
    void place_models(const std::vector<Entity>& entities) {
        placed_.push_back({.model = 0, .name = "world", .origin = dvec3(0, 0, 0)});
        for (const Entity& entity : entities) {
            const std::string_view class_name = entity.value("classname");
            const auto model = entity.model(map_.models.size());
            if (!model || *model == 0 || !class_name.starts_with("func_") || class_name == "func_illusionary") continue;
            placed_.push_back({.model = *model,
                               .name = std::string(class_name) + " *" + std::to_string(*model),
                               .origin = entity.vector("origin").value_or(dvec3(0, 0, 0))});
        }
    }

    /// Whoever looks at `n` things pays here, so that no file can make us work for ever.
    Result pay(std::uint64_t n) {
        work_ += n;
        if (work_ < 65536) return std::nullopt;
        work_ = 0;
        return builder_.check_limits();
    }

    Result add_vertex(const dvec3& v, Lump lump, std::uint64_t index) {
        const vec3 placed = placement_.vertex(v);
        if (!std::isfinite(placed.x) || !std::isfinite(placed.y) || !std::isfinite(placed.z)) {
            return bad_element(
                map_, lump, index,
                "a coordinate is not finite, or no finite float once scaled; compile the map again, or use "
                "a smaller ImportOptions::scale");
        }
        builder_.add_vertex(placed);
        return std::nullopt;
    }

    [[nodiscard]] bool is_solid(const Face& face) const {
        return face.type != FaceType::flare && stops_players(map_.textures[face.texture].content_flags);
    }

    void set_surface(std::uint32_t texture) { builder_.set_surface(map_.textures[texture].name, extras_[texture]); }

    [[nodiscard]] Patch patch_of(const Face& face) const {
        const auto first = map_.vertices.begin() + face.vertices.first;
        return {.width = face.width, .height = face.height, .points = {first, first + face.vertices.count}};
    }

    /// All patches are told of before the first is cut.
    Result add_patches() {
        std::uint64_t points = 0;
        for (std::size_t i = 0; i < placed_.size(); ++i) {
            const Run faces = map_.models[placed_[i].model].faces;
            for (std::uint32_t number = faces.first; number < faces.first + faces.count; ++number) {
                const Face& face = map_.faces[number];
                if (auto error = pay(1)) return error;
                if (face.type != FaceType::patch || !is_solid(face)) continue;
                points += face.vertices.count;
                if (points > max_patch_points)
                    return over_limit(number, "the patches have more than 4 million control points");
                if (auto error = pay(64 * std::uint64_t{face.vertices.count})) return error;
                if (auto error = add_patch(number)) return error;
                patches_.push_back({.face = number, .placed = i});
            }
        }
        cutter_.settle();
        std::uint64_t triangles = 0;
        for (std::size_t i = 0; i < patches_.size(); ++i) {
            const Face& face = map_.faces[patches_[i].face];
            triangles += cutter_.triangle_count(i, face.width, face.height);
            if (triangles > max_patch_triangles)
                return over_limit(patches_[i].face, "the patches would become more than 16 million triangles");
        }
        return std::nullopt;
    }

    Result add_patch(std::uint32_t number) {
        const Patch patch = patch_of(map_.faces[number]);
        for (std::size_t k = 0; k < patch.points.size(); ++k) {
            const vec3& p = patch.points[k];
            if (std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z)) continue;
            return bad_element(map_, Lump::vertices, map_.faces[number].vertices.first + k,
                               "a coordinate of a patch is not finite; compile the map again");
        }
        if (cutter_.add(patch)) return std::nullopt;
        return over_limit(number, "a curve of this patch would need more than 1024 pieces");
    }

    [[nodiscard]] Error over_limit(std::uint32_t face, const std::string& what) const {
        Error error = bad_element(map_, Lump::faces, face, what + "; use a larger ImportOptions::tolerance");
        error.code = ErrorCode::limit;
        return error;
    }

    Result add_model(std::size_t placed) {
        const Model& model = map_.models[placed_[placed].model];
        if (draws()) {
            for (const FaceType type : {FaceType::polygon, FaceType::mesh}) {
                begin_part(placed, type == FaceType::polygon ? "polygons" : "meshes");
                for (std::uint32_t n = model.faces.first; n < model.faces.first + model.faces.count; ++n) {
                    if (auto error = pay(1)) return error;
                    if (map_.faces[n].type != type) continue;
                    if (auto error = add_face(placed, n)) return error;
                }
            }
        }
        begin_part(placed, "patches");
        for (; next_patch_ < patches_.size() && patches_[next_patch_].placed == placed; ++next_patch_) {
            if (auto error = add_patch_triangles(next_patch_)) return error;
        }
        begin_part(placed, draws() ? "invisible brushes" : "brushes");
        for (std::uint32_t n = model.brushes.first; n < model.brushes.first + model.brushes.count; ++n) {
            if (auto error = add_brush(placed, n)) return error;
        }
        return std::nullopt;
    }

    void begin_part(std::size_t placed, const char* what) { builder_.begin_part(placed_[placed].name + " " + what); }

    Result add_face(std::size_t placed, std::uint32_t number) {
        const Face& face = map_.faces[number];
        if (!is_solid(face)) {
            ++builder_.notes().nonsolid_skipped;
            return std::nullopt;
        }
        const std::size_t first = builder_.vertex_count();
        for (std::uint32_t k = 0; k < face.vertices.count; ++k) {
            const std::uint64_t vertex = std::uint64_t{face.vertices.first} + k;
            if (auto error = pay(1)) return error;
            if (auto error = add_vertex(dvec3(map_.vertices[vertex]) + placed_[placed].origin, Lump::vertices, vertex))
                return error;
        }
        set_surface(face.texture);
        // The game's fronts are clockwise.
        corners_.clear();
        if (face.mesh_vertices.count == 0) {
            for (std::uint32_t k = face.vertices.count; k-- > 0;)
                corners_.push_back(static_cast<std::uint32_t>(first + k));
            return builder_.add_face(corners_);
        }
        for (std::uint32_t k = 0; k < face.mesh_vertices.count; k += 3) {
            corners_.clear();
            for (const std::uint32_t offset : {2u, 1u, 0u}) {
                const std::uint64_t place = std::uint64_t{face.mesh_vertices.first} + k + offset;
                const std::uint32_t corner = map_.mesh_vertices[place];
                if (corner >= face.vertices.count) {
                    return bad_element(map_, Lump::mesh_vertices, place,
                                       "a triangle of face " + std::to_string(number) + " uses its vertex " +
                                           std::to_string(corner) + ", and it has " +
                                           std::to_string(face.vertices.count) + "; compile the map again");
                }
                corners_.push_back(static_cast<std::uint32_t>(first + corner));
            }
            if (auto error = builder_.add_face(corners_)) return error;
        }
        return std::nullopt;
    }

    Result add_patch_triangles(std::size_t index) {
        const std::uint32_t number = patches_[index].face;
        const Face& face = map_.faces[number];
        const Patch patch = patch_of(face);
        const PatchTriangles cut = cutter_.cut(index, patch);
        const auto first = static_cast<std::uint32_t>(builder_.vertex_count());
        for (const dvec3& point : cut.points) {
            if (auto error = add_vertex(point + placed_[patches_[index].placed].origin, Lump::faces, number))
                return error;
        }
        set_surface(face.texture);
        for (const auto& [a, b, c] : cut.triangles) {
            corners_ = {first + a, first + b, first + c};
            if (auto error = builder_.add_face(corners_)) return error;
        }
        ++builder_.notes().patches;
        return pay(64 * cut.points.size());
    }

    /// A side that stops players and is never seen, so that no face stands for it.
    [[nodiscard]] bool is_invisible(const Brush& brush, std::uint64_t side) const {
        if ((map_.textures[brush.texture].content_flags & contents_player_clip) != 0) return true;
        return (map_.textures[map_.brush_sides[brush.sides.first + side].texture].surface_flags & surface_nodraw) != 0;
    }

    [[nodiscard]] bool has_invisible_side(const Brush& brush) const {
        for (std::uint64_t side = 0; side < brush.sides.count; ++side) {
            if (is_invisible(brush, side)) return true;
        }
        return false;
    }

    Result add_brush(std::size_t placed, std::uint32_t number) {
        const Brush& brush = map_.brushes[number];
        const std::uint32_t contents = map_.textures[brush.texture].content_flags;
        if (auto error = pay(1)) return error;
        if (!stops_players(contents)) return std::nullopt;
        if (draws() && !has_invisible_side(brush)) return std::nullopt;

        planes_.clear();
        const std::uint64_t sides = brush.sides.count;
        if (sides <= max_brush_sides) {
            for (std::uint64_t k = 0; k < sides; ++k)
                planes_.push_back(map_.planes[map_.brush_sides[brush.sides.first + k].plane]);
        }
        if (auto error = pay(sides * sides)) return error;
        const BrushShape shape = shape_of(planes_);
        if (sides > max_brush_sides || shape.state == BrushShape::State::too_large) {
            return bad_element(map_, Lump::brushes, number,
                               "it has " + std::to_string(sides) + " sides, and at most " +
                                   std::to_string(max_brush_sides) + " are read; split it in the editor");
        }
        if (shape.state == BrushShape::State::unbounded) {
            return bad_element(
                map_, Lump::brushes, number,
                "its planes enclose no bounded space; delete it in the editor, or compile the map again");
        }
        if (shape.state == BrushShape::State::empty) {
            ++builder_.notes().brushes_empty;
            return std::nullopt;
        }
        return add_brush_polygons(placed, number, shape);
    }

    Result add_brush_polygons(std::size_t placed, std::uint32_t number, const BrushShape& shape) {
        const auto first = static_cast<std::uint32_t>(builder_.vertex_count());
        for (const dvec3& corner : shape.corners) {
            if (auto error = add_vertex(corner + placed_[placed].origin, Lump::brushes, number)) return error;
        }
        const Brush& brush = map_.brushes[number];
        for (const BrushPolygon& polygon : shape.polygons) {
            if (draws() && !is_invisible(brush, polygon.side)) continue;
            set_surface(map_.brush_sides[brush.sides.first + polygon.side].texture);
            corners_.clear();
            for (const std::uint32_t corner : polygon.corners) corners_.push_back(first + corner);
            if (auto error = builder_.add_face(corners_)) return error;
        }
        ++builder_.notes().brushes;
        return std::nullopt;
    }

    const Map& map_;
    Placement placement_;
    MapOptions options_;
    LevelBuilder builder_;
    PatchCutter cutter_;
    std::vector<std::string> extras_;  ///< of each texture
    std::vector<Placed> placed_;
    std::vector<PlacedPatch> patches_;
    std::size_t next_patch_ = 0;
    std::uint64_t work_ = 0;
    std::vector<std::uint32_t> corners_;  ///< scratch
    std::vector<Plane> planes_;           ///< scratch
};

}  // namespace

Expected<ImportedLevel> read_bsp(std::span<const std::byte> file, const Placement& placement, const ReadLimits& limits,
                                 const MapOptions& options) {
    const Expected<Map> map = read_map(file);
    if (!map) return tl::unexpected(map.error());
    const auto entities = read_entities(*map);
    if (!entities) return tl::unexpected(entities.error());
    return MapBuilder(*map, placement, limits, options).build(*entities);
}

}  // namespace surefoot::internal::quake3
