#include "game/still_ground.hpp"

#include <algorithm>

#include "game/level.hpp"

namespace surefoot::game {

StillGround still_ground(const LevelNotes& notes) {
    StillGround found;
    std::vector<bool> taken(notes.parts.size(), false);
    for (const Marker& marker : notes.markers) {
        const bool is_decor = marker.kind == decor_kind;
        if (!is_decor && !body_kind(marker.kind)) continue;
        bool has_triangles = false;
        for (std::size_t i = 0; i < notes.parts.size(); ++i) {
            const Part& part = notes.parts[i];
            if (taken[i] || part.name != marker.name) continue;
            taken[i] = true;
            has_triangles = true;
            for (std::uint32_t k = 0; k < part.triangle_count; ++k) found.others.push_back(part.first_triangle + k);
        }
        if (has_triangles) ++(is_decor ? found.decor : found.moving);
    }
    std::ranges::sort(found.others);
    return found;
}

}  // namespace surefoot::game
