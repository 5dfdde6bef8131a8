#include "findings.hpp"

#include <fmt/format.h>

#include "number.hpp"
#include "text.hpp"

namespace surefoot::tools {
namespace {

struct Kind {
    const char* name;   // in JSON
    const char* words;  // for people
    const Finding CookReport::*finding;
};

constexpr Kind kinds[] = {
    {"degenerate", "triangles without area", &CookReport::degenerate},
    {"open_edges", "open edges", &CookReport::open_edges},
    {"non_manifold_edges", "edges of more than two triangles", &CookReport::non_manifold_edges},
    {"flipped_edges", "edges between triangles that face opposite ways", &CookReport::flipped_edges},
    {"t_junctions", "corners on an open edge of another triangle", &CookReport::t_junctions},
};

}  // namespace

std::string findings_text(const CookReport& report, std::size_t most_places) {
    std::string out =
        fmt::format("  welded      {} vertices to {}", grouped(report.vertices_given), grouped(report.vertices_kept));
    if (report.vertices_unused > 0) out += fmt::format(", {} of them of no triangle", grouped(report.vertices_unused));
    out += '\n';
    if (report.vertices_moved > 0)
        out += fmt::format("  moved       {} vertices, by at most {} m\n", grouped(report.vertices_moved),
                           short_number(report.largest_move));
    if (report.tiles > 1) out += fmt::format("  tiles       {} of 1024 m\n", grouped(report.tiles));
    bool odd = false;
    for (const Kind& kind : kinds) {
        const Finding& finding = report.*kind.finding;
        if (finding.count == 0) continue;
        out += fmt::format("{}{} {}\n", odd ? "              " : "  found       ", grouped(finding.count), kind.words);
        odd = true;
        for (std::size_t i = 0; i < finding.places.size() && i < most_places; ++i) {
            out += fmt::format("                triangle {} at {}\n", finding.places[i].triangle,
                               short_vector(finding.places[i].point));
        }
        if (most_places > 0 && finding.count > most_places) out += "                ...\n";
    }
    if (!odd) out += "  found       nothing odd\n";
    if (report.edges_unsearched > 0)
        out +=
            fmt::format("  unsearched  {} open edges, too long or in too dense a place to look for corners on them\n",
                        grouped(report.edges_unsearched));
    return out;
}

std::string findings_json(const CookReport& report) {
    std::string out = fmt::format(
        R"({{"triangles":{},"vertices_given":{},"vertices_kept":{},"vertices_unused":{},"vertices_moved":{},"tiles":{},"edges_unsearched":{},"largest_move":)",
        report.triangles, report.vertices_given, report.vertices_kept, report.vertices_unused, report.vertices_moved,
        report.tiles, report.edges_unsearched);
    append_number(out, report.largest_move);
    for (const Kind& kind : kinds) {
        const Finding& finding = report.*kind.finding;
        out += fmt::format(R"(,"{}":{{"count":{},"places":[)", kind.name, finding.count);
        for (const Finding::Place& place : finding.places) {
            if (out.back() != '[') out += ',';
            out += fmt::format(R"({{"triangle":{},"point":)", place.triangle);
            append_array(out, place.point);
            out += '}';
        }
        out += "]}";
    }
    return out + "}";
}

}  // namespace surefoot::tools
