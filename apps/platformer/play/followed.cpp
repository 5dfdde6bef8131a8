#include "platformer/play/followed.hpp"

namespace surefoot::platformer {
namespace {

constexpr double degree = 3.14159265358979323846 / 180;

}  // namespace

CameraTarget followed(const game::Game& game, double facing) {
    return target_of(game.hero().body, game.settings(), facing, game.hero().in_water);
}

std::optional<CameraHint> hint_at(const game::Level& level, const dvec3& place) {
    for (const game::CameraHint& hint : level.cameras)
        if (hint.zone.holds(place))
            // From where it looks to which way it looks: the other side.
            return CameraHint{(hint.yaw_deg + 180) * degree, hint.pitch_deg * degree, hint.distance};
    return std::nullopt;
}

}  // namespace surefoot::platformer
