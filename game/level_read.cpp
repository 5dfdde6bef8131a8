// From the nodes of a .glb to a level: which node is what, in the words of docs/levels.md.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <iterator>

#include <surefoot/import.hpp>
#include <surefoot/pose.hpp>

#include "game/extras.hpp"
#include "game/level.hpp"
#include "game/level_meshes.hpp"

namespace surefoot::game {
namespace {

constexpr double farthest = 1e4;  // that a level reaches from its origin [m]

class Reader {
public:
    Reader(const ImportedLevel& from, Level& level) : from_(from), level_(level), cut_(from) {}

    [[nodiscard]] Expected<void> read() {
        read_materials();
        for (const Marker& marker : from_.markers) read_marker(marker);
        if (error_.empty()) order_and_check();
        if (error_.empty()) build_meshes();
        if (error_.empty()) return {};
        return tl::unexpected(Error{ErrorCode::invalid, from_.file + ": " + error_, from_.file, 0});
    }

private:
    void wrong(const std::string& what) {
        if (error_.empty()) error_ = what;
    }

    void read_materials() {
        level_.materials.resize(from_.surface_names.size());
        level_.rules.resize(from_.surface_names.size());
        for (std::size_t i = 0; i < from_.surface_names.size(); ++i) {
            Material& material = level_.materials[i];
            SurfaceRule& rule = level_.rules[i];
            material.name = from_.surface_names[i];
            Extras extras(i < from_.surface_extras.size() ? from_.surface_extras[i] : std::string{},
                          "material " + material.name);
            if (extras.has("colour")) {
                const dvec3 colour = extras.vector("colour", {1, 1, 1});
                material.colour = {std::clamp(colour.x, 0.0, 1.0), std::clamp(colour.y, 0.0, 1.0),
                                   std::clamp(colour.z, 0.0, 1.0)};
            }
            material.deadly = extras.flag("deadly");
            material.glow = extras.number("glow", 0, 0, 1);
            material.drawing = extras.one_of<Drawing>("drawing", {"none", "patches", "bricks", "boards", "strata"});
            rule.grip = extras.number("grip", 1, 0, 10);
            rule.conveyor = extras.vector("conveyor", {0, 0, 0});
            rule.one_way = extras.flag("one_way");
            rule.slippery = extras.flag("slippery");
            rule.ladder = extras.flag("ladder");
            wrong(extras.error());
        }
    }

    void read_marker(const Marker& marker) {
        Extras extras(marker.extras, "node " + marker.name);
        for (int i = 0; i < 3; ++i)
            if (!(std::abs(marker.position[i]) <= farthest))
                extras.wrong(fmt::format("it lies more than {} m from the origin", farthest));
        if (!read_place(marker, extras) && !read_zone(marker, extras)) read_body(marker, extras);
        wrong(extras.error());
    }

    // What is a place and nothing else. True if it was one.
    bool read_place(const Marker& marker, Extras& extras) {
        const std::string& kind = marker.kind;
        const dvec3& at = marker.position;
        const auto pickup = [&](PickupKind what) {
            level_.pickups.push_back({what, at, extras.text("door")});
            if (what == PickupKind::key && level_.pickups.back().door.empty())
                extras.wrong("a key needs 'door': the name that its door has, too");
            return true;
        };
        if (kind == "level") return read_level_words(extras);
        if (kind == "spawn" || kind == "checkpoint") {
            const bool is_spawn = kind == "spawn";
            if (is_spawn) ++spawns_;
            const dvec3 ahead = to_world({{0, 0, 0}, marker.orientation}, {0, 0, -1});
            const double length = std::sqrt(ahead.x * ahead.x + ahead.z * ahead.z);
            level_.checkpoints.push_back(
                {.feet = at,
                 .facing = length > 1e-6 ? dvec3{ahead.x / length, 0, ahead.z / length} : dvec3{0, 0, -1},
                 .section = extras.text("section", is_spawn ? "The start" : marker.name),
                 .order = is_spawn ? 0 : extras.whole("order", 1, 1, 1000)});
            return true;
        }
        if (kind == "goal") {
            ++goals_;
            level_.goal = at;
            level_.goal_radius = extras.number("radius", 1.5, 0.3, 50);
            return true;
        }
        if (kind == "coin") return pickup(PickupKind::coin);
        if (kind == "star") return pickup(PickupKind::star);
        if (kind == "heart") return pickup(PickupKind::heart);
        if (kind == "key") return pickup(PickupKind::key);
        if (kind == "enemy") return read_enemy(at, extras);
        if (kind == "beat") {
            level_.beats.push_back({.order = extras.whole("order", 1, 0, 1000),
                                    .name = extras.text("name", marker.name),
                                    .text = extras.text("text"),
                                    .place = at,
                                    .eye = at + extras.vector("eye", {0, 4, 10}),
                                    .look = at + extras.vector("look", {0, 0, 0})});
            return true;
        }
        if (kind == "way") {
            level_.ways.push_back({.how = extras.one_of<Manoeuvre>(
                                       "how", {"ride", "wall_jump", "dash", "bounce", "swim", "climb", "crouch"}),
                                   .from = at,
                                   .to = at + extras.vector("to", {0, 0, 0}),
                                   .by = extras.text("by")});
            return true;
        }
        return false;
    }

