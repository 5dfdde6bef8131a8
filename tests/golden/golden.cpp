// Asks the library thousands of seeded questions and prints one hash for each concept. The hashes must be those in
// golden.txt whatever compiled the library, at whatever optimisation, on whatever machine, and whatever the caller's
// own flags are.
//
//     golden tests/golden/golden.txt             compares
//     golden tests/golden/golden.txt --update    writes the file anew: only when answers are meant to change

#include <cstdio>
#include <fstream>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "characters.hpp"
#include "crowds.hpp"
#include "hash.hpp"
#include "queries.hpp"

namespace golden {
namespace {

constexpr std::array<std::string_view, 6> shape_names{"sphere", "ellipsoid", "capsule", "box", "cylinder", "cone"};
constexpr int queries_per_concept = 2000;

struct Result {
    std::uint64_t hash;
    int hits;
};
using Results = std::map<std::string, Result>;

void record(Results& results, std::string name, const Hash& hash) {
    results.emplace(std::move(name), Result{hash.value(), hash.hits()});
}

void sweep_each_shape(Results& results) {
    for (std::size_t kind = 0; kind < shape_names.size(); ++kind) {
        Queries queries(100 + kind);
        Hash hash;
        for (int i = 0; i < queries_per_concept; ++i) {
            queries.next_family();
            const surefoot::Volume volume = queries.volume(kind);
            const surefoot::Motion motion = queries.motion();
            const surefoot::Triangle triangle = queries.triangle();
            hash << surefoot::sweep(volume, motion, triangle, {.one_sided = queries.coin()});
        }
        record(results, "sweep." + std::string(shape_names[kind]), hash);
    }
}

// Coordinates below the smallest normal double: a caller linked with -ffast-math has set the processor to call them 0.
void sweep_denormal(Results& results) {
    Queries queries(150);
    Hash hash;
    for (int i = 0; i < queries_per_concept; ++i) {
        const auto minute = [&queries] {
            std::uint64_t word = queries.random().bits();
            word &= 0x800fffffffffffffu;
            return std::bit_cast<double>(word);
        };
        const double sign = queries.coin() ? 1.0 : -1.0;
        const surefoot::Volume volume = queries.volume(static_cast<std::size_t>(i) % shape_names.size());
        const surefoot::Triangle triangle{{-8, minute(), -8}, {minute(), minute(), 8}, {8, minute(), minute()}};
        const surefoot::Motion motion{{minute(), 16 * sign, minute()}, {minute(), minute(), minute()}};
        hash << surefoot::sweep(volume, motion, triangle);
        hash << surefoot::sweep(volume, {motion.to, motion.from}, triangle);
        hash << surefoot::ray(motion, triangle);
    }
    record(results, "sweep.denormal", hash);
}

void ray(Results& results) {
    Queries queries(200);
    Hash hash;
    for (int i = 0; i < 2 * queries_per_concept; ++i) {
        queries.next_family();
        const surefoot::Motion motion = queries.motion();
        const surefoot::Triangle triangle = queries.triangle();
        hash << surefoot::ray(motion, triangle, {.one_sided = queries.coin()});
    }
    record(results, "ray", hash);
}

void overlap_each_shape(Results& results) {
    for (std::size_t kind = 0; kind < shape_names.size(); ++kind) {
        Queries queries(300 + kind);
        Hash hash;
        for (int i = 0; i < queries_per_concept; ++i) {
            queries.next_family();
            const surefoot::Volume volume = queries.volume(kind);
            const surefoot::dvec3 position = queries.position();
            const surefoot::Triangle triangle = queries.triangle();
            hash << surefoot::overlap(volume, position, triangle, {.one_sided = queries.coin()});
        }
        record(results, "overlap." + std::string(shape_names[kind]), hash);
    }
}

void march(Results& results) {
    Queries queries(400);
    Hash hash;
    for (int i = 0; i < queries_per_concept / 4; ++i) {
        queries.next_family();
        const surefoot::Volume volume = queries.volume(static_cast<std::size_t>(i) % shape_names.size());
        const surefoot::Motion motion = queries.motion();
        const surefoot::JumpArc arc{.from = motion.from, .velocity = motion.to, .duration = 1.25};
        const surefoot::Triangle triangle = queries.triangle();
        // The arc is computed inside the library; a lambda with arithmetic of its own would be the caller's.
        hash << surefoot::march(volume, arc, triangle, {.steps = 16, .guarded = queries.coin()});
    }
    record(results, "march", hash);
}

// All 36 pairs of shapes in turn.
void pair(Results& results) {
    Queries queries(450);
    Hash swept;
    Hash overlapped;
    for (std::size_t i = 0; i < 36 * 50; ++i) {
        queries.next_family();
        const surefoot::Volume a = queries.volume(i % 6);
        const surefoot::Volume b = queries.volume(i / 6 % 6);
        const surefoot::Motion motion_a = queries.motion();
        const surefoot::Motion motion_b = queries.motion();
        swept << surefoot::pair_sweep(a, motion_a, b, motion_b) << surefoot::pair_sweep(a, motion_a, b, motion_b.from);
        overlapped << surefoot::pair_overlap(a, motion_a.from, b, motion_b.from);
    }
    record(results, "pair.sweep", swept);
    record(results, "pair.overlap", overlapped);
}

void mesh(Results& results) {
    Queries queries(500);
    std::vector<surefoot::vec3> vertices;
    std::vector<std::uint32_t> indices;
    for (std::uint32_t i = 0; i < 300; ++i) {
        const auto coordinate = [&queries] { return static_cast<float>(queries.random().between(-64, 64)) * 0.125f; };
        const float x = coordinate();
        const float y = coordinate();
        vertices.emplace_back(x, y, coordinate());
        const auto any = [&queries, i] { return static_cast<std::uint32_t>(queries.random().between(0, i)); };
        const std::uint32_t a = any();
        const std::uint32_t b = any();
        indices.insert(indices.end(), {a, b, any()});
    }
    const auto built = surefoot::Mesh::build({.vertices = vertices, .indices = indices});
    Hash hash;
    for (int i = 0; built && i < queries_per_concept / 2; ++i) {
        queries.next_family();
        const surefoot::Volume volume = queries.volume(static_cast<std::size_t>(i) % shape_names.size());
        const surefoot::Motion motion = queries.motion();
        hash << built->sweep(volume, motion) << built->ray(motion);
        std::array<surefoot::Overlap, 8> found;
        const std::size_t count = built->overlap(volume, motion.from, found);
        hash << std::uint64_t{count};
        for (std::size_t k = 0; k < count && k < found.size(); ++k) hash << found[k];
    }
    record(results, "mesh", hash);
}

// Standing, moving and turning bodies. Their poses are drawn, never computed here.
void world(Results& results) {
    Queries queries(700);
    std::vector<surefoot::vec3> vertices;
    std::vector<std::uint32_t> indices;
    for (std::uint32_t i = 0; i < 60; ++i) {
        vertices.emplace_back(queries.position());
        indices.push_back(i);
    }
    const auto built = surefoot::Mesh::build({.vertices = vertices, .indices = indices});
    surefoot::World world;
    std::vector<surefoot::BodyHandle> bodies;
    for (std::uint32_t i = 0; built && i < 12; ++i) {
        const surefoot::Pose pose =
            i < 4 ? surefoot::Pose{} : surefoot::Pose{queries.position(), queries.orientation()};
        const auto added = world.add(*built, {.pose = pose, .body = 3 * i});
        if (added) bodies.push_back(*added);
    }
    Hash hash;
    for (std::size_t i = 0; !bodies.empty() && i < queries_per_concept / 4; ++i) {
        const surefoot::Volume volume = queries.volume(i % shape_names.size());
        const surefoot::Motion motion = queries.motion();
        const surefoot::WorldQuery query{.one_sided = queries.coin(), .turn_gap = 0.0625};
        hash << world.sweep(volume, motion, query) << world.ray(motion, query);
        std::array<surefoot::Overlap, 8> found;
        const std::size_t count = world.overlap(volume, motion.from, found, query);
        hash << std::uint64_t{count};
        for (std::size_t k = 0; k < count && k < found.size(); ++k) hash << found[k];
        if (i % 16 == 0) world.begin_tick();
        const surefoot::Pose next{queries.position(), queries.orientation()};
        hash << std::uint64_t{world.move(bodies[4 + i % (bodies.size() - 4)], next)};
        hash << world.carried(bodies[i % bodies.size()], motion.from);
    }
    record(results, "world", hash);
}

// Everything that a source answers, of one question.
template <typename Source>
void ask_source(Hash& hash, const Source& source, const surefoot::Volume& volume, const surefoot::Motion& motion) {
    hash << source.sweep(volume, motion) << source.ray(motion);
    std::array<surefoot::Overlap, 8> found;
    const std::size_t count = source.overlap(volume, motion.from, found);
    hash << std::uint64_t{count};
    for (std::size_t k = 0; k < count && k < found.size(); ++k) hash << found[k];
}

void height_field(Results& results) {
    Queries queries(550);
    constexpr std::uint32_t side = 24;
    std::vector<std::uint16_t> levels;
    std::vector<std::uint8_t> quads;
    for (std::uint32_t i = 0; i < side * side; ++i) {
        levels.push_back(static_cast<std::uint16_t>(queries.random().between(0, 400)));
        if (i < (side - 1) * (side - 1)) quads.push_back(static_cast<std::uint8_t>(queries.random().between(0, 3)));
    }
    // Steps that no double holds: the rounding of corners is part of the answers.
    const auto built = surefoot::HeightField::build({.columns = side,
                                                     .rows = side,
                                                     .levels = levels,
                                                     .cell_x = 0.37,
                                                     .cell_z = 0.41,
                                                     .height_scale = 0.011,
                                                     .origin = {-4.1, -2.3, -4.9},
                                                     .quads = quads});
    Hash hash;
    for (int i = 0; built && i < queries_per_concept / 2; ++i) {
        const surefoot::Volume volume = queries.volume(static_cast<std::size_t>(i) % shape_names.size());
        ask_source(hash, *built, volume, queries.motion());
    }
    record(results, "height_field", hash);
}

void voxels(Results& results) {
    Queries queries(560);
    constexpr std::int32_t side = 12;
    static constexpr surefoot::BlockBox stairs[] = {{{0, 0, 0}, {1, 0.5F, 1}}, {{0.5F, 0.5F, 0}, {1, 1, 1}}};
    std::vector<std::uint8_t> grid;
    for (std::int32_t i = 0; i < side * side * side; ++i) {
        grid.push_back(static_cast<std::uint8_t>(queries.random().between(0, 9)));
    }
    const auto block = [&grid](std::int32_t x, std::int32_t y, std::int32_t z) {
        const std::uint8_t kind = grid[static_cast<std::size_t>((y * side + z) * side + x)];
        if (kind == 0) return surefoot::Block::of(stairs, 3);
        return kind < 3 ? surefoot::Block::full(kind) : surefoot::Block::empty();
    };
    const auto made = surefoot::Voxels::over(
        block,
        {.cells = {side, side, side}, .size = {0.7, 0.9, 0.7}, .origin = {-4.1, -5.3, -4.3}, .boxes_per_block = 2});
    Hash hash;
    Hash moved;
    for (int i = 0; made && i < queries_per_concept / 2; ++i) {
        const surefoot::Volume volume = queries.volume(static_cast<std::size_t>(i) % shape_names.size());
        const surefoot::Motion motion = queries.motion();
        ask_source(hash, *made, volume, motion);
        const surefoot::Box box{.half_extents = {queries.radius(), queries.radius(), queries.radius()}};
        const surefoot::BoxMove move = surefoot::move_axis_by_axis(*made, box, motion.from, motion.to);
        moved << move.position;
        for (const surefoot::AxisStop& stop : {move.x, move.y, move.z}) {
            moved << std::uint64_t{stop.blocked} << std::uint64_t{stop.triangle} << std::uint64_t{stop.surface};
        }
    }
    record(results, "voxels", hash);
    record(results, "voxels.move", moved);
}

void character(Results& results) {
    for (std::size_t kind = 0; kind < shape_names.size(); ++kind) {
        Hash hash;
        walk_about(hash, kind);
        record(results, "step." + std::string(shape_names[kind]), hash);
    }
}

void crowds(Results& results) {
    Hash hard;
    press_together(hard, surefoot::Firmness::hard);
    record(results, "crowd.hard", hard);
    Hash soft;
    press_together(soft, surefoot::Firmness::soft);
    record(results, "crowd.soft", soft);
}

void hitboxes(Results& results) {
    Hash hash;
    shoot_at_parts(hash);
    record(results, "hitboxes", hash);
}

Results ask_everything() {
    Results results;
    sweep_each_shape(results);
    sweep_denormal(results);
    ray(results);
    overlap_each_shape(results);
    march(results);
    pair(results);
    mesh(results);
    world(results);
    height_field(results);
    voxels(results);
    character(results);
    crowds(results);
    hitboxes(results);
    return results;
}

std::map<std::string, std::string> read(const char* path) {
    std::map<std::string, std::string> expected;
    std::ifstream file(path);
    for (std::string name, hash; file >> name >> hash;) expected[name] = hash;
    return expected;
}

int run(const char* path, bool update) {
    const Results results = ask_everything();
    const auto expected = read(path);
    std::ofstream file;
    if (update) file.open(path);
    int wrong = results.size() == expected.size() ? 0 : 1;
    for (const auto& [name, result] : results) {
        char hash[17];
        std::snprintf(hash, sizeof hash, "%016llx", static_cast<unsigned long long>(result.hash));
        const auto found = expected.find(name);
        const bool same = found != expected.end() && found->second == hash;
        const char* verdict = same ? "as expected" : update ? "changed" : "DIFFERS";
        std::printf("%-18s %s  %5d hits  %s\n", name.c_str(), hash, result.hits, verdict);
        if (!same) ++wrong;
        if (update) file << name << ' ' << hash << '\n';
    }
    if (update) return file.flush() ? 0 : (std::fprintf(stderr, "cannot write %s\n", path), 1);
    if (wrong != 0) {
        std::fprintf(stderr,
                     "The answers are not the bits in %s. If they are meant to change, write it anew with --update and "
                     "say why in the CHANGELOG; if only this build differs from others, it is a defect.\n",
                     path);
    }
    return wrong == 0 ? 0 : 1;
}

}  // namespace
}  // namespace golden

int main(int argc, char** argv) {
    if (argc < 2) {
        std::fprintf(stderr, "usage: golden FILE [--update]\n");
        return 2;
    }
    return golden::run(argv[1], argc > 2 && std::string_view(argv[2]) == "--update");
}
