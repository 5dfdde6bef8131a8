// Can a height field be made of this? The answer is in words.
#pragma once

#include <surefoot/error.hpp>
#include <surefoot/height_field.hpp>

#include "height_field/samples.hpp"

namespace surefoot::internal {

[[nodiscard]] Expected<void> check_input(const HeightFieldInput& input);
[[nodiscard]] Expected<void> check_patch(const HeightSamples& samples, const HeightFieldPatch& patch);

}  // namespace surefoot::internal
