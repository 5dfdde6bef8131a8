// The format: Kekoa Proudfoot, "Unofficial Quake 3 Map Specs", 2000. A header of 17 lumps by offset and length, each an
// array of records of little-endian 32-bit integers and floats.
#include "map.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>

namespace surefoot::internal::quake3 {
namespace {

constexpr std::size_t lump_count = 17;
constexpr std::size_t header_size = 8 + 8 * lump_count;
constexpr std::uint32_t version = 46;
constexpr std::string_view compile_again = "; the file is damaged, so compile the map again or take another copy";

struct LumpForm {
    std::string_view name;
    std::string_view element;
    std::uint32_t size;  ///< of one element [bytes]
};

constexpr LumpForm form_of(Lump lump) {
    switch (lump) {
        case Lump::entities:
            return {"entities", "byte", 1};
        case Lump::textures:
            return {"textures", "texture", 72};
        case Lump::planes:
            return {"planes", "plane", 16};
        case Lump::models:
            return {"models", "model", 40};
        case Lump::brushes:
            return {"brushes", "brush", 12};
        case Lump::brush_sides:
            return {"brush sides", "side", 8};
        case Lump::vertices:
            return {"vertices", "vertex", 44};
        case Lump::mesh_vertices:
            return {"mesh vertices", "mesh vertex", 4};
        case Lump::faces:
            return {"faces", "face", 104};
    }
    return {"", "", 1};
}

std::string lump_text(Lump lump) {
    return "lump " + std::to_string(static_cast<unsigned>(lump)) + " (" + std::string(form_of(lump).name) + ")";
}

Error unreadable(std::string text, std::uint64_t byte = 0) {
    return {.code = ErrorCode::unreadable, .text = std::move(text), .file = {}, .byte = byte};
}

/// One record: numbers by their place within it.
class Record {
public:
    explicit Record(std::span<const std::byte> bytes) : bytes_(bytes) {}

    [[nodiscard]] std::uint32_t u32(std::size_t place) const {
        std::uint32_t value = 0;
        for (std::size_t i = 4; i-- > 0;) value = value << 8 | std::to_integer<std::uint32_t>(bytes_[place + i]);
        return value;
    }
    [[nodiscard]] float f32(std::size_t place) const { return std::bit_cast<float>(u32(place)); }
    [[nodiscard]] vec3 vector(std::size_t place) const { return {f32(place), f32(place + 4), f32(place + 8)}; }
    [[nodiscard]] Run run(std::size_t place) const { return {.first = u32(place), .count = u32(place + 4)}; }

    /// Up to the first zero byte.
    [[nodiscard]] std::string text(std::size_t place, std::size_t size) const {
        const auto* const begin = reinterpret_cast<const char*>(bytes_.data()) + place;
        return {begin, std::find(begin, begin + size, '\0')};
    }

private:
    std::span<const std::byte> bytes_;
};

class MapReader {
public:
    explicit MapReader(std::span<const std::byte> file) : file_(file) {}

    Expected<Map> read() {
        if (auto error = read_header()) return tl::unexpected(std::move(*error));
        read_lumps();
        for (const auto check : {&MapReader::check_planes, &MapReader::check_models, &MapReader::check_brushes,
                                 &MapReader::check_sides, &MapReader::check_faces}) {
            if (auto error = (this->*check)()) return tl::unexpected(std::move(*error));
        }
        return std::move(map_);
    }

private:
    using Result = std::optional<Error>;

    Result read_header() {
        if (file_.size() < header_size) {
            return unreadable("it ends within its header, after " + std::to_string(file_.size()) + " of " +
                                  std::to_string(header_size) + " bytes" + std::string(compile_again),
                              file_.size());
        }
        const Record header(file_);
        if (header.text(0, 4) != "IBSP") {
            return unreadable("it does not begin with IBSP, so it is no map of Quake III; convert it to .glb or .obj");
        }
        if (header.u32(4) != version) {
            Error error = unreadable("byte 4: its version is " + std::to_string(header.u32(4)) +
                                         ", and only 46 (Quake III) is read; compile the map for Quake III",
                                     4);
            error.code = ErrorCode::unsupported;
            return error;
        }
        for (std::size_t i = 0; i < lump_count; ++i)
            map_.lumps[i] = {.first = header.u32(8 + 8 * i), .size = header.u32(12 + 8 * i)};
        for (const Lump lump : {Lump::entities, Lump::textures, Lump::planes, Lump::models, Lump::brushes,
                                Lump::brush_sides, Lump::vertices, Lump::mesh_vertices, Lump::faces}) {
            if (auto error = check_extent(lump)) return error;
        }
        if (count(Lump::models) == 0) {
            return bad_byte(map_, Lump::models, 0, "there is no model, and so no world; compile the map again");
        }
        return std::nullopt;
    }

