/// Everything at once. Each header also compiles alone.
#pragma once

#include <surefoot/barycentrics.hpp>
#include <surefoot/bounds.hpp>
#include <surefoot/error.hpp>
#include <surefoot/height_field.hpp>
#include <surefoot/hit.hpp>
#include <surefoot/march.hpp>
#include <surefoot/math.hpp>
#include <surefoot/mesh.hpp>
#include <surefoot/overlap.hpp>
#include <surefoot/pair.hpp>
#include <surefoot/pose.hpp>
#include <surefoot/query.hpp>
#include <surefoot/ray.hpp>
#include <surefoot/shapes.hpp>
#include <surefoot/slab.hpp>
#include <surefoot/source.hpp>
#include <surefoot/sweep.hpp>
#include <surefoot/trace.hpp>
#include <surefoot/version.hpp>
#include <surefoot/visited_source.hpp>
#include <surefoot/voxels.hpp>
#include <surefoot/voxels_move.hpp>
#include <surefoot/world.hpp>
