// The parts that several forms of files share, read.
#pragma once

#include <string>
#include <vector>

#include <surefoot/capture.hpp>

#include "capture/reader.hpp"

namespace surefoot::internal {

[[nodiscard]] Shape read_shape(JsonReader& in);
[[nodiscard]] Pose read_pose(JsonReader& in);
void read_bodies(JsonReader& in, std::vector<CapturedBody>& bodies);
void read_triangles(JsonReader& in, std::vector<CapturedTriangle>& triangles);
[[nodiscard]] Version read_version(JsonReader& in);

/// Questions have not changed since the first form; steps came with the second, and their neighbours with the third.
inline constexpr std::uint32_t question_form = 1;
inline constexpr std::uint32_t first_step_form = 2;
inline constexpr std::uint32_t step_form = 3;
inline constexpr std::uint32_t first_session_form = 1;  ///< of a file of its own kind
inline constexpr std::uint32_t session_form = 2;        ///< since ticks have neighbours

/// The number of the file's form, which is to be one of these.
[[nodiscard]] std::uint32_t read_format(JsonReader& in, std::uint32_t oldest, std::uint32_t newest);

/// Fails unless a member that came with the newest form is in a file of that form, or missing in one of an older form.
void check_newest(JsonReader& in, std::string_view name, bool is_there, bool is_newest);

/// Fails unless each triangle is of a body that is there, or of body 0 if there are none.
void check_bodies_known(JsonReader& in, const std::vector<CapturedTriangle>& triangles,
                        const std::vector<CapturedBody>& bodies);

/// What is wrong, for the caller: "FILE: no WHAT: byte 12: ...".
[[nodiscard]] Error error_of(const JsonReader& in, std::string_view file, std::string_view what);

}  // namespace surefoot::internal
