// The pictures, by the page they belong to.
#pragma once

#include <span>

#include "canvas.hpp"

namespace pictures {

std::span<const Picture> memory_pictures();      // docs/memory.md
std::span<const Picture> navigation_pictures();  // docs/navigation.md
std::span<const Picture> question_pictures();    // docs/method.md: the question, and what an answer needs
std::span<const Picture> method_pictures();      // docs/method.md: the closed forms
std::span<const Picture> shape_pictures();       // docs/method.md: shape by shape

}  // namespace pictures
