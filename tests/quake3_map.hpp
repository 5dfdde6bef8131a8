/// Writes maps of Quake III (IBSP 46) for the tests that read them: whole ones, and ones that no compiler would make.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <surefoot/math.hpp>

namespace surefoot::test {

inline constexpr std::uint32_t solid = 0x1;
inline constexpr std::uint32_t water = 0x20;
inline constexpr std::uint32_t player_clip = 0x10000;
inline constexpr std::uint32_t slick = 0x2;
inline constexpr std::uint32_t nodraw = 0x80;

class MapWriter {
public:
    static constexpr std::size_t header_size = 144;

    std::string entities = "{\n\"classname\" \"worldspawn\"\n}\n";

    MapWriter() { begin_model(); }

    /// What is added from now on belongs to the next model; model 0 is the world.
    void begin_model(const vec3& min = vec3(0), const vec3& max = vec3(0)) {
        models_.push_back({.min = min, .max = max, .first_face = face_count_, .first_brush = brush_count_});
    }

    std::uint32_t texture(std::string_view name, std::uint32_t surface_flags, std::uint32_t content_flags) {
        std::string padded(name);
        padded.resize(64, '\0');
        lumps_[1] += padded;
        put(1, {surface_flags, content_flags});
        return static_cast<std::uint32_t>(lumps_[1].size() / 72 - 1);
    }

    /// Vertices clockwise when seen from the front, as the game has them.
    void polygon(std::uint32_t texture, const std::vector<vec3>& vertices, std::vector<std::uint32_t> corners) {
        face(texture, 1, vertices, corners, 0, 0);
    }

    void mesh(std::uint32_t texture, const std::vector<vec3>& vertices, std::vector<std::uint32_t> corners) {
        face(texture, 3, vertices, corners, 0, 0);
    }

    void patch(std::uint32_t texture, std::uint32_t width, std::uint32_t height, const std::vector<vec3>& points) {
        face(texture, 2, points, {}, width, height);
    }

    void flare() { face(0xffffffffu, 4, {}, {}, 0, 0); }

    struct Side {
        vec3 normal;
        float distance;
        std::uint32_t texture;
    };

    void brush(std::uint32_t texture, const std::vector<Side>& sides) {
        put(8, {count(9, 8), static_cast<std::uint32_t>(sides.size()), texture});
        for (const Side& side : sides) {
            put(9, {count(2, 16), side.texture});
            put_vector(2, side.normal);
            put(2, {std::bit_cast<std::uint32_t>(side.distance)});
        }
        ++brush_count_;
    }

    void box(std::uint32_t texture, const vec3& min, const vec3& max) { brush(texture, box_sides(texture, min, max)); }

    static std::vector<Side> box_sides(std::uint32_t texture, const vec3& min, const vec3& max) {
        return {{{-1, 0, 0}, -min.x, texture}, {{1, 0, 0}, max.x, texture},   {{0, -1, 0}, -min.y, texture},
                {{0, 1, 0}, max.y, texture},   {{0, 0, -1}, -min.z, texture}, {{0, 0, 1}, max.z, texture}};
    }

    /// A face whose fields are whatever is said, its runs included.
    void raw_face(const std::array<std::uint32_t, 7>& head, std::uint32_t width, std::uint32_t height) {
        for (const std::uint32_t number : head) put(13, {number});
        for (int i = 0; i < 17; ++i) put(13, {0});
        put(13, {width, height});
        ++face_count_;
    }

    [[nodiscard]] std::string bytes() const {
        std::array<std::string, 17> lumps = lumps_;
        lumps[0] = entities + '\0';
        for (std::size_t i = 0; i < models_.size(); ++i) {
            const Model& model = models_[i];
            const bool last = i + 1 == models_.size();
            for (const vec3& v : {model.min, model.max}) append(lumps[7], v);
            append(lumps[7], model.first_face);
            append(lumps[7], (last ? face_count_ : models_[i + 1].first_face) - model.first_face);
            append(lumps[7], model.first_brush);
            append(lumps[7], (last ? brush_count_ : models_[i + 1].first_brush) - model.first_brush);
        }
        std::string file = "IBSP";
        append(file, 46u);
        std::size_t place = header_size;
        for (const std::string& lump : lumps) {
            append(file, static_cast<std::uint32_t>(place));
            append(file, static_cast<std::uint32_t>(lump.size()));
            place += lump.size();
        }
        for (const std::string& lump : lumps) file += lump;
        return file;
    }

    static void append(std::string& bytes, std::uint32_t number) {
        for (int i = 0; i < 4; ++i) bytes += static_cast<char>(number >> 8 * i & 0xff);
    }
    static void append(std::string& bytes, const vec3& v) {
        for (const float x : {v.x, v.y, v.z}) append(bytes, std::bit_cast<std::uint32_t>(x));
    }

private:
    struct Model {
        vec3 min{0, 0, 0};
        vec3 max{0, 0, 0};
        std::uint32_t first_face = 0;
        std::uint32_t first_brush = 0;
    };

