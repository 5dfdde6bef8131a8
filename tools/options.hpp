/// Options that several subcommands share, and how their texts become values.
#pragma once

#include <string>

#include <surefoot/shapes.hpp>

#include "parse.hpp"

// NOLINTNEXTLINE(readability-identifier-naming): CLI11's own
namespace CLI {
class App;  // its header takes seconds to compile
}

namespace surefoot::tools {

/// --shape, --rotate and --one-sided as written; empty where they were not given.
struct VolumeOptions {
    std::string shape;
    std::string rotate;
    bool one_sided = false;

    void add_to(CLI::App& command, bool shape_required);
    [[nodiscard]] bool has_shape() const { return !shape.empty(); }

    /// The values. Throws `Failure` with ExitCode::usage in words.
    [[nodiscard]] Shape shape_value() const;
    [[nodiscard]] dquat rotate_value() const;
    [[nodiscard]] Volume volume() const;  ///< checked against the limits as well
};

/// A position given as an option, checked against the limits; throws `Failure` with ExitCode::usage.
[[nodiscard]] dvec3 position_of(const char* option, const std::string& text);

/// A vector given as an option, finite but otherwise free.
[[nodiscard]] dvec3 vector_of(const char* option, const std::string& text);

}  // namespace surefoot::tools
