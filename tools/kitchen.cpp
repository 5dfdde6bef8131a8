#include "kitchen.hpp"

#include <algorithm>
#include <charconv>
#include <cstring>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <utility>

#include "command.hpp"
#include "parse.hpp"
#include "progress.hpp"

namespace surefoot::tools {
namespace {

/// In small letters, as the importer compares it.
std::string ending_of(const std::filesystem::path& path) {
    std::string ending = path.extension().string();
    for (char& c : ending)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return ending;
}

std::optional<std::string> bytes_of(const std::filesystem::path& path) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error)) return std::nullopt;
    std::ifstream input(path, std::ios::binary);
    std::ostringstream text;
    text << input.rdbuf();
    if (!input) return std::nullopt;
    return std::move(text).str();
}

std::uint64_t hash_text(std::string_view text, std::uint64_t seed) {
    return hash_bytes(std::as_bytes(std::span(text)), seed);
}

std::string percent_decoded(std::string_view text) {
    std::string out;
    for (std::size_t i = 0; i < text.size(); ++i) {
        unsigned code = 0;
        const bool escape =
            text[i] == '%' && i + 2 < text.size() &&
            std::from_chars(text.data() + i + 1, text.data() + i + 3, code, 16).ptr == text.data() + i + 3;
        out += escape ? static_cast<char>(code) : text[i];
        if (escape) i += 2;
    }
    return out;
}

/// The files that a .gltf keeps its numbers in; nothing if that cannot be told.
std::optional<std::vector<std::filesystem::path>> buffers_of(const std::filesystem::path& path,
                                                             const std::string& text) {
    const nlohmann::json json = nlohmann::json::parse(text, nullptr, false);
    if (!json.is_object()) return std::nullopt;
    std::vector<std::filesystem::path> files;
    const auto buffers = json.find("buffers");
    if (buffers == json.end()) return files;
    for (const nlohmann::json& buffer : *buffers) {
        if (!buffer.is_object() || !buffer.contains("uri")) continue;
        if (!buffer["uri"].is_string()) return std::nullopt;
        const auto uri = buffer["uri"].get<std::string>();
        if (!uri.starts_with("data:")) files.push_back(path.parent_path() / percent_decoded(uri));
    }
    return files;
}

/// The file in the same folder whose name comes nearest, for people who mistype.
std::string near_file(const std::filesystem::path& file) {
    const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
    std::vector<std::string> names;
    constexpr std::size_t most_names = 10000;
    std::error_code error;
    for (std::filesystem::directory_iterator entry(folder, error), end;
         !error && entry != end && names.size() < most_names; entry.increment(error))
        names.push_back(entry->path().filename().string());
    std::sort(names.begin(), names.end());
    const std::string near = nearest_word(file.filename().string(), names);
    return near.empty() ? near : (file.parent_path() / near).string();
}

ImportedLevel import_one(const std::string& file, const ImportOptions& options) {
    Expected<ImportedLevel> imported = import_level(file, options);
    if (imported) return std::move(*imported);
    throw Failure{ExitCode::file, with_near_file(imported.error(), file)};
}

/// Adds a level behind another one.
void append(ImportedLevel& all, ImportedLevel&& next) {
    const auto first_vertex = static_cast<std::uint32_t>(all.vertices.size());
    const auto first_triangle = static_cast<std::uint32_t>(all.triangle_count());
    if (all.vertices.size() + next.vertices.size() > 0xFFFFFFF0U ||
        all.triangle_count() + next.triangle_count() > (std::size_t{1} << 30U))
        throw Failure{ExitCode::file, "these levels are too large for one: cook them one by one"};
    std::map<std::pair<std::string, std::string>, std::uint32_t> known;
    const auto extras = [](const ImportedLevel& level, std::size_t i) {
        return i < level.surface_extras.size() ? level.surface_extras[i] : std::string();
    };
    for (std::uint32_t i = 0; i < all.surface_names.size(); ++i)
        known.try_emplace({all.surface_names[i], extras(all, i)}, i);
    std::vector<std::uint32_t> number(next.surface_names.size());
    for (std::uint32_t i = 0; i < number.size(); ++i) {
        const auto count = static_cast<std::uint32_t>(all.surface_names.size());
        const auto [found, is_new] = known.try_emplace({next.surface_names[i], extras(next, i)}, count);
        number[i] = found->second;
        if (!is_new) continue;
        all.surface_names.push_back(next.surface_names[i]);
        all.surface_extras.resize(count);
        all.surface_extras.push_back(extras(next, i));
    }
    all.vertices.insert(all.vertices.end(), next.vertices.begin(), next.vertices.end());
    for (const std::uint32_t index : next.indices) all.indices.push_back(first_vertex + index);
    for (const std::uint32_t surface : next.surfaces) all.surfaces.push_back(number[surface]);
    for (Part& part : next.parts) {
        part.first_triangle += first_triangle;
        all.parts.push_back(std::move(part));
    }
    std::move(next.markers.begin(), next.markers.end(), std::back_inserter(all.markers));
    const auto counts = counts_of(next.notes);
    const auto sums = counts_of(all.notes);
    for (std::size_t i = 0; i < counts.size(); ++i) *sums[i] += *counts[i];
}

}  // namespace

