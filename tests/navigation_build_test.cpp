#include "navigation_scene.hpp"
