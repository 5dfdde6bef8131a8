#include "why_stages.hpp"

namespace surefoot::tests {
namespace {

constexpr double centimetre = 0.01;

void set_slope_limit_past(CharacterSettings& settings, double degrees) {
    settings.slope_limit_deg = degrees + 1;
}
void set_step_up_past(CharacterSettings& settings, double height) {
    settings.step_up = height + centimetre;
}
void set_snap_down_past(CharacterSettings& settings, double depth) {
    settings.snap_down = depth + centimetre;
}
void set_perch_distance_past(CharacterSettings& settings, double distance) {
    settings.perch_distance = distance + centimetre;
}

std::function<bool(const Actor&)> is_beyond(double x) {
    return [x](const Actor& actor) { return actor.state.position.x > x; };
}
std::function<bool(const Actor&)> never_did(CharacterEvent event) {
    return [event](const Actor& actor) { return !actor.did(event); };
}

struct Kind {
    const char* name;
    Volume volume;
};
const Kind ellipsoid{"Ellipsoid", Ellipsoid{{0.4, 0.9, 0.4}}};
const Kind capsule{"Capsule", Capsule{0.4, 0.5}};
const Kind sphere{"Sphere", Sphere{0.5}};
const Kind box{"Box", Box{{0.3, 0.9, 0.3}}};
const Kind cylinder{"Cylinder", Cylinder{0.4, 0.9}};

std::string whole(double value) {
    return std::to_string(static_cast<int>(value + 0.5));
}

Stage steep_ramp(double degrees, double limit, const Kind& kind) {
    Stage stage;
    stage.name = "ARampOf" + whole(degrees) + "Degrees" + kind.name;
    stage.scene.floor(-20, 0, -10, 10).ramp(0, 6, degrees);
    stage.settings.volume = kind.volume;
    stage.settings.slope_limit_deg = limit;
    stage.triangles = {2, 3};
    stage.rule = StepRule::slope_limit;
    stage.says = "that face rises by ";
    stage.number = degrees;
    stage.within = 0.1;
    stage.change = set_slope_limit_past;
    stage.succeeded = is_beyond(0.5);
    return stage;
}

Stage high_step(double height, double step_up, const Kind& kind) {
    Stage stage;
    stage.name = "AStepOf" + whole(height * 100) + "Centimetres" + kind.name;
    stage.scene.floor(-20, 0, -10, 10).stairs(0, 1, height, 1);
    stage.settings.volume = kind.volume;
    stage.settings.step_up = step_up;
    stage.settings.step_depth = 0.4;  // far enough that no round body is held by the edge alone
    stage.triangles = {4, 5};
    stage.rule = step_up > 0 ? StepRule::step_height : StepRule::steps_off;
    stage.says = " is ";
    stage.number = height;
    stage.within = 0.001;
    stage.change = set_step_up_past;
    stage.succeeded = is_beyond(0.5);
    return stage;
}

// A step under a ceiling that leaves `room` above a body of 1.82 m with its skins. A lower body gets there.
Stage low_ceiling(double room, const Kind& kind) {
    Stage stage = high_step(0.3, 0.4, kind);
    stage.name = "NoRoomAbove" + std::string(kind.name) + whole(room * 100);
    stage.scene.block({-10, 1.82 + room, -10}, {10, 4, 10});
    stage.start.y = 0.92;
    stage.rule = StepRule::head_room;
    stage.says = "there is room for ";
    stage.number = room;
    stage.within = 0.02;
    stage.change = [](CharacterSettings& settings, double has) {
        const double lower = 0.3 - has + 2 * centimetre;
        if (auto* round = std::get_if<Ellipsoid>(&settings.volume.shape)) round->radii.y -= lower / 2;
        if (auto* flat = std::get_if<Box>(&settings.volume.shape)) flat->half_extents.y -= lower / 2;
    };
    stage.triangles.clear();
    return stage;
}

// A step whose top is a ramp.
Stage steep_landing(double degrees) {
    Stage stage;
    stage.name = "AStepOnToASlopeOf" + whole(degrees) + "Degrees";
    const double rise = 6 * std::tan(degrees * 0.017453292519943295);
    stage.scene.floor(-20, 0, -10, 10)
        .quad({0, 0, -10}, {0, 0, 10}, {0, 0.1, 10}, {0, 0.1, -10})
        .quad({0, 0.1, -10}, {0, 0.1, 10}, {6, 0.1 + rise, 10}, {6, 0.1 + rise, -10});
    stage.settings.volume = box.volume;
    stage.triangles = {4, 5};
    stage.rule = StepRule::slope_limit;
    stage.says = "of body 0, rises by ";
    stage.number = degrees;
    stage.within = 0.1;
    stage.change = set_slope_limit_past;
    stage.succeeded = is_beyond(0.5);
    return stage;
}

// Steps are walked up only as far as an edge may be from the axis.
Stage strict_perch(double height) {
    Stage stage = high_step(height, 0.4, capsule);
    stage.name = "APerchTooFarOutOnAStepOf" + whole(height * 100) + "Centimetres";
    stage.settings.slope_limit_deg = 30;
    stage.settings.perch_distance = 0.05;
    stage.settings.step_depth = 0.15;
    stage.triangles = {2, 3, 4, 5};  // the edge is of all four
    stage.rule = StepRule::perch_distance;
    stage.says = "holds it by an edge ";
    stage.number = 0.25;
    stage.within = 0.03;
    stage.change = set_perch_distance_past;
    return stage;
}

Stage deep_ledge(double depth, const Kind& kind) {
    Stage stage;
    stage.name = "ALedgeOf" + whole(depth * 100) + "Centimetres" + kind.name;
    stage.scene.floor(-20, 0, -10, 10).floor(0, 20, -10, 10, -depth);
    stage.settings.volume = kind.volume;
    stage.passes = true;
    stage.triangles = {2, 3};
    stage.rule = StepRule::snap_distance;
    stage.says = " is ";
    stage.number = depth;
    stage.within = 0.001;
    stage.change = set_snap_down_past;
    stage.succeeded = never_did(CharacterEvent::left_ground);
    return stage;
}

// Let down over an edge, its axis beside it.
Stage slip(double beside, double height, const Kind& kind) {
    Stage stage;
    stage.name = "AnEdge" + whole(beside * 100) + "CentimetresFromTheAxis" + kind.name;
    stage.scene.floor(-20, 0, -10, 10);
    stage.start = {beside, height, 0};
    stage.wish = {0, 0, 0};
    stage.settings.volume = kind.volume;
    stage.settings.slope_limit_deg = 30;
    stage.settings.perch_distance = 0.1;
    stage.passes = true;
    stage.triangles = {0, 1};
    stage.rule = StepRule::perch_distance;
    stage.says = "it holds it by an edge ";
    stage.number = beside;
    stage.within = 0.02;
    stage.change = set_perch_distance_past;
    stage.succeeded = [](const Actor& actor) { return actor.on_ground(); };
    return stage;
}

Stage slide_off(double degrees) {
    Stage stage;
    stage.name = "NoStandingOnASlopeOf" + whole(degrees) + "Degrees";
    stage.scene.ramp(0, 10, degrees);
    stage.start = {5, 5 * std::tan(degrees * 0.017453292519943295) + 1.5, 0};
    stage.wish = {0, 0, 0};
    stage.passes = true;
    stage.triangles = {0, 1};
    stage.rule = StepRule::slope_limit;
    stage.says = "that face rises by ";
    stage.number = degrees;
    stage.within = 0.1;
    stage.change = set_slope_limit_past;
    stage.succeeded = [](const Actor& actor) { return actor.on_ground(); };
    stage.seconds = 0.5;
    return stage;
}

Stage ceiling(double room, const Kind& kind) {
    Stage stage;
    stage.name = "ACeiling" + whole(room * 100) + "CentimetresAbove" + kind.name;
    stage.scene.floor(-20, 20, -10, 10)
        .quad({-10, 1.82 + room, -10}, {10, 1.82 + room, -10}, {10, 1.82 + room, 10}, {-10, 1.82 + room, 10});
    stage.start.y = 0.92;
    stage.wish = {0, 0, 0};
    stage.settings.volume = kind.volume;
    stage.jumps = true;
    stage.passes = true;
    stage.triangles = {2, 3};
    stage.says = "it would have risen by ";
    stage.number = stage.settings.jump_height - room;
    stage.within = 0.04;
    stage.change = [](CharacterSettings& settings, double more) { settings.jump_height -= more + centimetre; };
    stage.succeeded = never_did(CharacterEvent::hit_ceiling);
    return stage;
}

// A lintel: a lower body gets through below it.
Stage lintel(double height, const Kind& kind) {
    Stage stage;
    stage.name = "ALintelAt" + whole(height * 100) + "Centimetres" + kind.name;
    stage.scene.floor(-20, 20, -10, 10).block({0, height, -10}, {1, 3, 10});
    stage.settings.volume = kind.volume;
    stage.triangles = {2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13};
    stage.says = "it is met ";
    stage.number = height;
    stage.within = 0.02;
    stage.change = [](CharacterSettings& settings, double at) {
        const double tall = at - 4 * centimetre;
        if (auto* round = std::get_if<Ellipsoid>(&settings.volume.shape)) round->radii.y = tall / 2;
        if (auto* pill = std::get_if<Capsule>(&settings.volume.shape)) pill->half_height = tall / 2 - pill->radius;
    };
    stage.succeeded = is_beyond(0.5);
    return stage;
}

}  // namespace

std::vector<Stage> stages() {
    return {
        steep_ramp(52, 50, ellipsoid),
        steep_ramp(60, 50, ellipsoid),
        steep_ramp(70, 50, ellipsoid),
        steep_ramp(80, 50, ellipsoid),
        steep_ramp(40, 30, capsule),
        steep_ramp(40, 30, sphere),
        steep_ramp(40, 30, box),
        steep_ramp(40, 30, cylinder),
        high_step(0.45, 0.4, ellipsoid),
        high_step(0.52, 0.4, ellipsoid),
        high_step(1.0, 0.4, box),
        high_step(0.52, 0.4, box),
        high_step(0.7, 0.4, capsule),
        high_step(0.4, 0.2, sphere),
        high_step(1.4, 0.4, cylinder),
        high_step(0.3, 0, ellipsoid),
        high_step(0.1, 0, box),
        low_ceiling(0.1, ellipsoid),
        low_ceiling(0.2, box),
        steep_landing(55),
        steep_landing(60),
        strict_perch(0.35),
        deep_ledge(0.6, box),
        deep_ledge(1.1, cylinder),
        slip(0.25, 0.725, ellipsoid),
        slip(0.3, 0.784, capsule),
        slide_off(55),
        slide_off(65),
        ceiling(0.5, ellipsoid),
        ceiling(0.9, cylinder),
        lintel(1.5, ellipsoid),
        lintel(1.6, capsule),
    };
}

}  // namespace surefoot::tests
