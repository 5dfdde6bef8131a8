// surefoot info: what is in a level?
#include <CLI/CLI.hpp>
#include <cmath>
#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <map>
#include <utility>

#include "command.hpp"
#include "findings.hpp"
#include "level.hpp"
#include "number.hpp"
#include "query.hpp"
#include "text.hpp"

namespace surefoot::tools {
namespace {

struct InfoOptionsGiven {
    LevelOptions level;
    bool json = false;
};

struct Findings {
    std::map<std::uint32_t, std::size_t> surfaces;  ///< triangles of each
    std::size_t degenerate = 0;                     ///< triangles without area
    double area = 0;                                ///< [m^2]
};

Findings examine(const Mesh& mesh) {
    Findings findings;
    for (std::uint32_t id = 0; id < mesh.triangle_count(); ++id) {
        ++findings.surfaces[mesh.surface(id)];
        const Triangle t = mesh.triangle(id);
        // Widened floats subtract and multiply without a loss that could turn a real area into zero, except far below
        // any size that matters; a collinear triangle of such floats may still leave a residue, which counts as area.
        const double twice_area = glm::length(glm::cross(t.b - t.a, t.c - t.a));
        if (twice_area == 0) ++findings.degenerate;
        findings.area += twice_area / 2;
    }
    return findings;
}

/// Without the header, which is a few hundred.
std::size_t file_bytes(const Mesh& mesh) {
    std::size_t bytes = 0;
    for (const Section& section : mesh.sections()) bytes += section.bytes.size();
    return bytes;
}

CookReport report_of(const Level& level) {
    auto report = cook_report(level.mesh);
    if (!report) throw Failure{ExitCode::file, fmt::format("{}: {}", level.file, report.error().text)};
    return std::move(*report);
}

std::string json_of(const Level& level, const Findings& findings) {
    const Bounds bounds = level.mesh.bounds();
    std::string out =
        fmt::format(R"({{"file":{},"triangles":{},"vertices":{},"degenerate":{},"area":)", json_string(level.file),
                    level.mesh.triangle_count(), level.mesh.vertex_count(), findings.degenerate);
    append_number(out, findings.area);
    out += R"(,"bounds":{"min":)";
    append_array(out, bounds.min);
    out += R"(,"max":)";
    append_array(out, bounds.max);
    out += R"(},"surfaces":[)";
    for (const auto& [surface, count] : findings.surfaces) {
        if (out.back() != '[') out += ',';
        out += fmt::format(R"({{"surface":{},"name":{},"triangles":{}}})", surface,
                           json_string(surface_name(level, surface)), count);
    }
    out += R"(],"markers":[)";
    for (const ImportedMarker& marker : level.markers) {
        if (out.back() != '[') out += ',';
        out += fmt::format(R"({{"kind":{},"name":{},"position":)", json_string(marker.kind), json_string(marker.name));
        append_array(out, marker.position);
        out += '}';
    }
    const ImportNotes& notes = level.notes;
    out += fmt::format(R"(],"patches":{},"brushes":{},"brushes_empty":{},"nonsolid_skipped":{})", notes.patches,
                       notes.brushes, notes.brushes_empty, notes.nonsolid_skipped);
    out += R"(,"import_seconds":)";
    append_number(out, level.import_seconds);
    out += R"(,"build_seconds":)";
    append_number(out, level.build_seconds);
    out += R"(,"open_seconds":)";
    append_number(out, level.open_seconds);
    out += fmt::format(R"(,"bytes":{},"sections":[)", file_bytes(level.mesh));
    for (const Section& section : level.mesh.sections()) {
        if (out.back() != '[') out += ',';
        out += fmt::format(R"({{"owner":{},"name":{},"version":{},"made_from":"{:016x}","bytes":{}}})",
                           json_string(std::string(section.owner)), json_string(std::string(section.name)),
                           section.version, section.made_from, section.bytes.size());
    }
    out += R"(],"report":)" + findings_json(report_of(level));
    return out + "}\n";
}

std::string text_of(const Level& level, const Findings& findings) {
    const Bounds bounds = level.mesh.bounds();
    const dvec3 size = bounds.max - bounds.min;
    std::string out = fmt::format("{}\n", level.file);
    out += fmt::format("  triangles   {}, of which {} without area\n", grouped(level.mesh.triangle_count()),
                       grouped(findings.degenerate));
    out += fmt::format("  vertices    {}\n", grouped(level.mesh.vertex_count()));
    out += fmt::format("  from        {} m\n", short_vector(bounds.min));
    out += fmt::format("  to          {} m\n", short_vector(bounds.max));
    out += fmt::format("  size        {} x {} x {} m, {} m2 of surface\n", short_number(size.x), short_number(size.y),
                       short_number(size.z), short_number(findings.area));
    out += fmt::format("  time        {}\n", level.how_long());
    if (const std::size_t bytes = file_bytes(level.mesh); bytes > 0) {
        out += fmt::format("  file        {} bytes, {:.1f} a triangle\n", grouped(bytes),
                           static_cast<double>(bytes) / static_cast<double>(level.mesh.triangle_count()));
    }
    constexpr std::size_t most_places = 3;
    out += findings_text(report_of(level), most_places);
    const ImportNotes& notes = level.notes;
    if (notes.polygons_split > 0)
        out += fmt::format("  polygons    {} cut into triangles\n", grouped(notes.polygons_split));
    if (const std::uint64_t skipped = notes.points_skipped + notes.lines_skipped + notes.curves_skipped; skipped > 0)
        out += fmt::format("  left out    {} points, lines and curves: they are no triangles\n", grouped(skipped));
    if (notes.patches > 0) out += fmt::format("  curves      {} cut into triangles\n", grouped(notes.patches));
    if (notes.brushes + notes.brushes_empty > 0)
        out += fmt::format("  brushes     {} made into triangles, {} without space left out\n", grouped(notes.brushes),
                           grouped(notes.brushes_empty));
    if (notes.nonsolid_skipped > 0)
        out +=
            fmt::format("  nonsolid    {} surfaces left out: they stop no player\n", grouped(notes.nonsolid_skipped));
    Table surfaces({"surface", "triangles"});
    for (const auto& [surface, count] : findings.surfaces) surfaces.add({surface_text(level, surface), grouped(count)});
    if (!findings.surfaces.empty()) out += "\n" + surfaces.text();
    if (level.open_seconds > 0) {
        Table sections({"section", "version", "bytes"});
        for (const Section& section : level.mesh.sections()) {
            sections.add({fmt::format("{}/{}", section.owner, section.name), std::to_string(section.version),
                          grouped(section.bytes.size())});
        }
        out += "\n" + sections.text();
    }
    if (level.markers.empty()) return out;
    Table markers({"marker", "name", "at [m]"});
    for (const ImportedMarker& marker : level.markers)
        markers.add({marker.kind, marker.name, short_vector(marker.position)});
    return out + "\n" + markers.text();
}

ExitCode run_info(const InfoOptionsGiven& given) {
    const Level level = load_level(given.level);
    const Findings findings = examine(level.mesh);
    write_out(given.json ? json_of(level, findings) : text_of(level, findings));
    return ExitCode::ok;
}

}  // namespace

void add_info(CLI::App& program, Run& run) {
    auto* command = program.add_subcommand("info", "What is in a level?");
    const auto given = std::make_shared<InfoOptionsGiven>();
    given->level.add_to(*command);
    command->add_flag("--json", given->json, "Print one line of JSON");
    command->footer(
        help_footer("  surefoot info castle.glb\n"
                    "  surefoot info castle.obj --json\n"
                    "\nExit codes: 0 done, 2 wrong usage, 3 the level cannot be read."));
    command->callback([given, &run] { run = [given] { return run_info(*given); }; });
}

}  // namespace surefoot::tools
