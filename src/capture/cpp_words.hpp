// The words in which moments are written as C++.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include <surefoot/capture.hpp>

namespace surefoot::internal {

/// A literal with the very bits; of a whole number too it is a double.
[[nodiscard]] std::string literal(double value);
[[nodiscard]] std::string literal(std::uint32_t value);
[[nodiscard]] std::string literal(bool value);

[[nodiscard]] std::string braced(const dvec3& v);
[[nodiscard]] std::string turned(const dquat& q);
[[nodiscard]] std::string made(const Shape& shape);
[[nodiscard]] std::string made(const Pose& pose);
[[nodiscard]] std::string word_of(Feature feature);
[[nodiscard]] std::string word_of(HitStatus status);

/// What C++ does not take in a name becomes `_`.
[[nodiscard]] std::string in_a_name(std::string_view text);

/// What puts bodies and triangles into a `moment`.
[[nodiscard]] std::string geometry_lines(std::span<const CapturedBody> bodies,
                                         std::span<const CapturedTriangle> triangles);

/// Of the file: who saved it, the note, and what it includes; `header` is one of surefoot's own.
[[nodiscard]] std::string test_head(const CaptureOrigin& origin, std::string_view note, std::string_view header);

}  // namespace surefoot::internal
