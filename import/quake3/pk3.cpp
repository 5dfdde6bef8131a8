#include "pk3.hpp"

#include <algorithm>
#include <array>
#include <istream>
#include <memory>
#include <minizip/unzip.h>

namespace surefoot::internal::quake3 {
namespace {

// ---- how minizip reads a stream

voidpf open_stream(voidpf stream, const void*, int) {
    return stream;
}

uLong read_stream(voidpf, voidpf stream, void* bytes, uLong size) {
    auto& file = *static_cast<std::istream*>(stream);
    file.clear();
    file.read(static_cast<char*>(bytes), static_cast<std::streamsize>(size));
    return static_cast<uLong>(file.gcount());
}

uLong write_stream(voidpf, voidpf, const void*, uLong) {
    return 0;
}

ZPOS64_T tell_stream(voidpf, voidpf stream) {
    auto& file = *static_cast<std::istream*>(stream);
    file.clear();
    return static_cast<ZPOS64_T>(static_cast<std::streamoff>(file.tellg()));
}

long seek_stream(voidpf, voidpf stream, ZPOS64_T offset, int origin) {
    auto& file = *static_cast<std::istream*>(stream);
    file.clear();
    const auto from = origin == ZLIB_FILEFUNC_SEEK_SET   ? std::ios::beg
                      : origin == ZLIB_FILEFUNC_SEEK_CUR ? std::ios::cur
                                                         : std::ios::end;
    file.seekg(static_cast<std::streamoff>(offset), from);
    return file.fail() ? -1 : 0;
}

int close_stream(voidpf, voidpf) {
    return 0;
}

int stream_error(voidpf, voidpf) {
    return 0;
}

struct Close {
    void operator()(unzFile zip) const { unzClose(zip); }
};
using Zip = std::unique_ptr<void, Close>;

Zip open_zip(std::istream& file) {
    zlib_filefunc64_def functions{};
    functions.zopen64_file = open_stream;
    functions.zread_file = read_stream;
    functions.zwrite_file = write_stream;
    functions.ztell64_file = tell_stream;
    functions.zseek64_file = seek_stream;
    functions.zclose_file = close_stream;
    functions.zerror_file = stream_error;
    functions.opaque = &file;
    return Zip(unzOpen2_64("", &functions));
}

// ---- names

std::string lower(std::string_view text) {
    std::string result(text);
    for (char& c : result) {
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
        if (c == '\\') c = '/';
    }
    return result;
}

bool is_map(std::string_view name) {
    const std::string plain = lower(name);
    return plain.starts_with("maps/") && plain.ends_with(".bsp") && plain.find('/', 5) == std::string::npos;
}

bool is_wanted(std::string_view name, std::string_view wanted) {
    const std::string plain = lower(name);
    const std::string other = lower(wanted);
    return plain == other || plain == "maps/" + other || plain == "maps/" + other + ".bsp";
}

struct Entry {
    std::string name;
    std::uint64_t size = 0;  ///< as the zip says
    bool encrypted = false;
    unz64_file_pos place{};
};

Error failure(ErrorCode code, std::string text) {
    return {.code = code, .text = std::move(text), .file = {}};
}

Error no_zip() {
    return failure(ErrorCode::unreadable, "it is no zip file, or it is cut short; take another copy of it");
}

std::string list_of(const std::vector<Entry>& maps) {
    constexpr std::size_t most = 100;
    std::string list;
    for (std::size_t i = 0; i < std::min(maps.size(), most); ++i) list += "\n  " + maps[i].name;
    if (maps.size() > most) list += "\n  and " + std::to_string(maps.size() - most) + " more";
    return list;
}

Expected<std::vector<Entry>> maps_in(unzFile zip, const ReadLimits& limits) {
    std::vector<Entry> maps;
    for (int state = unzGoToFirstFile(zip); state != UNZ_END_OF_LIST_OF_FILE; state = unzGoToNextFile(zip)) {
        std::array<char, 1024> name{};
        unz_file_info64 info{};
        if (state != UNZ_OK ||
            unzGetCurrentFileInfo64(zip, &info, name.data(), name.size() - 1, nullptr, 0, nullptr, 0) != UNZ_OK) {
            return tl::unexpected(
                failure(ErrorCode::unreadable, "the list of files in this .pk3 is damaged; take another copy of it"));
        }
        if (std::chrono::steady_clock::now() > limits.deadline) return tl::unexpected(time_error());
        if (!is_map(name.data())) continue;
        Entry entry{
            .name = name.data(), .size = info.uncompressed_size, .encrypted = (info.flag & 1) != 0, .place = {}};
        for (char& c : entry.name) {
            if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '?';
        }
        unzGetFilePos64(zip, &entry.place);
        maps.push_back(std::move(entry));
    }
    std::ranges::sort(maps, {}, &Entry::name);
    return maps;
}

Expected<Entry> choose(const std::vector<Entry>& maps, std::string_view wanted) {
    if (maps.empty()) {
        return tl::unexpected(
            failure(ErrorCode::not_found, "there is no map in this .pk3 (nothing at maps/*.bsp); name another one"));
    }
    if (wanted.empty()) {
        if (maps.size() == 1) return maps.front();
        return tl::unexpected(
            failure(ErrorCode::not_found, "there are " + std::to_string(maps.size()) +
                                              " maps in this .pk3; name one of them behind a colon, as in FILE.pk3:" +
                                              maps.front().name + list_of(maps)));
    }
    const auto found = std::ranges::find_if(maps, [&](const Entry& map) { return is_wanted(map.name, wanted); });
    if (found != maps.end()) return *found;
    return tl::unexpected(failure(ErrorCode::not_found, "there is no map \"" + std::string(wanted.substr(0, 100)) +
                                                            "\" in this .pk3; these are there:" + list_of(maps)));
}

Expected<std::string> unpack(unzFile zip, Entry& entry, const ReadLimits& limits) {
    const auto damaged = [&] {
        return tl::unexpected(
            failure(ErrorCode::unreadable, entry.name + " in this .pk3 is damaged; take another copy of it"));
    };
    if (entry.encrypted) {
        return tl::unexpected(failure(ErrorCode::unsupported,
                                      entry.name + " in this .pk3 is encrypted; unpack it and name the .bsp instead"));
    }
    if (entry.size > limits.bytes) return tl::unexpected(memory_error());
    if (unzGoToFilePos64(zip, &entry.place) != UNZ_OK || unzOpenCurrentFile(zip) != UNZ_OK) return damaged();
    // What the zip says about the size bounds what is read, and is itself believed only as it comes true.
    std::string bytes;
    std::array<char, 65536> piece{};
    while (true) {
        const int got = unzReadCurrentFile(zip, piece.data(), piece.size());
        if (got < 0 || bytes.size() + static_cast<std::size_t>(got) > entry.size) {
            unzCloseCurrentFile(zip);
            return damaged();
        }
        if (got == 0) break;
        bytes.append(piece.data(), static_cast<std::size_t>(got));
        if (std::chrono::steady_clock::now() > limits.deadline) {
            unzCloseCurrentFile(zip);
            return tl::unexpected(time_error());
        }
    }
    // Closing compares the checksum, once all has been read.
    if (unzCloseCurrentFile(zip) != UNZ_OK || bytes.size() != entry.size) return damaged();
    return bytes;
}

}  // namespace

Expected<std::vector<std::string>> maps_in_pk3(std::istream& file, const ReadLimits& limits) {
    const Zip zip = open_zip(file);
    if (!zip) return tl::unexpected(no_zip());
    const auto maps = maps_in(zip.get(), limits);
    if (!maps) return tl::unexpected(maps.error());
    std::vector<std::string> names;
    for (const Entry& map : *maps) names.push_back(map.name);
    return names;
}

Expected<PackedMap> read_pk3(std::istream& file, std::string_view wanted, const ReadLimits& limits) {
    const Zip zip = open_zip(file);
    if (!zip) return tl::unexpected(no_zip());
    const auto maps = maps_in(zip.get(), limits);
    if (!maps) return tl::unexpected(maps.error());
    auto entry = choose(*maps, wanted);
    if (!entry) return tl::unexpected(entry.error());
    auto bytes = unpack(zip.get(), *entry, limits);
    if (!bytes) return tl::unexpected(bytes.error());
    return PackedMap{.name = entry->name, .bytes = std::move(*bytes)};
}

}  // namespace surefoot::internal::quake3
