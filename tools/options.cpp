#include "options.hpp"

#include <CLI/CLI.hpp>
#include <cmath>
#include <fmt/format.h>

#include "command.hpp"
#include "query.hpp"

namespace surefoot::tools {
namespace {

template <typename T>
T value_or_fail(const char* option, const Parsed<T>& parsed) {
    if (!parsed) throw Failure{ExitCode::usage, fmt::format("{}: {}", option, parsed.error())};
    return *parsed;
}

}  // namespace

void VolumeOptions::add_to(CLI::App& command, bool shape_required) {
    auto* option =
        command.add_option("--shape", shape, "What moves: " + known_shapes() + " [m]")->type_name("KIND:SIZES");
    if (shape_required) option->required();
    command.add_option("--rotate", rotate, "How it is turned: a quaternion of any length (default: upright)")
        ->type_name("W,X,Y,Z");
    command.add_flag("--one-sided", one_sided, "Triangles exist from their front only");
}

Shape VolumeOptions::shape_value() const {
    return value_or_fail("--shape", parse_shape(shape));
}

dquat VolumeOptions::rotate_value() const {
    return rotate.empty() ? dquat(1, 0, 0, 0) : value_or_fail("--rotate", parse_orientation(rotate));
}

Volume VolumeOptions::volume() const {
    const Volume result(shape_value(), rotate_value());
    if (const auto wrong = complaint(result)) throw Failure{ExitCode::usage, "--shape/--rotate: " + *wrong};
    return result;
}

dvec3 position_of(const char* option, const std::string& text) {
    const dvec3 position = value_or_fail(option, parse_vector(text));
    if (const auto wrong = complaint(option, position)) throw Failure{ExitCode::usage, *wrong};
    return position;
}

dvec3 vector_of(const char* option, const std::string& text) {
    const dvec3 v = value_or_fail(option, parse_vector(text));
    if (!std::isfinite(v.x) || !std::isfinite(v.y) || !std::isfinite(v.z))
        throw Failure{ExitCode::usage, fmt::format("{}: '{}' is not finite", option, text)};
    return v;
}

}  // namespace surefoot::tools
