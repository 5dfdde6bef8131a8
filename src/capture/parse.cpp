// The reader of the form that text.cpp writes.
#include <algorithm>
#include <charconv>

#include <surefoot/capture.hpp>

#include "capture/reader.hpp"
#include "capture/words.hpp"
#include "ieee_guard.hpp"

namespace surefoot {
inline namespace v0 {

using namespace internal;

namespace {

using Names = std::span<const std::string_view>;

constexpr std::size_t most_triangles = std::size_t{1} << 20U;
constexpr std::size_t most_bodies = std::size_t{1} << 12U;

Shape read_shape(JsonReader& in) {
    Shape shape;
    std::size_t count = 0;
    in.object(shape_words, 0, [&](std::size_t index) {
        std::array<double, 3> dimensions{};
        in.numbers(std::span(dimensions).first(shape_counts[index]));
        shape = shape_from(index, dimensions);
        ++count;
    });
    if (count != 1) in.fail("\"shape\" must be an object with one shape");
    return shape;
}

constexpr std::array<std::string_view, 8> sweep_names{"from",   "to",    "one_sided", "shape",
                                                      "rotate", "begin", "end",       "turn_gap"};
constexpr std::array<std::string_view, 6> ray_names{"from", "to", "one_sided", "begin", "end", "turn_gap"};

// True if it tells the times of a world's tick.
bool read_question(JsonReader& in, CapturedQuestion& q) {
    const bool is_ray = q.kind == CaptureKind::ray;
    const std::size_t required = is_ray ? 3 : 5;
    const std::uint32_t seen = in.object(is_ray ? Names(ray_names) : Names(sweep_names), required, [&](std::size_t i) {
        if (i >= 3 && is_ray) i += 2;
        switch (i) {
            case 0:
                q.motion.from = in.vector();
                break;
            case 1:
                q.motion.to = in.vector();
                break;
            case 2:
                q.one_sided = in.yes();
                break;
            case 3:
                q.volume.shape = read_shape(in);
                break;
            case 4:
                q.volume.orientation = in.turn();
                break;
            case 5:
                q.begin = in.number();
                break;
            case 6:
                q.end = in.number();
                break;
            default:
                q.turn_gap = in.number();
        }
    });
    const std::uint32_t times = seen >> required;
    if (times != 0 && times != 7) in.fail("\"begin\", \"end\" and \"turn_gap\" stand together");
    return times != 0;
}

Hit read_hit(JsonReader& in) {
    constexpr std::array<std::string_view, 9> names{"t",       "point", "normal", "feature",       "triangle",
                                                    "surface", "body",  "status", "started_inside"};
    Hit hit;
    in.object(names, names.size(), [&](std::size_t i) {
        switch (i) {
            case 0:
                hit.t = in.number();
                break;
            case 1:
                hit.point = in.vector();
                break;
            case 2:
                hit.normal = in.vector();
                break;
            case 3:
                hit.feature = static_cast<Feature>(in.one_of(feature_words));
                break;
            case 4:
                hit.triangle = in.whole_number();
                break;
            case 5:
                hit.surface = in.whole_number();
                break;
            case 6:
                hit.body = in.whole_number();
                break;
            case 7:
                hit.status = static_cast<HitStatus>(in.one_of(status_words));
                break;
            default:
                hit.started_inside = in.yes();
        }
    });
    return hit;
}

Pose read_pose(JsonReader& in) {
    constexpr std::array<std::string_view, 2> names{"position", "rotate"};
    Pose pose;
    in.object(names, names.size(), [&](std::size_t i) {
        if (i == 0) pose.position = in.vector();
        if (i == 1) pose.orientation = in.turn();
    });
    return pose;
}

CapturedBody read_body(JsonReader& in) {
    constexpr std::array<std::string_view, 5> names{"body", "start", "end", "min", "max"};
    CapturedBody body;
    in.object(names, names.size(), [&](std::size_t i) {
        if (i == 0) body.body = in.whole_number();
        if (i == 1) body.start = read_pose(in);
        if (i == 2) body.end = read_pose(in);
        if (i == 3) body.bounds.min = in.vector();
        if (i == 4) body.bounds.max = in.vector();
    });
    return body;
}

CapturedTriangle read_triangle(JsonReader& in) {
    constexpr std::array<std::string_view, 6> names{"body", "id", "surface", "a", "b", "c"};
    CapturedTriangle one;
    in.object(names, names.size(), [&](std::size_t i) {
        if (i == 0) one.body = in.whole_number();
        if (i == 1) one.id = in.whole_number();
        if (i == 2) one.surface = in.whole_number();
        if (i == 3) one.triangle.a = in.vector();
        if (i == 4) one.triangle.b = in.vector();
        if (i == 5) one.triangle.c = in.vector();
    });
    return one;
}

void read_bodies(JsonReader& in, std::vector<CapturedBody>& bodies) {
    in.array([&] {
        const CapturedBody body = read_body(in);
        if (!bodies.empty() && body.body <= bodies.back().body)
            in.fail("bodies must stand in the order of their numbers");
        if (bodies.size() == most_bodies) in.fail("more bodies than a capture may have", ErrorCode::limit);
        if (in.good()) bodies.push_back(body);
    });
    if (bodies.empty()) in.fail("\"bodies\" must not be empty: leave it out if one source was asked");
}

void read_triangles(JsonReader& in, std::vector<CapturedTriangle>& triangles) {
    in.array([&] {
        const CapturedTriangle one = read_triangle(in);
        if (!triangles.empty()) {
            const CapturedTriangle& last = triangles.back();
            if (std::pair(one.body, one.id) <= std::pair(last.body, last.id))
                in.fail("triangles must stand in the order of (body, id)");
        }
        if (triangles.size() == most_triangles) in.fail("more triangles than a capture may have", ErrorCode::limit);
        if (in.good()) triangles.push_back(one);
    });
}

Version read_version(JsonReader& in) {
    const std::string text = in.text();
    Version version;
    const char* at = text.data();
    const char* const last = at + text.size();
    for (int* const part : {&version.major, &version.minor, &version.patch}) {
        const bool needs_dot = part != &version.major;
        const bool has_dot = needs_dot && at != last && *at == '.';
        std::uint16_t number = 0;  // an unsigned one takes no sign
        const auto read = std::from_chars(at + (has_dot ? 1 : 0), last, number);
        if (needs_dot != has_dot || read.ec != std::errc()) in.fail("a version, such as \"1.2.3\", must be here");
        *part = number;
        at = read.ptr;
    }
    if (at != last) in.fail("a version, such as \"1.2.3\", must be here");
    return version;
}

std::uint32_t read_format(JsonReader& in) {
    const std::uint32_t format = in.whole_number();
    if (format == 0) in.fail("no form has this number");
    if (format > capture_format)
        in.fail("the file is of a newer form than this build reads: replay it with a newer surefoot",
                ErrorCode::unsupported);
    return format;
}

void check_whole(JsonReader& in, const Capture& capture, bool has_times) {
    if (has_times != !capture.bodies.empty())
        in.fail("\"bodies\" and the times of their tick, \"begin\", \"end\" and \"turn_gap\", stand together");
    for (const CapturedTriangle& one : capture.triangles) {
        const auto its = std::lower_bound(capture.bodies.begin(), capture.bodies.end(), one.body,
                                          [](const CapturedBody& a, std::uint32_t b) { return a.body < b; });
        const bool known =
            capture.bodies.empty() ? one.body == 0 : its != capture.bodies.end() && its->body == one.body;
        if (!known) return in.fail("a triangle is of a body that is not in the file");
    }
}

Capture read_whole(JsonReader& in) {
    // The questions are members by the name of their kind; a later kind of moment is another member here.
    constexpr std::array<std::string_view, 9> names{"surefoot_capture", "library",     "abi",         "note",  "answer",
                                                    "triangles",        kind_words[0], kind_words[1], "bodies"};
    Capture capture;
    bool has_times = false;
    const std::uint32_t seen = in.object(names, 6, [&](std::size_t i) {
        switch (i) {
            case 0:
                capture.origin.format = read_format(in);
                break;
            case 1:
                capture.origin.library = read_version(in);
                break;
            case 2:
                capture.origin.abi = in.text();
                break;
            case 3:
                capture.note = in.text();
                break;
            case 4:
                if (!in.null()) capture.answer = read_hit(in);
                break;
            case 5:
                read_triangles(in, capture.triangles);
                break;
            case 6:
            case 7:
                capture.question.kind = static_cast<CaptureKind>(i - 6);
                has_times = read_question(in, capture.question);
                break;
            default:
                read_bodies(in, capture.bodies);
        }
    });
    const std::uint32_t questions = seen >> 6U & 3U;
    if (questions != 1 && questions != 2) in.fail("one question, \"sweep\" or \"ray\", must be in the file");
    in.end();
    if (in.good()) check_whole(in, capture, has_times);
    return capture;
}

}  // namespace

Expected<Capture> parse_capture(std::string_view text, std::string_view file) {
    const IeeeGuard guard;
    JsonReader in(text);
    Capture capture = read_whole(in);
    if (in.good()) return capture;
    const std::string name(file.empty() ? "the text" : file);
    return tl::unexpected(Error{in.code(),
                                joined({name, ": no capture: byte ", std::to_string(in.byte()), ": ", in.wrong()}),
                                std::string(file), in.byte()});
}

}  // namespace v0
}  // namespace surefoot
