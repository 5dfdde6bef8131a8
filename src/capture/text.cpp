// The writer. docs/capture.md tells the form; parse.cpp reads it.
#include <surefoot/capture.hpp>

#include "capture/parts.hpp"
#include "capture/words.hpp"
#include "capture/writer.hpp"
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

void write_question(Writer& w, const CapturedQuestion& q, bool of_a_world) {
    w.word("  \"");
    w.word(kind_words[static_cast<std::size_t>(q.kind)]);
    w.word("\": {\n");
    if (q.kind == CaptureKind::sweep) {
        w.word("    ");
        write_volume(w, q.volume, ",\n    ");
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

}  // namespace

std::string capture_text(const Capture& capture) {
    const IeeeGuard guard;
    Writer w;
    write_origin(w, "surefoot_capture", question_form, capture.origin, capture.note);
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
