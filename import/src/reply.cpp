#include "reply.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <string_view>
#include <type_traits>

namespace surefoot::internal {
namespace {

constexpr std::string_view head = "surefoot-reply-1";
constexpr std::string_view tail = "end of the reply";
constexpr std::uint32_t kind_level = 0;
constexpr std::uint32_t kind_error = 1;

class Writer {
public:
    explicit Writer(std::uint32_t kind) {
        raw(head.data(), head.size());
        number(kind);
    }

    template <typename T>
    requires std::is_trivially_copyable_v<T>
    void number(const T& value) { raw(&value, sizeof value); }

    void text(std::string_view value) {
        // Longer names than 4 GiB do not exist; a length that is cut makes the reply inconsistent, and it is refused.
        number(
            static_cast<std::uint32_t>(std::min<std::size_t>(value.size(), std::numeric_limits<std::uint32_t>::max())));
        raw(value.data(), value.size());
    }

    template <typename T>
    void array(const std::vector<T>& values) {
        number(static_cast<std::uint64_t>(values.size()));
        raw(values.data(), values.size() * sizeof(T));
    }

    std::vector<std::byte> finish() {
        raw(tail.data(), tail.size());
        return std::move(bytes_);
    }

private:
    void raw(const void* data, std::size_t size) {
        const std::size_t old = bytes_.size();
        bytes_.resize(old + size);
        if (size > 0) std::memcpy(bytes_.data() + old, data, size);
    }

    std::vector<std::byte> bytes_;
};

/// Reads from the front. After the first thing that does not fit, everything reads as nothing and `good` is false.
class Reader {
public:
    explicit Reader(std::span<const std::byte> bytes) : rest_(bytes) {}

    [[nodiscard]] bool good() const { return good_; }
    [[nodiscard]] bool at_end() const { return good_ && rest_.empty(); }

    template <typename T>
    requires std::is_trivially_copyable_v<T> T number() {
        T value{};
        if (rest_.size() < sizeof(T)) {
            fail();
        } else {
            std::memcpy(&value, rest_.data(), sizeof(T));
            rest_ = rest_.subspan(sizeof(T));
        }
        return value;
    }

    std::string text() {
        const auto length = number<std::uint32_t>();
        if (length > rest_.size()) fail();
        if (!good_) return {};
        std::string value(reinterpret_cast<const char*>(rest_.data()), length);
        rest_ = rest_.subspan(length);
        return value;
    }

    template <typename T>
    std::vector<T> array() {
        const auto count = number<std::uint64_t>();
        if (count > rest_.size() / sizeof(T)) fail();
        if (!good_) return {};
        std::vector<T> values(count);
        if (count > 0) std::memcpy(static_cast<void*>(values.data()), rest_.data(), count * sizeof(T));
        rest_ = rest_.subspan(count * sizeof(T));
        return values;
    }

    /// How many things follow, of which each takes at least `least` bytes.
    std::size_t count(std::size_t least) {
        const auto value = number<std::uint64_t>();
        if (value > rest_.size() / least) fail();
        return good_ ? value : 0;
    }

    bool expect(std::string_view bytes) {
        if (rest_.size() < bytes.size() || std::memcmp(rest_.data(), bytes.data(), bytes.size()) != 0) {
            fail();
            return false;
        }
        rest_ = rest_.subspan(bytes.size());
        return true;
    }

private:
    void fail() {
        good_ = false;
        rest_ = {};
    }