std::string with_near_file(const Error& error, const std::string& path) {
    std::error_code ignored;
    if (error.code != ErrorCode::not_found || std::filesystem::exists(level_path(path).file, ignored))
        return error.text;
    const std::string near = near_file(path);
    return near.empty() ? error.text : fmt::format("{}; did you mean '{}'?", error.text, near);
}

bool is_cooked_name(const std::string& path) {
    return ending_of(path) == ".surefoot";
}

std::optional<std::uint64_t> hash_of_sources(const std::vector<std::string>& files, const ImportOptions& options,
                                             double tolerance) {
    // Whatever changes the result and is not in the files. The version of the format is in the cache's path.
    std::uint64_t hash = hash_text(
        fmt::format("{}|{}|{}|{}|{}|{}", options.scale.value_or(0), options.scale.has_value(),
                    static_cast<int>(options.up), options.tolerance, static_cast<int>(options.quake3), tolerance),
        0);
    for (const std::string& name : files) {
        const LevelPath path = level_path(name);
        const std::filesystem::path file = path.file;
        const auto bytes = bytes_of(file);
        if (!bytes) return std::nullopt;
        hash = hash_text(fmt::format("{}|{}", ending_of(file), path.inside), hash);
        hash = hash_text(*bytes, hash);
        if (ending_of(file) != ".gltf") continue;
        const auto buffers = buffers_of(file, *bytes);
        if (!buffers) return std::nullopt;
        for (const std::filesystem::path& buffer : *buffers) {
            const auto content = bytes_of(buffer);
            if (!content) return std::nullopt;
            hash = hash_text(*content, hash);
        }
    }
    return hash;
}

ImportedLevel import_all(const std::vector<std::string>& files, const ImportOptions& options) {
    ImportedLevel all = import_one(files.front(), options);
    for (std::size_t i = 1; i < files.size(); ++i) append(all, import_one(files[i], options));
    return all;
}

Cooked cook_imported(ImportedLevel& level, double tolerance, std::uint64_t made_from,
                     const std::function<void(double done)>& tell) {
    std::vector<dvec3> vertices(level.vertices.begin(), level.vertices.end());
    ProgressBar bar("cooking");
    const auto progress = [&](double done) {
        bar.show(done);
        if (tell) tell(done);
    };
    auto cooked = cook({.vertices = vertices,
                        .indices = level.indices,
                        .surfaces = level.surfaces,
                        .notes = {std::move(level.surface_names), std::move(level.surface_extras),
                                  std::move(level.parts), std::move(level.markers)}},
                       {.tolerance = tolerance, .made_from = made_from, .progress = progress});
    if (!cooked) throw Failure{ExitCode::file, fmt::format("{}: {}", level.file, cooked.error().text)};
    return std::move(*cooked);
}

std::array<std::uint64_t*, import_note_count> counts_of(ImportNotes& notes) {
    return {&notes.points_skipped,   &notes.lines_skipped,    &notes.curves_skipped,       &notes.polygons_split,
            &notes.polygons_concave, &notes.polygons_crossed, &notes.degenerate_triangles, &notes.patches,
            &notes.brushes,          &notes.brushes_empty,    &notes.nonsolid_skipped};
}

std::vector<std::byte> to_bytes(const ImportNotes& notes) {
    ImportNotes copy = notes;
    std::vector<std::byte> bytes(import_note_count * sizeof(std::uint64_t));
    std::byte* at = bytes.data();
    for (const std::uint64_t* count : counts_of(copy)) {
        std::memcpy(at, count, sizeof(*count));
        at += sizeof(*count);
    }
    return bytes;
}

ImportNotes import_notes_of(const Mesh& mesh) {
    ImportNotes notes;
    const auto section = mesh.section(import_notes_section.owner, import_notes_section.name);
    if (!section || section->bytes.size() != import_note_count * sizeof(std::uint64_t)) return notes;
    const std::byte* at = section->bytes.data();
    for (std::uint64_t* count : counts_of(notes)) {
        std::memcpy(count, at, sizeof(*count));
        at += sizeof(*count);
    }
    return notes;
}

}  // namespace surefoot::tools
