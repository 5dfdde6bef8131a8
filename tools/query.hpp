/// A sweep as it is asked and answered in text: one line of JSON in, one line of JSON out.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include <surefoot/hit.hpp>
#include <surefoot/math.hpp>
#include <surefoot/shapes.hpp>

#include "parse.hpp"

namespace surefoot::tools {

struct SweepQuery {
    Volume volume;
    Motion motion;
    bool one_sided = false;
};

/// What a line of a batch means where it says nothing itself.
struct QueryDefaults {
    std::optional<Shape> shape;
    dquat rotate{1, 0, 0, 0};
    bool one_sided = false;
};

/// What is outside the limits of a query, in a sentence; nothing if all is well. Vectors are named as the caller knows
/// them ("from", "--at").
[[nodiscard]] std::optional<std::string> complaint(const Volume& volume);
[[nodiscard]] std::optional<std::string> complaint(std::string_view name, const dvec3& position);

/// Reads {"shape":{"ellipsoid":[rx,ry,rz]},"from":[x,y,z],"to":[x,y,z]} with optional "rotate":[w,x,y,z] and
/// "one_sided":true. An unknown or repeated name is an error, so that a spelling mistake cannot change the question.
[[nodiscard]] Parsed<SweepQuery> parse_query(std::string_view line, const QueryDefaults& defaults);

[[nodiscard]] std::string_view word(Feature feature);

/// {"hit":true,...} or {"hit":false}, without the end of the line.
void append_answer(std::string& out, const std::optional<Hit>& hit);

/// {"error":"line N: what"}, without the end of the line.
void append_error(std::string& out, std::uint64_t line, std::string_view what);

/// `text` as a JSON string, quotes included; bytes that are not UTF-8 become question marks.
[[nodiscard]] std::string json_string(std::string_view text);

}  // namespace surefoot::tools
