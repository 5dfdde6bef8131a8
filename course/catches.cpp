// Which of the deliberately broken movers do not clear which scene, the fault that the scene is about first. The
// textbook mover that the faults are put into is not good at everything itself; where it fails, so do most of them.
#include "course/catches.hpp"

#include <algorithm>
#include <string_view>

#include "course/mover.hpp"

namespace surefoot::course {
namespace {

struct Catch {
    std::string_view scene;
    std::string_view faults;  // after "broken-", with blanks between; "all" for the rest of them but any-slope
};

constexpr Catch catches[] = {
    {"floor-seams", "seams restless"},
    {"floor-slivers", "seams tick-step padding one-body float restless stop lengths"},
    {"floor-t-junctions", "seams restless stop"},
    {"floor-bodies", "one-body tick-step seams padding float restless stop lengths"},
    {"floor-noise", "seams all"},
    {"floor-stand", "restless"},
    {"wall-alone", "seams tick-step padding one-body float restless stop lengths"},
    {"wall-floor", "seams tick-step padding one-body float restless stop lengths"},
    {"wall-bodies", "one-body seams restless stop"},
    {"wall-leaning", "seams all"},
    {"corners", "hit-by-hit discrete restless stop"},
    {"corner-bodies", "hit-by-hit discrete restless stop"},
    {"convex-edge", "stop restless"},
    {"stairs-up", "tick-step all"},
    {"stairs-down", "tick-step float"},
    {"stairs-diagonal", "tick-step all"},
    {"stairs-wall", "tick-step all"},
    {"stairs-spiral", "tick-step all"},
    {"stairs-rates", "tick-step padding float stop"},
    {"stairs-too-high", "tick-step all"},
    {"slope-stand", "padding restless"},
    {"slope-slip", "any-slope hit-by-hit tick-step one-body float lengths"},
    {"slope-walk", "seams all"},
    {"slope-climb", "seams all"},
    {"slope-too-steep", "hit-by-hit tick-step seams one-body discrete float restless stop lengths"},
    {"slope-jump", "hit-by-hit all"},
    {"crest", "hit-by-hit tick-step padding one-body float stop lengths"},
    {"groove", "hit-by-hit all"},
    {"funnel", "hit-by-hit all"},
    {"bowl", "hit-by-hit all"},
    {"wedge", "discrete restless stop"},
    {"wedge-along", "seams hit-by-hit discrete restless stop"},
    {"ceiling-jump", "restless"},
    {"crevice-wide", "seams restless"},
    {"crevice-narrow", "hit-by-hit discrete restless"},
    {"lintel", "hit-by-hit discrete restless"},
    {"thin-wall", "discrete"},
    {"thin-floor", "discrete restless"},
    {"ledge-high", "padding tick-step one-body float restless stop lengths"},
    {"ledge-low", "padding tick-step one-body float restless stop lengths"},
    {"ledge-perch", "restless"},
    {"beam", "padding hit-by-hit tick-step one-body float restless stop lengths"},
    {"far", "float hit-by-hit tick-step seams padding one-body restless stop lengths"},
    {"sizes", "lengths tick-step float stop"},
    {"rates-open", "tick-step hit-by-hit seams padding one-body float restless stop lengths"},
    {"rates-land", "hit-by-hit tick-step seams padding one-body discrete float restless lengths"},
    {"rates-jump", "hit-by-hit all"},
    {"rates-gap", "padding"},
    {"lift", "hit-by-hit all"},
    {"train", "hit-by-hit all"},
    {"turntable", "hit-by-hit all"},
    {"pusher", "hit-by-hit all"},
    {"crusher", "restless"},
    {"spawn-inside", "hit-by-hit all"},
    {"soak", "discrete"},
};

struct OwnCatch {
    std::string_view scene;
    BodyShape shape;
    std::string_view fault;
};

// Where a body of another shape does not show the fault that a capsule shows, and shows another one.
constexpr OwnCatch own_catches[] = {
    {"floor-seams", BodyShape::ellipsoid, "restless"},
    {"floor-slivers", BodyShape::ellipsoid, "restless"},
    {"floor-t-junctions", BodyShape::ellipsoid, "stop"},
    {"floor-bodies", BodyShape::ellipsoid, "stop"},
    {"stairs-up", BodyShape::box, "float"},
    {"stairs-down", BodyShape::box, "float"},
    {"stairs-spiral", BodyShape::box, "seams"},
    {"lintel", BodyShape::box, "restless"},
    {"stairs-down", BodyShape::cylinder, "float"},
    {"stairs-spiral", BodyShape::cylinder, "seams"},
    {"stairs-too-high", BodyShape::cylinder, "padding"},
    {"ledge-high", BodyShape::cylinder, "seams"},
    {"ledge-low", BodyShape::cylinder, "restless"},
    {"lintel", BodyShape::cone, "restless"},
    {"slope-too-steep", BodyShape::box, "restless"},
    {"slope-too-steep", BodyShape::cylinder, "restless"},
    {"crest", BodyShape::box, "seams"},
};

std::string_view own_fault(std::string_view scene, BodyShape shape) {
    for (const OwnCatch& entry : own_catches) {
        if (entry.scene == scene && entry.shape == shape) return entry.fault;
    }
    return {};
}

std::vector<std::string> caught_with_capsules(std::string_view scene) {
    std::vector<std::string> caught;
    const auto add = [&](std::string name) {
        if (std::find(caught.begin(), caught.end(), name) == caught.end()) caught.push_back(std::move(name));
    };
    for (const Catch& entry : catches) {
        if (entry.scene != scene) continue;
        for (std::string_view rest = entry.faults; !rest.empty();) {
            const std::size_t end = std::min(rest.find(' '), rest.size());
            const std::string_view fault = rest.substr(0, end);
            rest.remove_prefix(std::min(end + 1, rest.size()));
            if (fault != "all") add("broken-" + std::string(fault));
            for (const MoverName& mover : movers()) {
                if (fault == "all" && mover.is_broken && mover.name != "broken-any-slope") add(std::string(mover.name));
            }
        }
    }
    return caught;
}

}  // namespace

std::vector<std::string> broken_movers_caught_by(std::string_view scene, BodyShape shape) {
    std::vector<std::string> caught = caught_with_capsules(scene);
    if (shape == BodyShape::capsule) return caught;
    const std::string_view own = own_fault(scene, shape);
    if (!own.empty()) return {"broken-" + std::string(own)};
    caught.resize(std::min<std::size_t>(caught.size(), 1));
    return caught;
}

}  // namespace surefoot::course
