#include "game/level.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include <surefoot/pose.hpp>

namespace surefoot::game {

bool Zone::holds(const dvec3& place) const {
    const dvec3 inside = to_body({middle, orientation}, place);
    return std::abs(inside.x) <= half.x && std::abs(inside.y) <= half.y && std::abs(inside.z) <= half.z;
}

int Level::count(PickupKind kind) const {
    return int(std::ranges::count(pickups, kind, &PickupPlan::kind));
}

Medal Level::medal(double seconds) const {
    if (seconds <= medals.gold) return Medal::gold;
    if (seconds <= medals.silver) return Medal::silver;
    if (seconds <= medals.bronze) return Medal::bronze;
    return Medal::none;
}

std::vector<std::string> levels_in(const std::string& folder) {
    namespace fs = std::filesystem;
    std::vector<std::string> found;
    std::error_code error;
    for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error))
        if (at->path().extension() == ".glb") found.push_back(at->path().string());
    std::ranges::sort(found);
    return found;
}

}  // namespace surefoot::game
