// The format: Wavefront, "Advanced Visualizer Manual", appendix B1. Read here: v, f (and fo, its old name), p, l, o, g,
// usemtl, comments and lines continued by a backslash. Normals, texture coordinates and smoothing have no say in
// collision; material libraries are not opened, for a surface needs only its name.
#include "obj_reader.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <vector>

namespace surefoot::internal {
namespace {

bool is_blank(char c) {
    return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
}

std::string_view trimmed(std::string_view s) {
    while (!s.empty() && is_blank(s.front())) s.remove_prefix(1);
    while (!s.empty() && is_blank(s.back())) s.remove_suffix(1);
    return s;
}

/// Takes the next word off the front of `rest`; empty at the end.
std::string_view next_word(std::string_view& rest) {
    while (!rest.empty() && is_blank(rest.front())) rest.remove_prefix(1);
    std::size_t n = 0;
    while (n < rest.size() && !is_blank(rest[n])) ++n;
    const std::string_view word = rest.substr(0, n);
    rest.remove_prefix(n);
    return word;
}

/// What a message can show of a file's bytes.
std::string quoted(std::string_view word) {
    std::string text = "\"";
    for (const char c : word.substr(0, 40)) text += static_cast<unsigned char>(c) < 0x20 || c == 0x7f ? '?' : c;
    text += '"';
    return text;
}

enum class Number : std::uint8_t { good, not_a_number, not_finite };

/// The float nearest to a decimal. std::from_chars rounds correctly; what it calls out of range is too large to be a
/// float or so small that the nearest one is zero or close to it.
Number parse_float(std::string_view word, float& value) {
    const bool negative = word.starts_with('-');
    if (word.starts_with('+')) {
        word.remove_prefix(1);
        if (word.starts_with('-')) return Number::not_a_number;
    }
    const char* const end = word.data() + word.size();
    auto [stop, error] = std::from_chars(word.data(), end, value);
    if (error == std::errc::invalid_argument || stop != end) return Number::not_a_number;
    if (error == std::errc{}) return std::isfinite(value) ? Number::good : Number::not_finite;
    double wide = 0;
    if (std::from_chars(word.data(), end, wide).ec == std::errc{}) {
        value = static_cast<float>(wide);
        return std::abs(wide) < 1 ? Number::good : Number::not_finite;
    }
    const std::size_t exponent = word.find_first_of("eE");
    if (exponent == std::string_view::npos || word.substr(exponent + 1, 1) != "-") return Number::not_finite;
    value = negative ? -0.0f : 0.0f;
    return Number::good;
}

class ObjReader {
public:
    ObjReader(std::string_view text, const Placement& placement, const ReadLimits& limits)
        : rest_(text), placement_(placement), builder_(limits) {
        if (!rest_.starts_with("\xef\xbb\xbf")) return;  // some editors mark UTF-8 so
        offset_ = 3;
        rest_.remove_prefix(offset_);
    }

    Expected<ImportedLevel> read() {
        while (next_line()) {
            if (auto error = read_statement(line_)) return tl::unexpected(located(std::move(*error)));
        }
        ImportedLevel level = builder_.take();
        level.notes.curves_skipped = curves_;
        if (level.indices.empty()) return tl::unexpected(located(nothing_found(level)));
        return level;
    }

private:
    using Result = std::optional<Error>;

    Error located(Error error) const {
        if (error.code == ErrorCode::invalid && !level_wide_)
            error.text = "line " + std::to_string(line_number_) + ": " + error.text;
        error.byte = error.code == ErrorCode::invalid && !level_wide_ ? line_byte_ : 0;
        return error;
    }

    static Error invalid(std::string text) { return {.code = ErrorCode::invalid, .text = std::move(text), .file = {}}; }

    Error nothing_found(const ImportedLevel& level) {
        level_wide_ = true;
        if (!level.vertices.empty()) {
            return invalid("it has " + std::to_string(level.vertices.size()) +
                           " vertices and no face; export the surfaces as polygons, not as points, lines or curves");
        }
        Error error =
            invalid("it has no vertex and no face, so it is no Wavefront OBJ or an empty one; export it again");
        error.code = ErrorCode::unreadable;
        return error;
    }

    /// The next line, joined with those that it is continued on. False at the end.
    bool next_line() {
        if (rest_.empty()) return false;
        line_byte_ = offset_;
        line_number_ += lines_in_statement_;
        lines_in_statement_ = 1;
        line_ = take_physical_line();
        // A comment does not continue, or "# made from C:\levels\" would swallow the line that follows.
        if (!line_.ends_with('\\') || line_.starts_with('#')) return true;
        joined_.clear();
        while (line_.ends_with('\\')) {
            joined_.append(line_.substr(0, line_.size() - 1)).push_back(' ');
            if (rest_.empty()) {
                line_ = {};
                break;
            }
            ++lines_in_statement_;
            line_ = take_physical_line();
        }
        joined_.append(line_);
        line_ = joined_;
        return true;
    }

