// The writer of a step. docs/capture.md tells the form; parse_step.cpp reads it.
#include <surefoot/capture_step.hpp>

#include "capture/fields_text.hpp"
#include "ieee_guard.hpp"

namespace surefoot {
inline namespace v0 {

using namespace internal;

std::string capture_text(const StepCapture& capture) {
    const IeeeGuard guard;
    Writer w;
    write_origin(w, "surefoot_capture", step_form, capture.origin, capture.note);
    w.word("  \"step\": {\n    \"settings\": ");
    write_fields(w, settings_of(capture), "\n      ");
    w.word(",\n    \"input\": ");
    write_fields(w, capture.input);
    w.word(",\n    \"dt\": ");
    w.number(capture.dt);
    w.word(",\n    \"before\": ");
    write_fields(w, capture.before, "\n      ");
    w.word(",\n    ");
    write_neighbours(w, capture.neighbours, "\n      ");
    w.word("\n  },\n  \"after\": ");
    write_fields(w, capture.after, "\n    ");
    w.word(",\n  \"events\": ");
    write_fields(w, capture.events);
    w.word(",\n");
    write_list(w, "records", capture.records, [](Writer& to, const StepRecord& record) { write_fields(to, record); });
    w.word(",\n");
    write_list(w, "bodies", capture.bodies, write_body);
    w.word(",\n");
    write_list(w, "triangles", capture.triangles, write_triangle);
    w.word("\n}\n");
    return w.take();
}

Expected<void> write_capture(const StepCapture& capture, const std::string& path) {
    return write_text(capture_text(capture), path);
}

}  // namespace v0
}  // namespace surefoot
