// The reader of the form that text_step.cpp writes.
#include <surefoot/capture_step.hpp>

#include "capture/fields_text.hpp"
#include "ieee_guard.hpp"
#include "platform/bytes.hpp"

namespace surefoot {
inline namespace v0 {

using namespace internal;

namespace {

constexpr std::size_t most_records = std::size_t{1} << 20U;

constexpr std::size_t most_neighbours_of_a_step = std::size_t{1} << 16U;

// What came with the newest form.
struct Newest {
    std::uint64_t settings = 0;  // a bit for each
    bool neighbours = false;
};

void read_step(JsonReader& in, StepCapture& capture, Newest& newest) {
    constexpr std::array<std::string_view, 5> names{"settings", "input", "dt", "before", "neighbours"};
    FieldReader fields(in, capture.surfaces);
    const auto seen = in.object(names, 4, [&](std::size_t i) {
        if (i == 0) newest.settings = fields.read(capture.settings);
        if (i == 1) fields.read(capture.input);
        if (i == 2) capture.dt = in.number();
        if (i == 3) fields.read(capture.before);
        if (i == 4) fields.read_neighbours(capture.neighbours, most_neighbours_of_a_step);
    });
    newest.neighbours = seen >> 4U != 0;
}

void read_records(JsonReader& in, StepCapture& capture) {
    FieldReader fields(in, capture.surfaces);
    in.array([&] {
        StepRecord record;
        fields.read(record);
        if (capture.records.size() == most_records) in.fail("more records than a step may have", ErrorCode::limit);
        if (in.good()) capture.records.push_back(record);
    });
}

// A step without a world has no bodies; then there are no triangles either.
void read_step_bodies(JsonReader& in, std::vector<CapturedBody>& bodies) {
    if (!in.empty_array()) read_bodies(in, bodies);
}

StepCapture read_whole_step(JsonReader& in) {
    constexpr std::array<std::string_view, 10> names{
        "surefoot_capture", "library", "abi", "note", "step", "after", "events", "records", "bodies", "triangles"};
    StepCapture capture;
    Newest newest;
    FieldReader fields(in, capture.surfaces);
    in.object(names, names.size(), [&](std::size_t i) {
        if (i == 0) capture.origin.format = read_format(in, first_step_form, step_form);
        if (i == 1) capture.origin.library = read_version(in);
        if (i == 2) capture.origin.abi = in.text();
        if (i == 3) capture.note = in.text();
        if (i == 4) read_step(in, capture, newest);
        if (i == 5) fields.read(capture.after);
        if (i == 6) fields.read(capture.events);
        if (i == 7) read_records(in, capture);
        if (i == 8) read_step_bodies(in, capture.bodies);
        if (i == 9) read_triangles(in, capture.triangles);
    });
    in.end();
    const bool is_newest = capture.origin.format == step_form;
    if (in.good()) check_newest_settings(in, newest.settings, is_newest);
    if (in.good()) check_newest(in, "neighbours", newest.neighbours, is_newest);
    if (in.good() && capture.bodies.empty() && !capture.triangles.empty()) {
        in.fail("a triangle is of a body that is not in the file");
    }
    if (in.good()) check_bodies_known(in, capture.triangles, capture.bodies);
    return capture;
}

}  // namespace

Expected<StepCapture> parse_step_capture(std::string_view text, std::string_view file) {
    const IeeeGuard guard;
    JsonReader in(text);
    StepCapture capture = read_whole_step(in);
    if (in.good()) return capture;
    return tl::unexpected(error_of(in, file, "step"));
}

Expected<StepCapture> read_step_capture(const std::string& path) {
    const auto owned = OwnedBytes::read(path);
    if (!owned) return tl::unexpected(owned.error());
    const auto bytes = owned->bytes();
    return parse_step_capture({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, path);
}

}  // namespace v0
}  // namespace surefoot
