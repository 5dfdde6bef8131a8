/// What `surefoot replay` does with files that hold more than a question.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include <surefoot/capture_session.hpp>
#include <surefoot/capture_step.hpp>

#include "command.hpp"
#include "level.hpp"

namespace surefoot::tools {

/// "0.1.0".
[[nodiscard]] std::string version_text(const Version& version);

/// A step that was made again, told in words or as a line of JSON.
[[nodiscard]] std::string step_report(const std::string& file, const StepCapture& capture, const StepReplay& again);
[[nodiscard]] std::string step_json(const std::string& file, const StepCapture& capture, const StepReplay& again);

/// What to do with a session.
struct SessionOptions {
    LevelOptions level;
    std::optional<std::size_t> tick;  ///< to tell about; by default the first that differs
    std::string save;                 ///< where to save that tick's step; nowhere if empty
    bool json = false;
};

/// Plays a session and prints what came of it.
[[nodiscard]] ExitCode run_session(const std::string& file, const Session& session, const SessionOptions& given);

}  // namespace surefoot::tools
