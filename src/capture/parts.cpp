#include "capture/parts.hpp"

#include <algorithm>
#include <charconv>

#include "capture/words.hpp"

namespace surefoot::internal {

namespace {

constexpr std::size_t most_triangles = std::size_t{1} << 20U;
constexpr std::size_t most_bodies = std::size_t{1} << 12U;

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

}  // namespace

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

Pose read_pose(JsonReader& in) {
    constexpr std::array<std::string_view, 2> names{"position", "rotate"};
    Pose pose;
    in.object(names, names.size(), [&](std::size_t i) {
        if (i == 0) pose.position = in.vector();
        if (i == 1) pose.orientation = in.turn();
    });
    return pose;
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

std::uint32_t read_format(JsonReader& in, std::uint32_t oldest, std::uint32_t newest) {
    const std::uint32_t format = in.whole_number();
    if (format < oldest) in.fail("no form has this number");
    if (format > newest)
        in.fail("the file is of a newer form than this build reads: replay it with a newer surefoot",
                ErrorCode::unsupported);
    return format;
}

void check_newest(JsonReader& in, std::string_view name, bool is_there, bool is_newest) {
    if (is_there == is_newest) return;
    in.fail(joined({"\"", name, is_there ? "\" means nothing in a file of this form" : "\" is missing"}));
}

void check_bodies_known(JsonReader& in, const std::vector<CapturedTriangle>& triangles,
                        const std::vector<CapturedBody>& bodies) {
    for (const CapturedTriangle& one : triangles) {
        const auto its = std::lower_bound(bodies.begin(), bodies.end(), one.body,
                                          [](const CapturedBody& a, std::uint32_t b) { return a.body < b; });
        const bool known = bodies.empty() ? one.body == 0 : its != bodies.end() && its->body == one.body;
        if (!known) return in.fail("a triangle is of a body that is not in the file");
    }
}

Error error_of(const JsonReader& in, std::string_view file, std::string_view what) {
    const std::string_view name = file.empty() ? "the text" : file;
    return {in.code(), joined({name, ": no ", what, ": byte ", std::to_string(in.byte()), ": ", in.wrong()}),
            std::string(file), in.byte()};
}

}  // namespace surefoot::internal
