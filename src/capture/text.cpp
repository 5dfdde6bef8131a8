// The writer. docs/capture.md tells the form; parse.cpp reads it.
#include <bit>
#include <cmath>

#include <surefoot/capture.hpp>

#include "capture/number.hpp"
#include "capture/words.hpp"
#include "ieee_guard.hpp"
#include "overloaded.hpp"

namespace surefoot {

namespace internal {

std::array<double, 3> dimensions_of(const Shape& shape) noexcept {
    using Three = std::array<double, 3>;
    return std::visit(Overloaded{[](const Sphere& s) {
                                     return Three{s.radius, 0, 0};
                                 },
                                 [](const Ellipsoid& s) {
                                     return Three{s.radii.x, s.radii.y, s.radii.z};
                                 },
                                 [](const Capsule& s) {
                                     return Three{s.radius, s.half_height, 0};
                                 },
                                 [](const Box& s) {
                                     return Three{s.half_extents.x, s.half_extents.y, s.half_extents.z};
                                 },
                                 [](const Cylinder& s) {
                                     return Three{s.radius, s.half_height, 0};
                                 },
                                 [](const Cone& s) {
                                     return Three{s.radius, s.height, 0};
                                 }},
                      shape);
}

Shape shape_from(std::size_t index, const std::array<double, 3>& d) noexcept {
    switch (index) {
        case 0:
            return Sphere{d[0]};
        case 1:
            return Ellipsoid{{d[0], d[1], d[2]}};
        case 2:
            return Capsule{d[0], d[1]};
        case 3:
            return Box{{d[0], d[1], d[2]}};
        case 4:
            return Cylinder{d[0], d[1]};
        default:
            return Cone{d[0], d[1]};
    }
}

}  // namespace internal

inline namespace v0 {

using namespace internal;

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

class Writer {
public:
    [[nodiscard]] std::string take() { return std::move(out_); }
    void word(std::string_view text) { out_ += text; }
    void number(std::uint32_t value) { append_shortest(out_, value); }
    void number(double value) {
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
    template <typename... Numbers>
    void list(double first, Numbers... rest) {
        out_ += '[';
        number(first);
        ((out_ += ", ", number(rest)), ...);
        out_ += ']';
    }
    void list(const dvec3& v) { list(v.x, v.y, v.z); }
    void list(const dquat& q) { list(q.w, q.x, q.y, q.z); }
    void yes(bool value) { out_ += value ? "true" : "false"; }
    /// In quotes. What is no UTF-8 becomes question marks, so that the file is JSON for everyone.
    void text(std::string_view text) {
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

private:
    std::string out_;
};

void write_question(Writer& w, const CapturedQuestion& q, bool of_a_world) {
    w.word("  \"");
    w.word(kind_words[static_cast<std::size_t>(q.kind)]);
    w.word("\": {\n");
    if (q.kind == CaptureKind::sweep) {
        const std::size_t index = q.volume.shape.index();
        const std::array<double, 3> d = dimensions_of(q.volume.shape);
        w.word("    \"shape\": {\"");
        w.word(shape_words[index]);
        w.word("\": ");
        if (shape_counts[index] == 1) w.list(d[0]);
        if (shape_counts[index] == 2) w.list(d[0], d[1]);
        if (shape_counts[index] == 3) w.list(d[0], d[1], d[2]);
        w.word("},\n    \"rotate\": ");
        w.list(q.volume.orientation);
        w.word(",\n");
    }
    w.word("    \"from\": ");
    w.list(q.motion.from);
    w.word(",\n    \"to\": ");
    w.list(q.motion.to);
    w.word(",\n    \"one_sided\": ");
    w.yes(q.one_sided);
    if (of_a_world) {
        w.word(",\n    \"begin\": ");
        w.number(q.begin);
        w.word(",\n    \"end\": ");
        w.number(q.end);
        w.word(",\n    \"turn_gap\": ");
        w.number(q.turn_gap);
    }
    w.word("\n  },\n");
}

void write_answer(Writer& w, const std::optional<Hit>& hit) {
    w.word("  \"answer\": ");
    if (!hit) return w.word("null,\n");
    w.word("{\n    \"t\": ");
    w.number(hit->t);
    w.word(",\n    \"point\": ");
    w.list(hit->point);
    w.word(",\n    \"normal\": ");
    w.list(hit->normal);
    w.word(",\n    \"feature\": \"");
    w.word(feature_words[static_cast<std::size_t>(hit->feature)]);
    w.word("\",\n    \"triangle\": ");
    w.number(hit->triangle);
    w.word(",\n    \"surface\": ");
    w.number(hit->surface);
    w.word(",\n    \"body\": ");
    w.number(hit->body);
    w.word(",\n    \"status\": \"");
    w.word(status_words[static_cast<std::size_t>(hit->status)]);
    w.word("\",\n    \"started_inside\": ");
    w.yes(hit->started_inside);
    w.word("\n  },\n");
}

void write_pose(Writer& w, const Pose& pose) {
    w.word("{\"position\": ");
    w.list(pose.position);
    w.word(", \"rotate\": ");
    w.list(pose.orientation);
    w.word("}");
}

void write_body(Writer& w, const CapturedBody& body) {
    w.word("{\"body\": ");
    w.number(body.body);
    w.word(", \"start\": ");
    write_pose(w, body.start);
    w.word(", \"end\": ");
    write_pose(w, body.end);
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

/// One a line.
template <typename T>
void write_list(Writer& w, std::string_view name, const std::vector<T>& list, void (*write)(Writer&, const T&)) {
    w.word("  \"");
    w.word(name);
    w.word("\": [");
    for (const T& one : list) {
        w.word(&one == list.data() ? "\n    " : ",\n    ");
        write(w, one);
    }
    w.word(list.empty() ? "]" : "\n  ]");
}

}  // namespace

std::string capture_text(const Capture& capture) {
    const IeeeGuard guard;
    Writer w;
    w.word("{\n  \"surefoot_capture\": ");
    w.number(capture_format);
    const Version& library = capture.origin.library;
    w.word(",\n  \"library\": \"");
    w.number(static_cast<std::uint32_t>(library.major));
    w.word(".");
    w.number(static_cast<std::uint32_t>(library.minor));
    w.word(".");
    w.number(static_cast<std::uint32_t>(library.patch));
    w.word("\",\n  \"abi\": ");
    w.text(capture.origin.abi);
    w.word(",\n  \"note\": ");
    w.text(capture.note);
    w.word(",\n");
    write_question(w, capture.question, !capture.bodies.empty());
    write_answer(w, capture.answer);
    if (!capture.bodies.empty()) {
        write_list(w, "bodies", capture.bodies, write_body);
        w.word(",\n");
    }
    write_list(w, "triangles", capture.triangles, write_triangle);
    w.word("\n}\n");
    return w.take();
}

}  // namespace v0
}  // namespace surefoot
