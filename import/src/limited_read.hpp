/// Reading by the helper program, in a child process with limits.
#pragma once

#include <surefoot/import.hpp>

#include "format.hpp"
#include "placement.hpp"
#include "polygon.hpp"

namespace surefoot::internal {

struct LimitedRead {
    std::string path;
    std::string inside{};  ///< which level in the file, if it can hold several
    Format format = Format::glb;
    Placement placement;
    Deadline deadline;
    ImportOptions options;
};

/// For the helper's own limit on processor time: whole seconds, rounded up.
[[nodiscard]] std::string seconds_until(Deadline deadline);

/// Anything but OBJ and current .blend. An error has no file name yet.
[[nodiscard]] Expected<ImportedLevel> read_in_child(const LimitedRead& request);

/// A .blend that needs Blender: exported as .glb into a folder of its own, read from there, and removed.
[[nodiscard]] Expected<ImportedLevel> read_through_blender(const LimitedRead& request);

}  // namespace surefoot::internal
