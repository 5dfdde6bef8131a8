/// The ground of a room, as the navigation overlay asks for it.
#pragma once

#include <memory>
#include <vector>

#include <surefoot/character_settings.hpp>
#include <surefoot/mesh.hpp>
#include <surefoot/pose.hpp>

namespace surefoot::playground {

/// What stands still in a room, who walks on it, and where.
struct NavigationGround {
    struct Piece {
        Mesh mesh;
        Pose pose{};
    };
    std::vector<Piece> pieces;
    CharacterSettings settings{};  ///< its table of surfaces does not count, but `rules`
    std::vector<SurfaceRule> rules{};
    dvec3 start{0, 0, 0};  ///< near where somebody stands; the first path begins there
};

/// Made anew when any of it changes, so that another address is another ground.
using NavigationGroundPointer = std::shared_ptr<const NavigationGround>;

}  // namespace surefoot::playground
