// What things are called, where a person reads it.
#include "game/event.hpp"
#include "game/level.hpp"

namespace surefoot::game {

std::string_view name_of(EnemyKind kind) {
    switch (kind) {
        case EnemyKind::chaser:
            return "chaser";
        case EnemyKind::patroller:
            return "patroller";
        case EnemyKind::jumper:
            return "jumper";
        case EnemyKind::shooter:
            return "shooter";
    }
    return {};
}

std::string_view name_of(BodyKind kind) {
    switch (kind) {
        case BodyKind::platform:
            return "platform";
        case BodyKind::turntable:
            return "turntable";
        case BodyKind::crumble:
            return "crumble";
        case BodyKind::door:
            return "door";
        case BodyKind::bounce:
            return "bounce";
        case BodyKind::hazard:
            return "hazard";
    }
    return {};
}

std::optional<BodyKind> body_kind(std::string_view kind) {
    for (const auto known : {BodyKind::platform, BodyKind::turntable, BodyKind::crumble, BodyKind::door,
                             BodyKind::bounce, BodyKind::hazard})
        if (name_of(known) == kind) return known;
    return std::nullopt;
}

std::string_view name_of(PickupKind kind) {
    switch (kind) {
        case PickupKind::coin:
            return "coin";
        case PickupKind::star:
            return "star";
        case PickupKind::heart:
            return "heart";
        case PickupKind::key:
            return "key";
    }
    return {};
}

std::string_view name_of(Medal medal) {
    switch (medal) {
        case Medal::none:
            return "none";
        case Medal::bronze:
            return "bronze";
        case Medal::silver:
            return "silver";
        case Medal::gold:
            return "gold";
    }
    return {};
}

std::string_view name_of(Manoeuvre how) {
    switch (how) {
        case Manoeuvre::ride:
            return "ride";
        case Manoeuvre::wall_jump:
            return "wall_jump";
        case Manoeuvre::dash:
            return "dash";
        case Manoeuvre::bounce:
            return "bounce";
        case Manoeuvre::swim:
            return "swim";
        case Manoeuvre::climb:
            return "climb";
        case Manoeuvre::crouch:
            return "crouch";
    }
    return {};
}

std::string_view name_of(Happening what) {
    switch (what) {
        case Happening::jumped:
            return "jumped";
        case Happening::air_jumped:
            return "jumped in the air";
        case Happening::wall_jumped:
            return "jumped off a wall";
        case Happening::dashed:
            return "dashed";
        case Happening::landed:
            return "landed";
        case Happening::grabbed_ledge:
            return "grabbed a ledge";
        case Happening::climbed:
            return "climbed up";
        case Happening::splashed_in:
            return "went under water";
        case Happening::splashed_out:
            return "came out of the water";
        case Happening::bounced:
            return "bounced";
        case Happening::took_coin:
            return "took a coin";
        case Happening::took_star:
            return "took a star";
        case Happening::took_heart:
            return "took a heart";
        case Happening::took_key:
            return "took a key";
        case Happening::door_opened:
            return "a door opened";
        case Happening::checkpoint:
            return "reached a checkpoint";
        case Happening::crumbling:
            return "ground began to crumble";
        case Happening::crumbled:
            return "ground crumbled";
        case Happening::crumble_back:
            return "crumbled ground came back";
        case Happening::hurt:
            return "was hurt";
        case Happening::fell:
            return "fell";
        case Happening::respawned:
            return "went back to the checkpoint";
        case Happening::stomped:
            return "stomped an enemy";
        case Happening::enemy_noticed:
            return "was noticed";
        case Happening::enemy_jumped:
            return "an enemy jumped";
        case Happening::shot:
            return "was shot at";
        case Happening::shot_gone:
            return "a shot hit a wall";
        case Happening::won:
            return "won";
        case Happening::lost:
            return "lost";
    }
    return {};
}

std::string_view sentence(Cause cause) {
    switch (cause) {
        case Cause::none:
            return "";
        case Cause::fall:
            return "fell out of the level";
        case Cause::deadly:
            return "touched something deadly";
        case Cause::hazard:
            return "was hit by something that moves";
        case Cause::crushed:
            return "was crushed";
        case Cause::chaser:
            return "was caught by a chaser";
        case Cause::patroller:
            return "was caught by a patroller";
        case Cause::jumper:
            return "was caught by a jumper";
        case Cause::shot:
            return "was shot";
        case Cause::time:
            return "ran out of time";
        case Cause::gave_up:
            return "gave up";
    }
    return {};
}

}  // namespace surefoot::game
