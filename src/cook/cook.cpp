#include <bit>
#include <cstring>
#include <limits>
#include <string>
#include <thread>
#include <utility>

#include <surefoot/cook.hpp>

#include "cook/findings.hpp"
#include "cook/notes.hpp"
#include "cook/tiles.hpp"
#include "cook/weld.hpp"
#include "ieee_guard.hpp"
#include "limits.hpp"
#include "mesh/edges.hpp"
#include "mesh/sections.hpp"
#include "parallel.hpp"
#include "tree/binary_tree.hpp"
#include "tree/wide_tree.hpp"

namespace surefoot {
inline namespace v0 {

using namespace internal;

namespace {

constexpr std::string_view notes_name = "notes";
constexpr std::string_view report_name = "report";

tl::unexpected<Error> refused(ErrorCode code, std::string text) {
    return tl::unexpected(Error{code, std::move(text), {}, 0});
}

Expected<void> check(const CookInput& input, const CookOptions& options) {
    const std::size_t triangles = input.indices.size() / 3;
    if (input.indices.size() % 3 != 0) {
        return refused(ErrorCode::invalid, "cooking needs three indices a triangle, but there are " +
                                               std::to_string(input.indices.size()) + " indices");
    }
    if (triangles > (std::size_t{1} << 30U) || input.vertices.size() >= (std::size_t{1} << 32U) - 3)
        return refused(ErrorCode::limit, "cooking takes at most 2^30 triangles: split the level");
    if (!input.surfaces.empty() && input.surfaces.size() != triangles) {
        return refused(ErrorCode::invalid, "there are " + std::to_string(input.surfaces.size()) + " surfaces for " +
                                               std::to_string(triangles) + " triangles: give one a triangle, or none");
    }
    for (std::size_t i = 0; i < input.vertices.size(); ++i) {
        if (!is_valid_point(input.vertices[i])) {
            return refused(
                ErrorCode::invalid,
                "vertex " + std::to_string(i) +
                    " is not finite or lies beyond 1e9 m: repair it, or bring the level nearer to its origin");
        }
    }
    for (std::size_t i = 0; i < input.indices.size(); ++i) {
        if (input.indices[i] >= input.vertices.size()) {
            return refused(ErrorCode::invalid, "triangle " + std::to_string(i / 3) + " asks for vertex " +
                                                   std::to_string(input.indices[i]) + ", but there are only " +
                                                   std::to_string(input.vertices.size()) + " vertices");
        }
    }
    if (!(options.tolerance >= 0 && options.tolerance <= 1))
        return refused(ErrorCode::invalid, "the tolerance has to be between 0 and 1 m");
    if (options.threads < 1 || options.threads > 64)
        return refused(ErrorCode::invalid, "the number of threads has to be between 1 and 64");
    return {};
}

// The nearest float that is not above, or not below. Requires: |x| <= 1e9.
float rounded_up(double x) noexcept {
    const auto near = static_cast<float>(x);
    if (static_cast<double>(near) >= x) return near;
    if (near == 0) return std::numeric_limits<float>::denorm_min();
    const auto bits = std::bit_cast<std::uint32_t>(near);
    return std::bit_cast<float>(near > 0 ? bits + 1 : bits - 1);
}
float rounded_down(double x) noexcept {
    return -rounded_up(-x);
}

std::vector<TreeItem> items_of(const Soup& soup, std::span<const std::uint16_t> tiles, int threads) {
    std::vector<TreeItem> items(soup.triangle_count());
    in_pieces(items.size(), threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const auto id = static_cast<std::uint32_t>(i);
            FloatBox box{};
            for (std::uint32_t side = 3 * id; side < 3 * id + 3; ++side) {
                const Vec& v = soup.corner(side);
                const FloatBox corner{{rounded_down(v.x), rounded_down(v.y), rounded_down(v.z)},
                                      {rounded_up(v.x), rounded_up(v.y), rounded_up(v.z)}};
                if (side == 3 * id) box = corner;
                box.include(corner);
            }
            items[i] = TreeItem::of(box, id, tiles.empty() ? std::uint16_t{0} : tiles[id]);
        }
    });
    return items;
}

Box3 bounds_of(const Soup& soup) {
    if (soup.indices.empty()) return {};
    Box3 bounds{soup.corner(0), soup.corner(0)};
    for (std::uint32_t side = 1; side < soup.indices.size(); ++side) bounds.include(soup.corner(side));
    return bounds;
}

Expected<Mesh> mesh_of(std::span<const Section> sections, std::uint64_t made_from) {
    auto begin = lay_out(sections, made_from);
    if (!begin) return tl::unexpected(begin.error());
    std::vector<std::byte> image = std::move(*begin);
    for (const Section& section : sections) {
        image.insert(image.end(), section.bytes.begin(), section.bytes.end());
        image.resize(static_cast<std::size_t>(aligned(image.size())));
    }
    return Mesh::read(image);
}

Error damaged(const Section& section) {
    return {ErrorCode::unreadable,
            "the section '" + std::string(section.name) +
                "' of this mesh is damaged: cook it again with `surefoot cook IN -o OUT.surefoot`",
            {},
            0};
}

}  // namespace

