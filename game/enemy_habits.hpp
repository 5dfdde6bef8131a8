/// How enemies behave, in numbers: the rules go by them, and so does whoever foresees what enemies will do.
#pragma once

#include "game/level.hpp"

namespace surefoot::game {

inline constexpr double notice_time = 0.5;     ///< it shows that it saw somebody before it comes [s]
inline constexpr double stun_time = 1;         ///< after it has hit somebody [s]
inline constexpr double leap_from = 4;         ///< a jumper leaps at who is so near [m]
inline constexpr double leap_speed = 5.5;      ///< over the ground [m/s]
inline constexpr double reload_time = 1.8;     ///< [s]
inline constexpr double bullet_speed = 11;     ///< [m/s]
inline constexpr double bullet_life = 4;       ///< [s]
inline constexpr double bullet_radius = 0.12;  ///< [m]

/// How fast it goes [m/s]; 0 for who stands.
[[nodiscard]] constexpr double enemy_speed(EnemyKind kind, bool hunts) {
    switch (kind) {
        case EnemyKind::chaser:
            return hunts ? 4.6 : 2.5;
        case EnemyKind::patroller:
            return hunts ? 4 : 2;
        case EnemyKind::jumper:
            return hunts ? 4 : 2.5;
        case EnemyKind::shooter:
            break;
    }
    return 0;
}

}  // namespace surefoot::game
