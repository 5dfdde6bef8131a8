#include "capture/writer.hpp"

#include <bit>
#include <cmath>

#include "capture/words.hpp"

namespace surefoot::internal {

namespace {

// How many bytes the UTF-8 character at the front has; 0 if there is none: cut, overlong, a surrogate, beyond the last.
std::size_t character_at(std::string_view text) noexcept {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned first = byte(0);
    if (first < 0x80) return 1;
    const std::size_t size = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
    if (first < 0xc2 || first > 0xf4 || text.size() < size) return 0;
    for (std::size_t i = 1; i < size; ++i)
        if ((byte(i) & 0xc0U) != 0x80) return 0;
    const unsigned second = byte(1);
    const bool wrong = (first == 0xe0 && second < 0xa0) || (first == 0xed && second > 0x9f) ||
                       (first == 0xf0 && second < 0x90) || (first == 0xf4 && second > 0x8f);
    return wrong ? 0 : size;
}

}  // namespace

void Writer::number(double value) {
    if (std::isfinite(value)) return append_shortest(out_, value);
    out_ += '"';
    if (std::isnan(value)) {
        out_ += nan_word;
        append_bits(out_, std::bit_cast<std::uint64_t>(value));
    } else {
        out_ += value > 0 ? infinity_word : minus_infinity_word;
    }
    out_ += '"';
}

void Writer::text(std::string_view text) {
    out_ += '"';
    while (!text.empty()) {
        const std::size_t size = character_at(text);
        const char first = text.front();
        if (size == 0) {
            out_ += '?';
        } else if (first == '"' || first == '\\') {
            out_ += '\\';
            out_ += first;
        } else if (first == '\n') {
            out_ += "\\n";
        } else if (size == 1 && (static_cast<unsigned char>(first) < 0x20 || first == 0x7f)) {
            out_ += "\\u00";
            out_ += "0123456789abcdef"[static_cast<unsigned char>(first) >> 4U];
            out_ += "0123456789abcdef"[static_cast<unsigned char>(first) & 15U];
        } else {
            out_ += text.substr(0, size);
        }
        text.remove_prefix(size == 0 ? 1 : size);
    }
    out_ += '"';
}

// `between` stands before the second member: a comma, and the line that it begins.
void write_volume(Writer& w, const Volume& volume, std::string_view between) {
    const std::size_t index = volume.shape.index();
    const std::array<double, 3> d = dimensions_of(volume.shape);
    w.word("\"shape\": {\"");
    w.word(shape_words[index]);
    w.word("\": ");
    if (shape_counts[index] == 1) w.list(d[0]);
    if (shape_counts[index] == 2) w.list(d[0], d[1]);
    if (shape_counts[index] == 3) w.list(d[0], d[1], d[2]);
    w.word("}");
    w.word(between);
    w.word("\"rotate\": ");
    w.list(volume.orientation);
}

void write_pose(Writer& w, const Pose& pose) {
    w.word("{\"position\": ");
    w.list(pose.position);
    w.word(", \"rotate\": ");
    w.list(pose.orientation);
    w.word("}");
}

void write_poses(Writer& w, std::uint32_t body, const Pose& start, const Pose& end) {
    w.word("\"body\": ");
    w.number(body);
    w.word(", \"start\": ");
    write_pose(w, start);
    w.word(", \"end\": ");
    write_pose(w, end);
}

void write_body(Writer& w, const CapturedBody& body) {
    w.word("{");
    write_poses(w, body.body, body.start, body.end);
    w.word(", \"min\": ");
    w.list(body.bounds.min);
    w.word(", \"max\": ");
    w.list(body.bounds.max);
    w.word("}");
}

void write_triangle(Writer& w, const CapturedTriangle& one) {
    w.word("{\"body\": ");
    w.number(one.body);
    w.word(", \"id\": ");
    w.number(one.id);
    w.word(", \"surface\": ");
    w.number(one.surface);
    w.word(", \"a\": ");
    w.list(one.triangle.a);
    w.word(", \"b\": ");
    w.list(one.triangle.b);
    w.word(", \"c\": ");
    w.list(one.triangle.c);
    w.word("}");
}

void write_origin(Writer& w, std::string_view kind, std::uint32_t form, const CaptureOrigin& origin,
                  std::string_view note) {
    w.word("{\n  \"");
    w.word(kind);
    w.word("\": ");
    w.number(form);
    const Version& library = origin.library;
    w.word(",\n  \"library\": \"");
    w.number(static_cast<std::uint32_t>(library.major));
    w.word(".");
    w.number(static_cast<std::uint32_t>(library.minor));
    w.word(".");
    w.number(static_cast<std::uint32_t>(library.patch));
    w.word("\",\n  \"abi\": ");
    w.text(origin.abi);
    w.word(",\n  \"note\": ");
    w.text(note);
    w.word(",\n");
}

}  // namespace surefoot::internal