    Result check_extent(Lump lump) const {
        const Extent extent = extent_of(lump);
        const std::uint64_t place = 8 + 8 * static_cast<std::uint64_t>(lump);
        const auto refuse = [&](const std::string& what) {
            return unreadable(lump_text(lump) + ", at byte " + std::to_string(place) + " of the header: " + what +
                                  std::string(compile_again),
                              place);
        };
        if (extent.first + extent.size > file_.size()) {
            return refuse("it says that it has " + std::to_string(extent.size) + " bytes from byte " +
                          std::to_string(extent.first) + ", and the file ends at " + std::to_string(file_.size()));
        }
        if (extent.size % form_of(lump).size != 0) {
            return refuse("its length of " + std::to_string(extent.size) + " bytes is no multiple of " +
                          std::to_string(form_of(lump).size));
        }
        return std::nullopt;
    }

    [[nodiscard]] Extent extent_of(Lump lump) const { return map_.lumps[static_cast<std::size_t>(lump)]; }
    [[nodiscard]] std::size_t count(Lump lump) const { return extent_of(lump).size / form_of(lump).size; }

    template <typename T, typename Make>
    void fill(std::vector<T>& elements, Lump lump, Make make) {
        const std::size_t size = form_of(lump).size;
        const auto bytes = file_.subspan(extent_of(lump).first, extent_of(lump).size);
        elements.reserve(count(lump));
        for (std::size_t place = 0; place < bytes.size(); place += size)
            elements.push_back(make(Record(bytes.subspan(place, size))));
    }

    void read_lumps() {
        const Extent text = extent_of(Lump::entities);
        map_.entities = {reinterpret_cast<const char*>(file_.data()) + text.first, text.size};
        map_.entities = map_.entities.substr(0, map_.entities.find('\0'));
        fill(map_.textures, Lump::textures, [](const Record& r) {
            return Texture{.name = r.text(0, 64), .surface_flags = r.u32(64), .content_flags = r.u32(68)};
        });
        fill(map_.planes, Lump::planes, [](const Record& r) {
            return Plane{.normal = dvec3(r.vector(0)), .distance = static_cast<double>(r.f32(12))};
        });
        fill(map_.models, Lump::models, [](const Record& r) {
            return Model{.min = r.vector(0), .max = r.vector(12), .faces = r.run(24), .brushes = r.run(32)};
        });
        fill(map_.brushes, Lump::brushes,
             [](const Record& r) { return Brush{.sides = r.run(0), .texture = r.u32(8)}; });
        fill(map_.brush_sides, Lump::brush_sides,
             [](const Record& r) { return BrushSide{.plane = r.u32(0), .texture = r.u32(4)}; });
        fill(map_.vertices, Lump::vertices, [](const Record& r) { return r.vector(0); });
        fill(map_.mesh_vertices, Lump::mesh_vertices, [](const Record& r) { return r.u32(0); });
        fill(map_.faces, Lump::faces, [](const Record& r) {
            return Face{.texture = r.u32(0),
                        .type = static_cast<FaceType>(r.u32(8)),
                        .vertices = r.run(12),
                        .mesh_vertices = r.run(20),
                        .width = r.u32(96),
                        .height = r.u32(100)};
        });
    }

    /// What is wrong with a run, if anything, in words.
    [[nodiscard]] std::optional<std::string> wrong_run(Run run, Lump lump) const {
        if (std::uint64_t{run.first} + run.count <= count(lump)) return std::nullopt;
        return "it uses " + std::to_string(run.count) + " elements from " + std::to_string(run.first) + " on of " +
               lump_text(lump) + ", which has " + std::to_string(count(lump)) + std::string(compile_again);
    }

    [[nodiscard]] std::optional<std::string> wrong_index(std::uint32_t index, Lump lump) const {
        if (index < count(lump)) return std::nullopt;
        return "it uses element " + std::to_string(index) + " of " + lump_text(lump) + ", which has " +
               std::to_string(count(lump)) + std::string(compile_again);
    }

    Result check_planes() {
        for (std::size_t i = 0; i < map_.planes.size(); ++i) {
            const Plane& plane = map_.planes[i];
            const double length = std::sqrt(plane.normal.x * plane.normal.x + plane.normal.y * plane.normal.y +
                                            plane.normal.z * plane.normal.z);
            if (!(std::abs(length - 1) < 1e-3) || !std::isfinite(plane.distance)) {
                return bad_element(map_, Lump::planes, i,
                                   "it is no plane: its normal has the length " + std::to_string(length) +
                                       ", its distance is " + std::to_string(plane.distance) +
                                       std::string(compile_again));
            }
        }
        return std::nullopt;
    }

