/// The rules' few words about vectors, for the bots.
#pragma once

#include "game/vectors.hpp"

namespace surefoot::playtest {

using game::dot;
using game::flat;
using game::flat_length;
using game::length;
using game::unit;

}  // namespace surefoot::playtest