    std::span<const std::byte> rest_;
    bool good_ = true;
};

bool is_finite(const dvec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

bool is_finite(const vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

bool parts_cover(const ImportedLevel& level) {
    std::uint64_t next = 0;
    for (const ImportedPart& part : level.parts) {
        if (part.first_triangle != next || part.triangle_count == 0) return false;
        next += part.triangle_count;
    }
    return next == level.triangle_count();
}

bool is_consistent(const ImportedLevel& level) {
    return level.indices.size() % 3 == 0 && level.surfaces.size() == level.triangle_count() &&
           !level.surface_names.empty() && level.surface_extras.size() == level.surface_names.size() &&
           std::ranges::all_of(level.vertices, [](const vec3& v) { return is_finite(v); }) &&
           std::ranges::all_of(level.indices, [&](std::uint32_t i) { return i < level.vertices.size(); }) &&
           std::ranges::all_of(level.surfaces, [&](std::uint32_t s) { return s < level.surface_names.size(); }) &&
           std::ranges::all_of(level.markers,
                               [](const ImportedMarker& m) {
                                   const dvec3 axis{m.orientation.x, m.orientation.y, m.orientation.z};
                                   return is_finite(m.position) && is_finite(m.scale) && is_finite(axis) &&
                                          std::isfinite(m.orientation.w);
                               }) &&
           parts_cover(level);
}

ImportedLevel read_level(Reader& reader) {
    ImportedLevel level;
    level.vertices = reader.array<vec3>();
    level.indices = reader.array<std::uint32_t>();
    level.surfaces = reader.array<std::uint32_t>();
    for (std::size_t n = reader.count(4); n > 0; --n) level.surface_names.push_back(reader.text());
    for (std::size_t n = reader.count(4); n > 0; --n) level.surface_extras.push_back(reader.text());
    for (std::size_t n = reader.count(12); n > 0; --n) {
        ImportedPart part;
        part.name = reader.text();
        part.first_triangle = reader.number<std::uint32_t>();
        part.triangle_count = reader.number<std::uint32_t>();
        level.parts.push_back(std::move(part));
    }
    for (std::size_t n = reader.count(12); n > 0; --n) {
        ImportedMarker marker;
        marker.name = reader.text();
        marker.kind = reader.text();
        marker.extras = reader.text();
        marker.position = reader.number<dvec3>();
        marker.orientation = reader.number<dquat>();
        marker.scale = reader.number<dvec3>();
        level.markers.push_back(std::move(marker));
    }
    level.notes = reader.number<ImportNotes>();
    return level;
}

}  // namespace

std::vector<std::byte> encode_level(const ImportedLevel& level) {
    Writer writer(kind_level);
    writer.array(level.vertices);
    writer.array(level.indices);
    writer.array(level.surfaces);
    writer.number(static_cast<std::uint64_t>(level.surface_names.size()));
    for (const std::string& name : level.surface_names) writer.text(name);
    writer.number(static_cast<std::uint64_t>(level.surface_extras.size()));
    for (const std::string& extras : level.surface_extras) writer.text(extras);
    writer.number(static_cast<std::uint64_t>(level.parts.size()));
    for (const ImportedPart& part : level.parts) {
        writer.text(part.name);
        writer.number(part.first_triangle);
        writer.number(part.triangle_count);
    }
    writer.number(static_cast<std::uint64_t>(level.markers.size()));
    for (const ImportedMarker& marker : level.markers) {
        writer.text(marker.name);
        writer.text(marker.kind);
        writer.text(marker.extras);
        writer.number(marker.position);
        writer.number(marker.orientation);
        writer.number(marker.scale);
    }
    writer.number(level.notes);
    return writer.finish();
}

std::vector<std::byte> encode_error(const Error& error) {
    Writer writer(kind_error);
    writer.number(static_cast<std::uint32_t>(error.code));
    writer.text(error.text);
    writer.number(error.byte);
    return writer.finish();
}

Expected<ImportedLevel> decode_reply(std::span<const std::byte> bytes) {
    const Error damaged{.code = ErrorCode::unreadable, .text = {}, .file = {}};
    Reader reader(bytes);
    if (!reader.expect(head)) return tl::unexpected(damaged);
    const auto kind = reader.number<std::uint32_t>();
    if (kind == kind_error) {
        Error error;
        const auto code = reader.number<std::uint32_t>();
        error.text = reader.text();
        error.byte = reader.number<std::uint64_t>();
        if (!reader.expect(tail) || !reader.at_end() || code > static_cast<std::uint32_t>(ErrorCode::out_of_memory)) {
            return tl::unexpected(damaged);
        }
        error.code = static_cast<ErrorCode>(code);
        return tl::unexpected(std::move(error));
    }
    if (kind != kind_level) return tl::unexpected(damaged);
    ImportedLevel level = read_level(reader);
    if (!reader.expect(tail) || !reader.at_end() || !is_consistent(level)) return tl::unexpected(damaged);
    return level;
}

}  // namespace surefoot::internal