Expected<Cooked> cook(const CookInput& input, const CookOptions& options) {
    const IeeeGuard guard;
    if (auto fine = check(input, options); !fine) return tl::unexpected(std::move(fine.error()));
    CookReport report;
    report.triangles = input.indices.size() / 3;
    options.progress(0);
    Soup soup = weld(input.vertices, input.indices, options.tolerance, report);
    options.progress(0.1);
    const Tiles tiles = cut_into_tiles(soup, report);
    options.progress(0.15);

    const EdgeMatches matches = match_edges(soup.indices, soup.vertices.size());
    find_faults(soup, matches, options.most_places, report);
    options.progress(0.25);
    WideTree tree;
    const auto look_for_cracks = [&] { find_t_junctions(soup, matches, options, report); };
    const auto build = [&] {
        const std::vector<std::uint8_t> edges = edge_kinds(soup.vertices, soup.indices, matches, options.tolerance);
        options.progress(0.4);
        if (report.triangles == 0) return;
        const BinaryTree binary = build_binary_tree(items_of(soup, tiles.of, options.threads), options.threads);
        options.progress(0.7);
        tree =
            collapse(binary, {.vertices = tiles.vertices, .indices = tiles.indices, .edges = edges, .tiles = tiles.of},
                     options.threads);
    };
    // Half of the search for cracks is one thread's work, so the tree does not wait for it.
    if (options.threads > 1) {
        std::thread other([&] {
            const IeeeGuard own_guard;
            look_for_cracks();
        });
        build();
        other.join();
    } else {
        look_for_cracks();
        build();
    }
    if (tree.too_large)
        return refused(ErrorCode::limit, "a mesh holds at most 2 GB of triangles, some 80 million: split the level");
    options.progress(0.9);

    const MeshView view{.nodes = tree.nodes,
                        .leaves = tree.leaves,
                        .places = tree.places,
                        .surfaces = input.surfaces,
                        .tiles = tiles.origins,
                        .hidden = {},
                        .bounds = bounds_of(soup),
                        .vertex_count = report.vertices_kept};
    const MeshInfo info = info_of(view);
    std::vector<Section> sections = sections_of(view, info);
    const std::vector<std::byte> notes = to_bytes(input.notes);
    const std::vector<std::byte> findings = to_bytes(report);
    sections.push_back({surefoot_owner, notes_name, notes_version, options.made_from, notes});
    sections.push_back({surefoot_owner, report_name, report_version, options.made_from, findings});
    auto mesh = mesh_of(sections, options.made_from);
    if (!mesh) return tl::unexpected(std::move(mesh.error()));
    options.progress(1);
    return Cooked{std::move(*mesh), std::move(report)};
}

Expected<LevelNotes> level_notes(const Mesh& mesh) {
    const auto section = mesh.section(surefoot_owner, notes_name);
    if (!section) return LevelNotes{};
    auto notes = section->version == notes_version ? notes_from(section->bytes) : std::nullopt;
    if (!notes) return tl::unexpected(damaged(*section));
    return std::move(*notes);
}

Expected<CookReport> cook_report(const Mesh& mesh) {
    const auto section = mesh.section(surefoot_owner, report_name);
    if (!section) return CookReport{};
    auto report = section->version == report_version ? report_from(section->bytes) : std::nullopt;
    if (!report) return tl::unexpected(damaged(*section));
    return std::move(*report);
}

}  // namespace v0
}  // namespace surefoot
