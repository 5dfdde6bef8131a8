/// A level of the platformer as it was written: its ground, and what stands and moves in it. Read from a .glb whose
/// nodes say in glTF `extras` what they are; docs/levels.md is the table of them. A level does not change while it is
/// played: `Game` does.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <surefoot/character_surface.hpp>
#include <surefoot/error.hpp>
#include <surefoot/mesh.hpp>
#include <surefoot/notes.hpp>

namespace surefoot::game {

/// What is drawn on a material: on top of its colour, and only for the eye.
enum class Drawing : std::uint8_t { none, patches, bricks, boards, strata };

/// What a triangle is made of, beside the rule that `step` knows.
struct Material {
    std::string name{};
    std::optional<std::array<double, 3>> colour;  ///< as displayed [0 to 1 each]; none: the drawer chooses
    bool deadly = false;                          ///< touching it costs all health
    double glow = 0;                              ///< how much of its colour it shines by itself [0 to 1]
    Drawing drawing = Drawing::none;
};

enum class PathLoop : std::uint8_t {
    back,   ///< to the last stop, and the same way back
    round,  ///< from the last stop straight to the first
    once,   ///< to the last stop, and stays there
};

/// How a body moves from stop to stop; a body without stops and without turning stands still.
struct Route {
    std::vector<dvec3> stops{};  ///< relative to where the body was made, the first of them zero [m]
    double speed = 2;            ///< on average, between stops [m/s, > 0]
    double pause = 1;            ///< at each stop [s, >= 0]
    double phase = 0;            ///< how far into its time it begins [s, >= 0]
    PathLoop loop = PathLoop::back;
    bool waits = false;    ///< stands at its first stop until somebody stands on it
    double deg_per_s = 0;  ///< about +Y through its origin
};

enum class BodyKind : std::uint8_t { platform, turntable, crumble, door, bounce, hazard };

/// Of a node of this kind; none if its triangles stand still, or are drawn only.
[[nodiscard]] std::optional<BodyKind> body_kind(std::string_view kind);

/// Of a node that is drawn and not solid.
inline constexpr std::string_view decor_kind = "decor";

/// A part of the level that is not still.
struct BodyPlan {
    BodyKind kind = BodyKind::platform;
    std::string name{};
    Mesh mesh;              ///< relative to `origin`
    dvec3 origin{0, 0, 0};  ///< [m]
    Route route{};          ///< of platforms, turntables and hazards
    double delay = 0.6;     ///< a crumbling one: from the first foot on it until it falls [s]
    double back = 3;        ///< and until it is there again [s]
    double bounce = 14;     ///< upwards [m/s]
    int damage = 1;         ///< of a hazard, in hearts
    std::string door{};     ///< the name on the keys that open it; empty for one that wants coins
    int coins = 0;          ///< that open it
};

enum class EnemyKind : std::uint8_t { chaser, patroller, jumper, shooter };

struct EnemyPlan {
    EnemyKind kind = EnemyKind::patroller;
    dvec3 feet{0, 0, 0};         ///< where it begins [m]
    std::vector<dvec3> route{};  ///< places that it walks to in turn, the first of them `feet` [m]
    double sight = 9;            ///< how far it notices [m]
    double leash = 14;           ///< how far from where it began it follows [m]
};

enum class PickupKind : std::uint8_t { coin, star, heart, key };

struct PickupPlan {
    PickupKind kind = PickupKind::coin;
    dvec3 place{0, 0, 0};
    std::string door{};  ///< of a key
};

struct Checkpoint {
    dvec3 feet{0, 0, 0};
    dvec3 facing{0, 0, -1};  ///< level, unit
    std::string section{};   ///< that begins here
    int order = 0;           ///< 0 is the spawn
};

/// A box that stands upright in the level; turned about +Y as its node is.
struct Zone {
    dvec3 middle{0, 0, 0};
    dvec3 half{1, 1, 1};
    dquat orientation{1, 0, 0, 0};

    [[nodiscard]] bool holds(const dvec3& place) const;
};

struct Prompt {
    Zone zone;
    std::string text{};  ///< {jump} and the like stand for what the player has bound to it
};

/// How the camera likes to stand while the hero is in a zone.
struct CameraHint {
    Zone zone;
    double yaw_deg = 0;  ///< from where it looks: 0 is from +Z, 90 from +X
    double pitch_deg = 20;
    double distance = 5;
};

/// A beat: something that the level teaches, tests or twists, and from where its picture is taken.
struct Beat {
    int order = 0;
    std::string name{};
    std::string text{};
    dvec3 place{0, 0, 0};
    dvec3 eye{0, 0, 0};
    dvec3 look{0, 0, 0};
};

enum class Manoeuvre : std::uint8_t { ride, wall_jump, dash, bounce, swim, climb, crouch };

/// Where the way needs what walking and jumping do not do, for bots.
struct Way {
    Manoeuvre how = Manoeuvre::ride;
    dvec3 from{0, 0, 0};
    dvec3 to{0, 0, 0};
    std::string by{};  ///< the name of the platform that is ridden
};

struct Medals {
    double gold = 120;  ///< at most so long [s]
    double silver = 160;
    double bronze = 220;
};

enum class Medal : std::uint8_t { none, bronze, silver, gold };

struct Level {
    std::string id{};  ///< its file's name without folder and ending: what progress is kept under
    std::string file{};
    std::uint64_t hash = 0;  ///< of the file's bytes: what a recording is for

    std::string title{};
    std::string idea{};
    int order = 0;
    bool secret = false;
    int stars_needed = 0;  ///< of all levels together, to be let in
    double par = 120;      ///< [s]
    Medals medals{};
    double time_limit = 1200;  ///< then the sun has set and it is lost [s]
    double kill_y = -20;       ///< who falls below it has fallen [m]
    std::string music = "calm";
    std::string sky = "day";

    Mesh ground;                        ///< all that is still and solid
    Mesh decor;                         ///< drawn only
    std::vector<Material> materials{};  ///< by surface number, of all meshes alike
    std::vector<SurfaceRule> rules{};   ///< likewise, for `step`

    std::vector<BodyPlan> bodies{};
    std::vector<EnemyPlan> enemies{};
    std::vector<PickupPlan> pickups{};
    std::vector<Checkpoint> checkpoints{};  ///< by order; the first is the spawn
    dvec3 goal{0, 0, 0};
    double goal_radius = 1.5;
    std::vector<Zone> waters{};
    std::vector<Prompt> prompts{};
    std::vector<CameraHint> cameras{};
    std::vector<Beat> beats{};  ///< by order
    std::vector<Way> ways{};
    std::vector<Marker> markers{};  ///< all, as in the file: navigation asks them for regions

    [[nodiscard]] int count(PickupKind kind) const;
    [[nodiscard]] Medal medal(double seconds) const;
};

/// Reads a level. Fails as `import_level` does, and with `invalid` for a level that cannot be played: no spawn, no
/// goal, a number out of its range, two levels in one; the text names the node and the cure.
[[nodiscard]] Expected<Level> read_level(const std::string& path);

/// What stands in a folder, without reading the triangles' tree: the names of its .glb files, sorted. None if there is
/// no such folder.
[[nodiscard]] std::vector<std::string> levels_in(const std::string& folder);

[[nodiscard]] std::string_view name_of(EnemyKind kind);
[[nodiscard]] std::string_view name_of(BodyKind kind);
[[nodiscard]] std::string_view name_of(PickupKind kind);
[[nodiscard]] std::string_view name_of(Medal medal);
[[nodiscard]] std::string_view name_of(Manoeuvre how);

}  // namespace surefoot::game