    bool read_level_words(Extras& extras) {
        ++levels_;
        level_.title = extras.text("title", level_.title);
        level_.idea = extras.text("idea");
        level_.order = extras.whole("order", 1000, 0, 100000);
        level_.secret = extras.flag("secret");
        level_.stars_needed = extras.whole("stars_needed", 0, 0, 1000);
        level_.par = extras.number("par", 120, 1, 36000);
        level_.medals = {.gold = extras.number("gold", level_.par, 1, 36000),
                         .silver = extras.number("silver", level_.par * 1.35, 1, 36000),
                         .bronze = extras.number("bronze", level_.par * 1.9, 1, 36000)};
        level_.time_limit = extras.number("time_limit", 1200, 10, 36000);
        has_kill_y_ = extras.has("kill_y");
        level_.kill_y = extras.number("kill_y", 0, -farthest, farthest);
        level_.music = extras.text("music", "calm");
        level_.sky = extras.text("sky", "day");
        if (!(level_.medals.gold <= level_.medals.silver && level_.medals.silver <= level_.medals.bronze))
            extras.wrong("gold, silver and bronze have to be times in this order, the shortest first");
        return true;
    }

    bool read_enemy(const dvec3& at, Extras& extras) {
        EnemyPlan plan{.kind = extras.one_of<EnemyKind>("type", {"chaser", "patroller", "jumper", "shooter"}),
                       .feet = at,
                       .route = {at},
                       .sight = extras.number("sight", 9, 0, 200),
                       .leash = extras.number("leash", 14, 0, 500)};
        for (const dvec3& offset : extras.vectors("route"))
            if (offset != dvec3{0, 0, 0}) plan.route.push_back(at + offset);
        level_.enemies.push_back(std::move(plan));
        return true;
    }

    // What is a box in the air.
    bool read_zone(const Marker& marker, Extras& extras) {
        const std::string& kind = marker.kind;
        if (kind != "water" && kind != "prompt" && kind != "camera") return false;
        const dvec3 size = extras.vector("size", {4, 4, 4});
        if (!(size.x > 0 && size.y > 0 && size.z > 0)) extras.wrong("'size' has to be three lengths above 0");
        const Zone zone{marker.position, size * 0.5, marker.orientation};
        if (kind == "water") level_.waters.push_back(zone);
        if (kind == "prompt") level_.prompts.push_back({zone, extras.text("text")});
        if (kind == "camera")
            level_.cameras.push_back({.zone = zone,
                                      .yaw_deg = extras.number("yaw", 0, -360, 360),
                                      .pitch_deg = extras.number("pitch", 20, -80, 80),
                                      .distance = extras.number("distance", 5, 0.5, 50)});
        return true;
    }

    // What has triangles of its own and is not still.
    void read_body(const Marker& marker, Extras& extras) {
        if (marker.kind == decor_kind) {
            if (!cut_.take(marker.name, decor_)) extras.wrong("a node of this kind needs triangles of its own");
            return;
        }
        const auto kind = body_kind(marker.kind);
        if (!kind) return;  // somebody else's: navigation's regions, a tool's notes
        BodyPlan plan{.kind = *kind, .name = marker.name, .mesh = level_.ground, .origin = marker.position};
        read_route(extras, plan);
        plan.delay = extras.number("delay", 0.6, 0, 60);
        plan.back = extras.number("back", 3, 0.1, 600);
        plan.bounce = extras.number("speed", 14, 1, 100);
        plan.damage = extras.whole("damage", 1, 0, 100);
        plan.door = extras.text("door");
        plan.coins = extras.whole("coins", 0, 0, 100000);
        if (plan.kind == BodyKind::door && plan.door.empty() && plan.coins == 0)
            extras.wrong("a door needs 'door', the name on its key, or 'coins', how many open it");
        MeshCut cut;
        if (!cut_.take(marker.name, cut)) extras.wrong("a node of this kind needs triangles of its own");
        if (!extras.error().empty()) return;
        auto mesh = cut.build(plan.origin);
        if (!mesh) {
            extras.wrong(mesh.error().text);
            return;
        }
        plan.mesh = *mesh;
        level_.bodies.push_back(std::move(plan));
    }