    Result check_models() {
        for (std::size_t i = 0; i < map_.models.size(); ++i) {
            const Model& model = map_.models[i];
            auto wrong = wrong_run(model.faces, Lump::faces);
            if (!wrong) wrong = wrong_run(model.brushes, Lump::brushes);
            if (wrong) return bad_element(map_, Lump::models, i, *wrong);
        }
        return std::nullopt;
    }

    Result check_brushes() {
        for (std::size_t i = 0; i < map_.brushes.size(); ++i) {
            auto wrong = wrong_run(map_.brushes[i].sides, Lump::brush_sides);
            if (!wrong) wrong = wrong_index(map_.brushes[i].texture, Lump::textures);
            if (wrong) return bad_element(map_, Lump::brushes, i, *wrong);
        }
        return std::nullopt;
    }

    Result check_sides() {
        for (std::size_t i = 0; i < map_.brush_sides.size(); ++i) {
            auto wrong = wrong_index(map_.brush_sides[i].plane, Lump::planes);
            if (!wrong) wrong = wrong_index(map_.brush_sides[i].texture, Lump::textures);
            if (wrong) return bad_element(map_, Lump::brush_sides, i, *wrong);
        }
        return std::nullopt;
    }

    Result check_faces() {
        for (std::size_t i = 0; i < map_.faces.size(); ++i) {
            if (map_.faces[i].type == FaceType::flare) continue;  // a light's halo: no shape, and no texture need be
            auto wrong = wrong_face(map_.faces[i]);
            if (wrong) return bad_element(map_, Lump::faces, i, *wrong);
        }
        return std::nullopt;
    }

    [[nodiscard]] std::optional<std::string> wrong_face(const Face& face) const {
        if (auto wrong = wrong_index(face.texture, Lump::textures)) return wrong;
        if (auto wrong = wrong_run(face.vertices, Lump::vertices)) return wrong;
        if (face.type == FaceType::patch) return wrong_patch(face);
        if (face.type != FaceType::polygon && face.type != FaceType::mesh) {
            return "its type is " + std::to_string(static_cast<std::uint32_t>(face.type)) +
                   ", and there are 1 (polygon), 2 (patch), 3 (mesh) and 4 (flare)" + std::string(compile_again);
        }
        if (auto wrong = wrong_run(face.mesh_vertices, Lump::mesh_vertices)) return wrong;
        if (face.mesh_vertices.count % 3 != 0) {
            return "it has " + std::to_string(face.mesh_vertices.count) + " mesh vertices, which is no multiple of 3" +
                   std::string(compile_again);
        }
        return std::nullopt;
    }

    [[nodiscard]] static std::optional<std::string> wrong_patch(const Face& face) {
        const bool odd = face.width % 2 == 1 && face.height % 2 == 1;
        const bool fits = std::uint64_t{face.width} * face.height == face.vertices.count;
        if (odd && fits && face.width >= 3 && face.height >= 3) return std::nullopt;
        return "a patch has odd numbers of control points, 3 x 3 or more, and a vertex for each; this one has " +
               std::to_string(face.width) + " x " + std::to_string(face.height) + " and " +
               std::to_string(face.vertices.count) + " vertices" + std::string(compile_again);
    }

    std::span<const std::byte> file_;
    Map map_;
};

}  // namespace

Expected<Map> read_map(std::span<const std::byte> file) {
    return MapReader(file).read();
}

Error bad_element(const Map& map, Lump lump, std::uint64_t index, std::string_view what) {
    const LumpForm form = form_of(lump);
    const std::uint64_t byte = map.lumps[static_cast<std::size_t>(lump)].first + index * form.size;
    return {.code = ErrorCode::invalid,
            .text = lump_text(lump) + ", " + std::string(form.element) + " " + std::to_string(index) + " at byte " +
                    std::to_string(byte) + ": " + std::string(what),
            .file = {},
            .byte = byte};
}

Error bad_byte(const Map& map, Lump lump, std::uint64_t place, std::string_view what) {
    const std::uint64_t byte = map.lumps[static_cast<std::size_t>(lump)].first + place;
    return {.code = ErrorCode::invalid,
            .text = lump_text(lump) + ", byte " + std::to_string(byte) + ": " + std::string(what),
            .file = {},
            .byte = byte};
}

}  // namespace surefoot::internal::quake3
