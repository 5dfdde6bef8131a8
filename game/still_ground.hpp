/// Which triangles of a level's file neither move nor are drawn only, for tools that know the file as one mesh.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <surefoot/notes.hpp>

namespace surefoot::game {

struct StillGround {
    std::vector<std::uint32_t> others{};  ///< the triangles that are no still ground, ascending
    std::size_t moving = 0;               ///< nodes that move, crumble, open or throw
    std::size_t decor = 0;                ///< nodes that are drawn and not solid

    /// Of a file that no level of the platformer was made from, all is still.
    [[nodiscard]] bool is_all() const { return others.empty(); }
};

/// By the kinds of its nodes, as `read_level` takes them.
[[nodiscard]] StillGround still_ground(const LevelNotes& notes);

}  // namespace surefoot::game
