// Which ground is too near to something that the agent's width meets.
#pragma once

#include <Recast.h>

namespace surefoot::navigation {

/// Takes away the ground in the middle of a rise of more than `climb` cells within `depth` [m]. Cells hold the highest
/// of what lies in them, so that stairs of treads too narrow for feet, and short steep banks, look like steps to climb.
void bar_banks(rcCompactHeightfield& ground, int climb, double depth);

/// Takes away the ground from which a wall is nearer than `radius` cells, and the outermost cells at drops.
///
/// Recast's own erosion keeps the agent's whole width away from drops, too; feet do not: a character stands on an edge,
/// and walks along beams that are narrower than itself. A cell's missing neighbour is a wall if something solid is
/// there between the highest step and the head, and a drop otherwise.
/// `climb` and `height` are in cells.
void keep_clear(rcHeightfield& solid, rcCompactHeightfield& ground, int radius, int climb, int height);

}  // namespace surefoot::navigation
