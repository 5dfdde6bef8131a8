/// Reading what people write on a command line: numbers, vectors, shapes. Every complaint says what to write instead.
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <tl/expected.hpp>

#include <surefoot/math.hpp>
#include <surefoot/shapes.hpp>

namespace surefoot::tools {

/// A value, or a sentence that says what is wrong and how to write it.
template <typename T>
using Parsed = tl::expected<T, std::string>;

/// One of the shapes: its name, the names of its dimensions in order, and how to make it of them.
struct ShapeKind {
    std::string_view name;
    std::string_view dimensions;  ///< "rx,ry,rz"
    std::size_t count;            ///< how many dimensions
    Shape (*make)(const double* dimensions);
};

inline constexpr std::size_t shape_kind_count = 6;

/// All shapes, in the order in which they are listed to people.
[[nodiscard]] std::span<const ShapeKind, shape_kind_count> shape_kinds();

/// The kind with this name, or null.
[[nodiscard]] const ShapeKind* find_shape_kind(std::string_view name);

/// "ellipsoid:rx,ry,rz, sphere:r, ..." for messages and help.
[[nodiscard]] std::string known_shapes();

/// A decimal number, correctly rounded, whatever the locale. Infinity and NaN are read: a query judges them.
[[nodiscard]] Parsed<double> parse_number(std::string_view text);

/// "x,y,z", in metres.
[[nodiscard]] Parsed<dvec3> parse_vector(std::string_view text);

/// "w,x,y,z", of any length.
[[nodiscard]] Parsed<dquat> parse_orientation(std::string_view text);

/// "ellipsoid:0.4,0.9,0.4" and the like.
[[nodiscard]] Parsed<Shape> parse_shape(std::string_view text);

/// The shape as `parse_shape` reads it.
[[nodiscard]] std::string to_text(const Shape& shape);

/// The name and the dimensions of a shape, in the order of its kind.
struct ShapeParts {
    std::string_view name;
    std::array<double, 3> dimensions{};
    std::size_t count = 0;
};

[[nodiscard]] ShapeParts parts_of(const Shape& shape);

/// The words of `known` that come nearest to `word`, nearest first; none if nothing is near.
[[nodiscard]] std::string nearest_word(std::string_view word, std::span<const std::string> known);

}  // namespace surefoot::tools
