#include "cook/notes.hpp"

#include "file/stream.hpp"

namespace surefoot::internal {
namespace {

void put(ByteWriter& out, const dvec3& v) {
    out.put(v.x);
    out.put(v.y);
    out.put(v.z);
}

dvec3 take_vector(ByteReader& in) {
    dvec3 v;
    v.x = in.take<double>();
    v.y = in.take<double>();
    v.z = in.take<double>();
    return v;
}

void put(ByteWriter& out, const std::vector<std::string>& texts) {
    out.put(static_cast<std::uint32_t>(texts.size()));
    for (const std::string& text : texts) out.put(text);
}

std::vector<std::string> take_texts(ByteReader& in) {
    std::vector<std::string> texts(in.take_count(4));
    for (std::string& text : texts) text = in.take_text();
    return texts;
}

void put(ByteWriter& out, const Finding& finding) {
    out.put(finding.count);
    out.put(static_cast<std::uint32_t>(finding.places.size()));
    for (const Finding::Place& place : finding.places) {
        out.put(place.triangle);
        put(out, place.point);
    }
}

Finding take_finding(ByteReader& in) {
    Finding finding;
    finding.count = in.take<std::uint64_t>();
    finding.places.resize(in.take_count(4 + 3 * 8));
    for (Finding::Place& place : finding.places) {
        place.triangle = in.take<std::uint32_t>();
        place.point = take_vector(in);
    }
    return finding;
}

}  // namespace

std::vector<std::byte> to_bytes(const LevelNotes& notes) {
    ByteWriter out;
    put(out, notes.surface_names);
    put(out, notes.surface_extras);
    out.put(static_cast<std::uint32_t>(notes.parts.size()));
    for (const Part& part : notes.parts) {
        out.put(part.name);
        out.put(part.first_triangle);
        out.put(part.triangle_count);
    }
    out.put(static_cast<std::uint32_t>(notes.markers.size()));
    for (const Marker& marker : notes.markers) {
        out.put(marker.name);
        out.put(marker.kind);
        out.put(marker.extras);
        put(out, marker.position);
        out.put(marker.orientation.w);
        put(out, {marker.orientation.x, marker.orientation.y, marker.orientation.z});
        put(out, marker.scale);
    }
    return out.take();
}

std::optional<LevelNotes> notes_from(std::span<const std::byte> bytes) {
    ByteReader in(bytes);
    LevelNotes notes;
    notes.surface_names = take_texts(in);
    notes.surface_extras = take_texts(in);
    notes.parts.resize(in.take_count(std::size_t{3} * 4));
    for (Part& part : notes.parts) {
        part.name = in.take_text();
        part.first_triangle = in.take<std::uint32_t>();
        part.triangle_count = in.take<std::uint32_t>();
    }
    notes.markers.resize(in.take_count(3 * 4 + 10 * 8));
    for (Marker& marker : notes.markers) {
        marker.name = in.take_text();
        marker.kind = in.take_text();
        marker.extras = in.take_text();
        marker.position = take_vector(in);
        marker.orientation.w = in.take<double>();
        const dvec3 axis = take_vector(in);
        marker.orientation = {marker.orientation.w, axis.x, axis.y, axis.z};
        marker.scale = take_vector(in);
    }
    if (!in.good()) return std::nullopt;
    return notes;
}

std::vector<std::byte> to_bytes(const CookReport& report) {
    ByteWriter out;
    for (const std::uint64_t count :
         {report.triangles, report.vertices_given, report.vertices_kept, report.vertices_unused, report.vertices_moved,
          report.tiles, report.edges_unsearched})
        out.put(count);
    out.put(report.largest_move);
    for (const Finding* finding : {&report.degenerate, &report.open_edges, &report.non_manifold_edges,
                                   &report.flipped_edges, &report.t_junctions})
        put(out, *finding);
    return out.take();
}

std::optional<CookReport> report_from(std::span<const std::byte> bytes) {
    ByteReader in(bytes);
    CookReport report;
    for (std::uint64_t* count :
         {&report.triangles, &report.vertices_given, &report.vertices_kept, &report.vertices_unused,
          &report.vertices_moved, &report.tiles, &report.edges_unsearched})
        *count = in.take<std::uint64_t>();
    report.largest_move = in.take<double>();
    for (Finding* finding : {&report.degenerate, &report.open_edges, &report.non_manifold_edges, &report.flipped_edges,
                             &report.t_junctions})
        *finding = take_finding(in);
    if (!in.good()) return std::nullopt;
    return report;
}

}  // namespace surefoot::internal