    static void read_route(Extras& extras, BodyPlan& plan) {
        Route& route = plan.route;
        if (plan.kind != BodyKind::platform && plan.kind != BodyKind::hazard && plan.kind != BodyKind::turntable)
            return;
        route.stops = extras.vectors("path");
        if (!route.stops.empty() && route.stops.front() != dvec3{0, 0, 0})
            extras.wrong("'path' has to begin with [0, 0, 0], where the node is");
        for (std::size_t i = 1; i < route.stops.size(); ++i)
            if (route.stops[i] == route.stops[i - 1]) extras.wrong("'path' has the same stop twice in a row");
        if (route.stops.size() == 1) extras.wrong("'path' needs a second stop");
        if (plan.kind != BodyKind::bounce) route.speed = extras.number("speed", 2, 0.01, 100);
        route.pause = extras.number("pause", 1, 0, 600);
        route.phase = extras.number("phase", 0, 0, 3600);
        route.loop = extras.one_of<PathLoop>("loop", {"back", "round", "once"});
        route.waits = extras.one_of<int>("starts", {"always", "ridden"}) == 1;
        route.deg_per_s = extras.number("deg_per_s", plan.kind == BodyKind::turntable ? 30 : 0, -360, 360);
        if (plan.kind == BodyKind::platform && route.stops.empty())
            extras.wrong("a platform needs 'path': its stops, beginning with [0, 0, 0]");
    }

    void order_and_check() {
        const auto once = [&](int count, const char* what, const char* cure) {
            if (count != 1) wrong(fmt::format("it has {} nodes of kind '{}', and needs one: {}", count, what, cure));
        };
        once(spawns_, "spawn", "an empty node where the hero's feet begin, facing -Z");
        once(goals_, "goal", "an empty node where the level ends");
        if (levels_ > 1) once(levels_, "level", "its title, par time and the like, on an empty node");
        std::ranges::stable_sort(level_.checkpoints, {}, &Checkpoint::order);
        for (std::size_t i = 1; i < level_.checkpoints.size(); ++i)
            if (level_.checkpoints[i].order == level_.checkpoints[i - 1].order)
                wrong(fmt::format("two checkpoints have the order {}", level_.checkpoints[i].order));
        std::ranges::stable_sort(level_.beats, {}, &Beat::order);
        for (const BodyPlan& body : level_.bodies) {
            if (body.kind != BodyKind::door || body.door.empty()) continue;
            const bool has_key = std::ranges::any_of(level_.pickups, [&](const PickupPlan& pickup) {
                return pickup.kind == PickupKind::key && pickup.door == body.door;
            });
            if (!has_key) wrong(fmt::format("no key opens the door '{}' ({}): it needs one", body.door, body.name));
        }
        for (const Way& way : level_.ways)
            if (way.how == Manoeuvre::ride &&
                std::ranges::none_of(level_.bodies, [&](const BodyPlan& body) { return body.name == way.by; }))
                wrong(fmt::format("a way rides on '{}', and there is no such platform", way.by));
    }

    void build_meshes() {
        const auto build = [&](const MeshCut& cut, Mesh& into) {
            auto mesh = cut.build({0, 0, 0});
            if (mesh)
                into = *mesh;
            else
                wrong(mesh.error().text);
        };
        build(decor_, level_.decor);
        MeshCut ground;
        cut_.take_rest(ground);
        build(ground, level_.ground);
        if (level_.ground.triangle_count() == 0) wrong("nothing in it is solid: every mesh is on a node with a kind");
        if (!has_kill_y_) level_.kill_y = level_.ground.bounds().min.y - 10;
        if (!(level_.kill_y < level_.checkpoints.front().feet.y)) wrong("'kill_y' is above the spawn");
    }

    const ImportedLevel& from_;
    Level& level_;
    LevelCutter cut_;
    MeshCut decor_;
    std::string error_;
    int spawns_ = 0;
    int goals_ = 0;
    int levels_ = 0;
    bool has_kill_y_ = false;
};

}  // namespace

Expected<Level> read_level(const std::string& path) {
    const auto imported = import_level(path);
    if (!imported) return tl::unexpected(imported.error());
    auto nothing = Mesh::build({});
    if (!nothing) return tl::unexpected(nothing.error());
    Level level{.id = std::filesystem::path(path).stem().string(), .file = path, .ground = *nothing, .decor = *nothing};
    level.title = level.id;
    std::ifstream file(path, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    level.hash = hash_bytes(std::as_bytes(std::span(bytes)));
    level.markers = imported->markers;
    if (auto read = Reader(*imported, level).read(); !read) return tl::unexpected(read.error());
    return level;
}

}  // namespace surefoot::game
