// The words in which moments are written as C++.
#include "capture/cpp_words.hpp"

#include <bit>
#include <cmath>

#include "capture/number.hpp"
#include "capture/words.hpp"

namespace surefoot::internal {

namespace {

constexpr std::array<std::string_view, 6> shape_types{"Sphere", "Ellipsoid", "Capsule", "Box", "Cylinder", "Cone"};

}  // namespace

// A literal with the very bits; of a whole number too it is a double.
std::string literal(double value) {
    std::string out;
    if (std::isnan(value)) {
        out = "std::bit_cast<double>(std::uint64_t{0x";
        append_bits(out, std::bit_cast<std::uint64_t>(value));
        return out + "})";
    }
    if (std::isinf(value)) {
        return value > 0 ? "std::numeric_limits<double>::infinity()" : "-std::numeric_limits<double>::infinity()";
    }
    append_shortest(out, value);
    if (out.find_first_of(".e") == out.npos) out += ".0";
    return out;
}

std::string literal(std::uint32_t value) {
    return std::to_string(value) + "u";
}

std::string literal(bool value) {
    return value ? "true" : "false";
}

std::string braced(const dvec3& v) {
    return joined({"{", literal(v.x), ", ", literal(v.y), ", ", literal(v.z), "}"});
}

std::string turned(const dquat& q) {
    return joined({"surefoot::dquat(", literal(q.w), ", ", literal(q.x), ", ", literal(q.y), ", ", literal(q.z), ")"});
}

std::string made(const Shape& shape) {
    const std::size_t index = shape.index();
    const std::array<double, 3> d = dimensions_of(shape);
    const std::string_view type = shape_types[index];
    if (shape_counts[index] == 3) return joined({"surefoot::", type, "{", braced({d[0], d[1], d[2]}), "}"});
    if (shape_counts[index] == 2) return joined({"surefoot::", type, "{", literal(d[0]), ", ", literal(d[1]), "}"});
    return joined({"surefoot::", type, "{", literal(d[0]), "}"});
}

std::string made(const Pose& pose) {
    return joined({"{", braced(pose.position), ", ", turned(pose.orientation), "}"});
}

std::string word_of(Feature feature) {
    return joined({"surefoot::Feature::", feature_words[static_cast<std::size_t>(feature)]});
}

std::string word_of(HitStatus status) {
    return joined({"surefoot::HitStatus::", status_words[static_cast<std::size_t>(status)]});
}

std::string in_a_name(std::string_view text) {
    std::string out;
    for (const char c : text) {
        const bool fits = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
        out += fits ? c : '_';
    }
    return out.empty() || (out.front() >= '0' && out.front() <= '9') ? joined({"moment_", out}) : out;
}

// Comment lines; a backslash at the end of one would swallow the next.
std::string in_comments(std::string_view text) {
    std::string out;
    while (!text.empty()) {
        const std::size_t length = text.find('\n');
        const std::string_view line = text.substr(0, length);
        out += "// ";
        for (const char c : line) out += static_cast<unsigned char>(c) < 0x20 ? ' ' : c == '\\' ? '/' : c;
        out += '\n';
        text.remove_prefix(length == text.npos ? text.size() : length + 1);
    }
    return out;
}

std::string geometry_lines(std::span<const CapturedBody> bodies, std::span<const CapturedTriangle> triangles) {
    std::string out;
    for (const CapturedBody& body : bodies) {
        out += joined({"    moment.bodies.push_back({.body = ", literal(body.body),
                       ",\n                             .start = ", made(body.start),
                       ",\n                             .end = ", made(body.end),
                       ",\n                             .bounds = {", braced(body.bounds.min), ", ",
                       braced(body.bounds.max), "}});\n"});
    }
    if (triangles.empty()) return out;
    // A table: a statement for each of thousands would keep a compiler busy for minutes.
    out += "    static const surefoot::CapturedTriangle triangles[] = {\n";
    for (const CapturedTriangle& one : triangles) {
        const Triangle& t = one.triangle;
        out += joined({"        {{", braced(t.a), ", ", braced(t.b), ", ", braced(t.c), "}, ", literal(one.id), ", ",
                       literal(one.surface), ", ", literal(one.body), "},\n"});
    }
    out += "    };\n    moment.triangles.assign(std::begin(triangles), std::end(triangles));\n";
    return out;
}

std::string test_head(const CaptureOrigin& origin, std::string_view note, std::string_view header) {
    const Version& by = origin.library;
    std::string out = joined({"// A moment saved by Surefoot ", std::to_string(by.major), ".", std::to_string(by.minor),
                              ".", std::to_string(by.patch),
                              ". It expects the answer that was saved: if that is wrong, write the right one.\n"});
    out += in_comments(note);
    out += "#include <bit>\n#include <cstdint>\n#include <gtest/gtest.h>\n#include <iterator>\n#include <limits>\n\n";
    return out + joined({"#include <surefoot/", header, ".hpp>\n\n"});
}

}  // namespace surefoot::internal
