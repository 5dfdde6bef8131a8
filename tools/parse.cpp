#include "parse.hpp"

#include <algorithm>
#include <charconv>
#include <fmt/format.h>
#include <numeric>
#include <vector>

#include "number.hpp"

namespace surefoot::tools {
namespace {

constexpr std::array<ShapeKind, shape_kind_count> kinds{{
    {"ellipsoid", "rx,ry,rz", 3,
     [](const double* d) -> Shape {
         return Ellipsoid{{d[0], d[1], d[2]}};
     }},
    {"sphere", "r", 1, [](const double* d) -> Shape { return Sphere{d[0]}; }},
    {"capsule", "r,half_height", 2,
     [](const double* d) -> Shape {
         return Capsule{d[0], d[1]};
     }},
    {"box", "hx,hy,hz", 3,
     [](const double* d) -> Shape {
         return Box{{d[0], d[1], d[2]}};
     }},
    {"cylinder", "r,half_height", 2,
     [](const double* d) -> Shape {
         return Cylinder{d[0], d[1]};
     }},
    {"cone", "r,height", 2,
     [](const double* d) -> Shape {
         return Cone{d[0], d[1]};
     }},
}};

std::string_view trimmed(std::string_view text) {
    const auto blank = [](char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; };
    while (!text.empty() && blank(text.front())) text.remove_prefix(1);
    while (!text.empty() && blank(text.back())) text.remove_suffix(1);
    return text;
}

/// Numbers with commas between them; fails on the first that is none.
Parsed<std::vector<double>> parse_list(std::string_view text) {
    std::vector<double> numbers;
    for (;;) {
        const std::size_t comma = text.find(',');
        const Parsed<double> number = parse_number(text.substr(0, comma));
        if (!number) return tl::unexpected(number.error());
        numbers.push_back(*number);
        if (comma == std::string_view::npos) return numbers;
        text.remove_prefix(comma + 1);
    }
}

/// How many single-letter changes lead from one word to the other.
std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
            diagonal = row[j];
            row[j] = std::min({replaced, row[j] + 1, row[j - 1] + 1});
        }
    }
    return row[b.size()];
}

}  // namespace

std::span<const ShapeKind, shape_kind_count> shape_kinds() {
    return kinds;
}

const ShapeKind* find_shape_kind(std::string_view name) {
    const auto found =
        std::find_if(kinds.begin(), kinds.end(), [&](const ShapeKind& kind) { return kind.name == name; });
    return found == kinds.end() ? nullptr : &*found;
}

std::string known_shapes() {
    std::string text;
    for (const ShapeKind& kind : kinds)
        text += fmt::format("{}{}:{}", text.empty() ? "" : ", ", kind.name, kind.dimensions);
    return text;
}

Parsed<double> parse_number(std::string_view text) {
    std::string_view digits = trimmed(text);
    if (digits.size() > 1 && digits[0] == '+' && digits[1] != '-') digits.remove_prefix(1);
    double value = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (error == std::errc::result_out_of_range)
        return tl::unexpected(fmt::format("'{}' does not fit in a double", trimmed(text)));
    if (error != std::errc() || end != digits.data() + digits.size() || digits.empty())
        return tl::unexpected(fmt::format("'{}' is not a number", trimmed(text)));
    return value;
}

Parsed<dvec3> parse_vector(std::string_view text) {
    const Parsed<std::vector<double>> list = parse_list(text);
    if (!list) return tl::unexpected(list.error() + ": write three numbers with commas, such as 1,-2.5,3");
    if (list->size() != 3)
        return tl::unexpected(
            fmt::format("'{}' has {} numbers, not 3: write x,y,z, such as 1,-2.5,3", text, list->size()));
    return dvec3((*list)[0], (*list)[1], (*list)[2]);
}

Parsed<dquat> parse_orientation(std::string_view text) {
    const Parsed<std::vector<double>> list = parse_list(text);
    if (!list) return tl::unexpected(list.error() + ": write four numbers with commas, such as 0.7,0,0.7,0");
    if (list->size() != 4)
        return tl::unexpected(fmt::format(
            "'{}' has {} numbers, not 4: write the quaternion w,x,y,z, such as 0.7,0,0.7,0", text, list->size()));
    return dquat((*list)[0], (*list)[1], (*list)[2], (*list)[3]);
}

Parsed<Shape> parse_shape(std::string_view text) {
    const std::size_t colon = text.find(':');
    const std::string_view name = trimmed(text.substr(0, colon));
    const ShapeKind* kind = find_shape_kind(name);
    if (kind == nullptr) {
        std::vector<std::string> names;
        for (const ShapeKind& known : kinds) names.emplace_back(known.name);
        const std::string near = nearest_word(name, names);
        return tl::unexpected(fmt::format("there is no shape '{}'{}; the shapes are {}", name,
                                          near.empty() ? "" : fmt::format(", did you mean '{}'?", near),
                                          known_shapes()));
    }
    const std::string usage = fmt::format("write {}:{}", kind->name, kind->dimensions);
    if (colon == std::string_view::npos) return tl::unexpected(fmt::format("'{}' has no dimensions: {}", text, usage));
    const Parsed<std::vector<double>> list = parse_list(text.substr(colon + 1));
    if (!list) return tl::unexpected(fmt::format("in '{}': {}: {}", text, list.error(), usage));
    if (list->size() != kind->count)
        return tl::unexpected(
            fmt::format("'{}' has {} dimensions, not {}: {}", text, list->size(), kind->count, usage));
    return kind->make(list->data());
}

ShapeParts parts_of(const Shape& shape) {
    struct Take {
        ShapeParts operator()(const Sphere& s) const { return {"sphere", {s.radius}, 1}; }
        ShapeParts operator()(const Ellipsoid& s) const { return {"ellipsoid", {s.radii.x, s.radii.y, s.radii.z}, 3}; }
        ShapeParts operator()(const Capsule& s) const { return {"capsule", {s.radius, s.half_height}, 2}; }
        ShapeParts operator()(const Box& s) const {
            return {"box", {s.half_extents.x, s.half_extents.y, s.half_extents.z}, 3};
        }
        ShapeParts operator()(const Cylinder& s) const { return {"cylinder", {s.radius, s.half_height}, 2}; }
        ShapeParts operator()(const Cone& s) const { return {"cone", {s.radius, s.height}, 2}; }
    };
    return std::visit(Take{}, shape);
}

std::string to_text(const Shape& shape) {
    const ShapeParts parts = parts_of(shape);
    std::string text(parts.name);
    for (std::size_t i = 0; i < parts.count; ++i) {
        text += i == 0 ? ':' : ',';
        append_number(text, parts.dimensions[i]);
    }
    return text;
}

std::string nearest_word(std::string_view word, std::span<const std::string> known) {
    std::string best;
    std::size_t least = word.size() / 3 + 2;
    for (const std::string& candidate : known) {
        const std::size_t distance = edit_distance(word, candidate);
        if (distance < least) {
            least = distance;
            best = candidate;
        }
    }
    return best;
}

}  // namespace surefoot::tools
