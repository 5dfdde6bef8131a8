// The pictures, by the page they belong to.
#pragma once

#include <span>

#include "canvas.hpp"

namespace pictures {

std::span<const Picture> memory_pictures();  // docs/memory.md

}  // namespace pictures