    std::string_view take_physical_line() {
        const std::size_t end = std::min(rest_.find('\n'), rest_.size());
        std::string_view line = rest_.substr(0, end);
        const std::size_t taken = std::min(end + 1, rest_.size());
        rest_.remove_prefix(taken);
        offset_ += taken;
        if (line.ends_with('\r')) line.remove_suffix(1);
        return line;
    }

    Result read_statement(std::string_view line) {
        const std::string_view keyword = next_word(line);
        if (keyword == "v") return read_vertex(line);
        if (keyword == "f" || keyword == "fo") return read_face(line);
        if (keyword == "o" || keyword == "g") {
            builder_.begin_part(trimmed(line));
        } else if (keyword == "usemtl") {
            builder_.set_surface(trimmed(line));
        } else if (keyword == "p") {
            while (!next_word(line).empty()) ++builder_.notes().points_skipped;
        } else if (keyword == "l") {
            ++builder_.notes().lines_skipped;
        } else if (keyword == "curv" || keyword == "curv2" || keyword == "surf") {
            ++curves_;
        }
        if (++statements_since_check_ < 4096) return std::nullopt;
        statements_since_check_ = 0;
        return builder_.check_limits();
    }

    Result read_vertex(std::string_view line) {
        std::array<float, 3> v{};
        for (float& coordinate : v) {
            const std::string_view word = next_word(line);
            if (word.empty()) return invalid("a vertex needs three coordinates; the file is cut short or damaged");
            switch (parse_float(word, coordinate)) {
                case Number::good:
                    break;
                case Number::not_a_number:
                    return invalid(quoted(word) + " is no number; correct the vertex");
                case Number::not_finite:
                    return invalid(quoted(word) +
                                   " is no finite float; correct the vertex, or delete it with its faces");
            }
        }
        const vec3 placed =
            placement_.vertex({static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])});
        if (!std::isfinite(placed.x) || !std::isfinite(placed.y) || !std::isfinite(placed.z)) {
            return invalid("the vertex is no finite float once scaled; use a smaller ImportOptions::scale");
        }
        if (builder_.vertex_count() >= 0xffffffffu) {
            return Error{
                .code = ErrorCode::limit, .text = "there are more than 2^32 vertices; split the level", .file = {}};
        }
        builder_.add_vertex(placed);
        if (++statements_since_check_ < 4096) return std::nullopt;
        statements_since_check_ = 0;
        return builder_.check_limits();
    }

    /// A corner is i, i/t, i//n or i/t/n; only i, the vertex, matters here. Negative counts back from the last vertex.
    Result read_face(std::string_view line) {
        face_.clear();
        for (std::string_view word = next_word(line); !word.empty(); word = next_word(line)) {
            if (word.starts_with('#')) break;
            std::int64_t index = 0;
            const char* const end = word.data() + word.size();
            const auto [stop, error] = std::from_chars(word.data(), end, index);
            if (error == std::errc::invalid_argument || (stop != end && *stop != '/')) {
                return invalid(quoted(word) + " is no corner of a face (i, i/t, i//n or i/t/n); correct the face");
            }
            const auto count = static_cast<std::int64_t>(builder_.vertex_count());
            const std::int64_t vertex = index < 0 ? count + index : index - 1;
            if (error != std::errc{} || index == 0 || vertex < 0 || vertex >= count) {
                return invalid("the face uses vertex " + quoted(word) + ", and so far there are " +
                               std::to_string(count) + " (counted from 1, or from -1 backwards)");
            }
            face_.push_back(static_cast<std::uint32_t>(vertex));
        }
        if (face_.empty()) return invalid("a face without corners; the file is cut short or damaged");
        return builder_.add_face(face_);
    }

    std::string_view rest_;
    Placement placement_;
    LevelBuilder builder_;
    std::string_view line_;
    std::string joined_;
    std::vector<std::uint32_t> face_;
    std::uint64_t offset_ = 0;
    std::uint64_t line_byte_ = 0;
    std::uint64_t line_number_ = 1;
    std::uint64_t lines_in_statement_ = 0;
    std::uint64_t statements_since_check_ = 0;
    std::uint64_t curves_ = 0;
    bool level_wide_ = false;  ///< the error is about the file and not about a line
};

}  // namespace

Expected<ImportedLevel> read_obj(std::string_view text, const Placement& placement, const ReadLimits& limits) {
    return ObjReader(text, placement, limits).read();
}

}  // namespace surefoot::internal
