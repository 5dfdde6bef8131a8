#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <new>
#include <span>

#include <surefoot/import.hpp>

#include "format.hpp"
#include "limited_read.hpp"
#include "obj_reader.hpp"
#include "programs.hpp"
#include "quake3/pk3.hpp"
#include "quake3/reader.hpp"

namespace surefoot {
inline namespace v0 {
namespace {

namespace fs = std::filesystem;
using internal::Deadline;
using internal::Format;

Error invalid(std::string text) {
    return {.code = ErrorCode::invalid, .text = std::move(text), .file = {}};
}

std::optional<Error> check_options(const ImportOptions& options) {
    if (options.scale && !(*options.scale >= 1e-9 && *options.scale <= 1e9))
        return invalid("ImportOptions::scale must be from 1e-9 to 1e9");
    if (!(options.tolerance >= 1e-6 && options.tolerance <= 1e6))
        return invalid("ImportOptions::tolerance must be from 1e-6 to 1e6 metres");
    if (options.quake3 > Quake3Solids::brushes) return invalid("ImportOptions::quake3 must be one of Quake3Solids");
    if (!(options.time_limit > 0 && options.time_limit <= 86400)) {
        return invalid("ImportOptions::time_limit must be above 0 and at most 86400 seconds");
    }
    if (options.memory_limit < (std::uint64_t{16} << 20))
        return invalid("ImportOptions::memory_limit must be at least 16 MiB");
    if (options.up > UpAxis::z) return invalid("ImportOptions::up must be one of UpAxis");
    return std::nullopt;
}

/// The size of a file that is there, is a file, and has something in it.
Expected<std::uint64_t> size_of(const std::string& path) {
    const auto failure = [](ErrorCode code, const char* text) {
        return tl::unexpected(Error{.code = code, .text = text, .file = {}});
    };
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (status.type() == fs::file_type::not_found)
        return failure(ErrorCode::not_found, "there is no such file; check the path");
    if (error) return failure(ErrorCode::not_found, "it may not be looked at; check the path and its permissions");
    if (fs::is_directory(status)) return failure(ErrorCode::not_found, "it is a folder; name a file in it");
    if (!fs::is_regular_file(status))
        return failure(ErrorCode::unsupported, "it is no plain file; copy its content into one");
    const std::uintmax_t size = fs::file_size(path, error);
    if (error) return failure(ErrorCode::not_found, "it may not be looked at; check its permissions");
    if (size == 0) return failure(ErrorCode::unreadable, "it is empty; export it again");
    return size;
}

Expected<std::string> read_text(const std::string& path, std::uint64_t most) {
    std::ifstream file(path, std::ios::binary);
    if (!file) {
        return tl::unexpected(
            Error{.code = ErrorCode::not_found, .text = "it may not be read; check its permissions", .file = {}});
    }
    std::string text(most, '\0');
    file.read(text.data(), static_cast<std::streamsize>(most));
    text.resize(static_cast<std::size_t>(file.gcount()));
    return text;
}

Expected<ImportedLevel> import_obj(const internal::LimitedRead& request, std::uint64_t size) {
    const auto text = read_text(request.path, size);
    if (!text) return tl::unexpected(text.error());
    return internal::read_obj(*text, request.placement,
                              {.deadline = request.deadline, .bytes = request.options.memory_limit - size});
}

Expected<ImportedLevel> import_bsp(const internal::LimitedRead& request, std::string_view bytes) {
    // The reader's own tables take up to four times the file.
    const std::uint64_t held = 4 * std::uint64_t{bytes.size()};
    if (held > request.options.memory_limit) return tl::unexpected(internal::memory_error());
    return internal::quake3::read_bsp(std::as_bytes(std::span(bytes)), request.placement,
                                      {.deadline = request.deadline, .bytes = request.options.memory_limit - held},
                                      {.tolerance = request.options.tolerance, .solids = request.options.quake3});
}

Expected<ImportedLevel> import_pk3(const internal::LimitedRead& request) {
    std::ifstream file(request.path, std::ios::binary);
    const auto map = internal::quake3::read_pk3(
        file, request.inside, {.deadline = request.deadline, .bytes = request.options.memory_limit / 4});
    if (!map) return tl::unexpected(map.error());
    auto level = import_bsp(request, map->bytes);
    if (!level) {
        Error error = level.error();
        error.text = map->name + ": " + error.text;
        return tl::unexpected(std::move(error));
    }
    return level;
}

/// Assimp reads most of them and fails, or crashes, on some. Blender reads them all.
Expected<ImportedLevel> import_old_blend(const internal::LimitedRead& request) {
    Expected<ImportedLevel> level = internal::read_in_child(request);
    if (level || level.error().code != ErrorCode::unreadable) return level;
    if (internal::find_blender()) return internal::read_through_blender(request);
    Error error = level.error();
    error.text += ", or install Blender, which is asked when Assimp fails";
    return tl::unexpected(std::move(error));
}

Expected<ImportedLevel> import_blend(const internal::LimitedRead& request) {
    const auto head = read_text(request.path, 16);
    if (!head) return tl::unexpected(head.error());
    switch (internal::blend_age(*head)) {
        case internal::BlendAge::old:
            return import_old_blend(request);
        case internal::BlendAge::current:
            return internal::read_through_blender(request);
        case internal::BlendAge::no_blend:
            break;
    }
    return tl::unexpected(Error{.code = ErrorCode::unreadable,
                                .text = "it does not begin like a .blend; save it again in Blender",
                                .file = {}});
}

Deadline deadline_of(const ImportOptions& options) {
    return std::chrono::steady_clock::now() + std::chrono::duration_cast<std::chrono::steady_clock::duration>(
                                                  std::chrono::duration<double>(options.time_limit));
}

Expected<std::vector<std::string>> maps_unnamed(const std::string& path, const ImportOptions& options) {
    if (auto error = check_options(options)) return tl::unexpected(std::move(*error));
    const auto format = internal::format_of(path);
    if (!format || *format != Format::pk3) return {};
    if (const auto size = size_of(path); !size) return tl::unexpected(size.error());
    std::ifstream file(path, std::ios::binary);
    return internal::quake3::maps_in_pk3(file, {.deadline = deadline_of(options), .bytes = options.memory_limit});
}

Expected<ImportedLevel> import_unnamed(const std::string& path, const ImportOptions& options) {
    if (auto error = check_options(options)) return tl::unexpected(std::move(*error));
    const LevelPath place = level_path(path);
    const auto size = size_of(place.file);
    if (!size) return tl::unexpected(size.error());
    const auto format = internal::format_of(place.file);
    if (!format) return tl::unexpected(format.error());
    // Of a .pk3 only one map is read, so that its own size says nothing.
    if (*format != Format::pk3 && *size > options.memory_limit) return tl::unexpected(internal::memory_error());

    const internal::LimitedRead request{
        .path = place.file,
        .inside = place.inside,
        .format = *format,
        .placement = {.scale = options.scale.value_or(internal::usual_scale(*format)),
                      .up = options.up == UpAxis::by_format ? internal::usual_up(*format) : options.up},
        .deadline = deadline_of(options),
        .options = options};
    if (*format == Format::obj) return import_obj(request, *size);
    if (*format == Format::blend) return import_blend(request);
    if (*format == Format::pk3) return import_pk3(request);
    if (*format == Format::bsp) {
        const auto bytes = read_text(request.path, *size);
        return bytes ? import_bsp(request, *bytes) : tl::unexpected(bytes.error());
    }
    return internal::read_in_child(request);
}

/// Every text names the file first, so that it can be printed as it is.
Error named(Error error, const std::string& path) {
    error.file = path;
    error.text = path + ": " + error.text;
    return error;
}

Error no_memory() {
    return {.code = ErrorCode::out_of_memory,
            .text = "memory ran out while reading; close other programs, or split the level",
            .file = {}};
}

}  // namespace

LevelPath level_path(const std::string& path) {
    std::error_code ignored;
    if (fs::exists(path, ignored)) return {.file = path, .inside = {}};
    std::string plain = path;
    for (char& c : plain) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    const std::size_t colon = plain.find(".pk3:");
    if (colon == std::string::npos) return {.file = path, .inside = {}};
    return {.file = path.substr(0, colon + 4), .inside = path.substr(colon + 5)};
}

Expected<std::vector<std::string>> maps_in(const std::string& file, const ImportOptions& options) {
    try {
        auto maps = maps_unnamed(file, options);
        if (!maps) return tl::unexpected(named(maps.error(), file));
        return maps;
    } catch (const std::bad_alloc&) {
        return tl::unexpected(named(no_memory(), file));
    }
}

Expected<ImportedLevel> import_level(const std::string& path, const ImportOptions& options) {
    try {
        Expected<ImportedLevel> level = import_unnamed(path, options);
        if (!level) return tl::unexpected(named(level.error(), path));
        level->file = path;
        return level;
    } catch (const std::bad_alloc&) {
        return tl::unexpected(named(no_memory(), path));
    }
}

Expected<Mesh> build_mesh(const ImportedLevel& level) {
    Expected<Mesh> mesh = Mesh::build(level.mesh_input());
    if (!mesh) return tl::unexpected(named(mesh.error(), level.file));
    return mesh;
}

}  // namespace v0
}  // namespace surefoot