    void face(std::uint32_t texture, std::uint32_t type, const std::vector<vec3>& vertices,
              const std::vector<std::uint32_t>& corners, std::uint32_t width, std::uint32_t height) {
        raw_face({texture, 0xffffffffu, type, count(10, 44), static_cast<std::uint32_t>(vertices.size()), count(11, 4),
                  static_cast<std::uint32_t>(corners.size())},
                 width, height);
        for (const vec3& v : vertices) {
            put_vector(10, v);
            for (int i = 0; i < 8; ++i) put(10, {0});
        }
        for (const std::uint32_t corner : corners) put(11, {corner});
    }

    void put(std::size_t lump, std::initializer_list<std::uint32_t> numbers) {
        for (const std::uint32_t number : numbers) append(lumps_[lump], number);
    }
    void put_vector(std::size_t lump, const vec3& v) { append(lumps_[lump], v); }

    [[nodiscard]] std::uint32_t count(std::size_t lump, std::size_t size) const {
        return static_cast<std::uint32_t>(lumps_[lump].size() / size);
    }

    std::array<std::string, 17> lumps_;
    std::vector<Model> models_;
    std::uint32_t face_count_ = 0;
    std::uint32_t brush_count_ = 0;
};

/// A little of everything, for tests that break it and for the seeds of the fuzzer.
inline MapWriter sample_map() {
    MapWriter map;
    map.entities =
        "{ \"classname\" \"worldspawn\" \"gravity\" \"800\" }\n"
        "{ \"classname\" \"info_player_deathmatch\" \"origin\" \"0 0 24\" \"angle\" \"90\" }\n"
        "{ \"classname\" \"weapon_shotgun\" \"origin\" \"64 -128 16\" }\n"
        "{ \"classname\" \"trigger_push\" \"model\" \"*2\" \"target\" \"up\" }\n"
        "{ \"classname\" \"target_position\" \"targetname\" \"up\" \"origin\" \"0 256 264\" }\n"
        "{ \"classname\" \"func_door\" \"model\" \"*1\" \"angle\" \"-1\" } // a comment\n";
    const std::uint32_t stone = map.texture("textures/test/stone", 0, solid);
    const std::uint32_t ice = map.texture("textures/test/ice", slick, solid);
    const std::uint32_t clip = map.texture("textures/common/clip", nodraw, player_clip);
    const std::uint32_t pool = map.texture("textures/test/water", 0, water);
    const std::uint32_t caulk = map.texture("textures/common/caulk", nodraw, solid);
    map.polygon(stone, {{-256, -256, 0}, {-256, 256, 0}, {256, 256, 0}, {256, -256, 0}}, {0, 1, 2, 0, 2, 3});
    map.polygon(pool, {{-64, -64, 8}, {-64, 64, 8}, {64, 64, 8}, {64, -64, 8}}, {0, 1, 2, 0, 2, 3});
    map.mesh(ice, {{0, 0, 32}, {0, 64, 32}, {64, 0, 64}}, {0, 1, 2});
    map.flare();
    map.patch(stone, 3, 3,
              {{0, 0, 64},
               {64, 0, 128},
               {128, 0, 64},
               {0, 64, 64},
               {64, 64, 160},
               {128, 64, 64},
               {0, 128, 64},
               {64, 128, 128},
               {128, 128, 64}});
    map.patch(ice, 5, 3,
              {{128, 128, 64},
               {64, 128, 128},
               {0, 128, 64},
               {-64, 128, 0},
               {-128, 128, 64},
               {128, 192, 64},
               {64, 192, 64},
               {0, 192, 64},
               {-64, 192, 64},
               {-128, 192, 64},
               {128, 256, 64},
               {64, 256, 64},
               {0, 256, 64},
               {-64, 256, 64},
               {-128, 256, 64}});
    map.box(clip, {100, 100, 0}, {132, 164, 96});
    map.box(pool, {-64, -64, -64}, {64, 64, 8});
    map.box(caulk, {-300, -300, -16}, {300, 300, -8});
    map.begin_model({-32, -256, 0}, {32, -240, 96});
    map.polygon(stone, {{-32, -256, 0}, {-32, -256, 96}, {32, -256, 96}, {32, -256, 0}}, {0, 1, 2, 0, 2, 3});
    map.box(stone, {-32, -256, 0}, {32, -240, 96});
    map.begin_model({-32, -32, 0}, {32, 32, 16});
    map.box(caulk, {-32, -32, 0}, {32, 32, 16});
    return map;
}

}  // namespace surefoot::test
