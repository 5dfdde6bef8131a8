/// Sound in a file that every player plays.
#pragma once

#include <span>
#include <string>

#include <surefoot/error.hpp>

namespace surefoot::sound {

/// Writes a .wav of 16 bits; with two channels the samples take turns, left first. Fails with `write_failed`.
[[nodiscard]] Expected<void> write_wav(const std::string& path, std::span<const float> samples, int channels);

}  // namespace surefoot::sound
