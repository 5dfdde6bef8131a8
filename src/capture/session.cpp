#include <bit>

#include <surefoot/capture_session.hpp>
#include <surefoot/file.hpp>

#include "capture/number.hpp"
#include "capture/parts.hpp"
#include "ieee_guard.hpp"

namespace surefoot {
inline namespace v0 {

using namespace internal;

namespace {

void add_bits(std::vector<std::uint64_t>& words, const dvec3& v) {
    for (const double value : {v.x, v.y, v.z}) words.push_back(std::bit_cast<std::uint64_t>(value + 0.0));
}

std::vector<BodyPose> poses_in(const World& world) {
    std::vector<BodyPose> poses(world.body_count());
    world.save_poses(poses);
    return poses;
}

// Puts the bodies as they are in a tick; says what is wrong if that cannot be.
std::string place(World& world, std::span<const BodyPose> poses) {
    for (const BodyPose& pose : poses) {
        const BodyHandle handle = world.find(pose.body);
        if (!world.contains(handle)) {
            return joined({"there is no body ", std::to_string(pose.body), " in this world"});
        }
        if (!world.move(handle, pose.start, pose.end)) {
            return joined({"body ", std::to_string(pose.body), " has a pose that cannot be"});
        }
    }
    return {};
}

}  // namespace

std::uint64_t level_hash(const World& world) {
    const IeeeGuard guard;
    std::uint64_t hash = 0;
    std::vector<SourceTriangle> triangles;
    std::vector<std::uint64_t> words;
    for (const BodyPose& body : poses_in(world)) {
        const std::optional<SourceView> source = world.source(world.find(body.body));
        if (!source) continue;
        triangles.resize(source->gather(source->bounds(), {}));
        source->gather(source->bounds(), triangles);
        words.assign({body.body, triangles.size()});
        for (const SourceTriangle& one : triangles) {
            words.push_back(std::uint64_t{one.id} << 32U | one.surface);
            add_bits(words, one.triangle.a);
            add_bits(words, one.triangle.b);
            add_bits(words, one.triangle.c);
        }
        hash = hash_bytes(std::as_bytes(std::span(words)), hash);
    }
    return hash;
}

Session begin_session(const World& world, const CharacterSettings& settings, const CharacterState& first) {
    Session session;
    session.settings = settings;
    session.settings.surfaces = {};
    session.surfaces.assign(settings.surfaces.all().begin(), settings.surfaces.all().end());
    session.level = level_hash(world);
    session.bodies = poses_in(world);
    session.first = first;
    session.origin = {.library = library_version(), .abi = abi_name, .format = session_form};
    return session;
}

void record(Session& session, const CharacterInput& input, double dt, const CharacterState& after,
            std::span<const BodyPose> moved, std::span<const Neighbour> neighbours) {
    session.ticks.push_back(
        {input, dt, hash(after), {moved.begin(), moved.end()}, {neighbours.begin(), neighbours.end()}});
}

CharacterSettings settings_of(const Session& session) noexcept {
    CharacterSettings settings = session.settings;
    settings.surfaces = SurfaceRules(session.surfaces);
    return settings;
}

SessionReplay replay(const Session& session, World& world, std::size_t most) {
    SessionReplay again;
    again.before = session.first;
    again.after = session.first;
    again.is_same_level = level_hash(world) == session.level;
    if (!again.is_same_level) return again;
    again.wrong = place(world, session.bodies);
    const CharacterSettings settings = settings_of(session);
    for (const SessionTick& tick : session.ticks) {
        if (again.ticks == most || !again.wrong.empty()) break;
        world.begin_tick();
        again.wrong = place(world, tick.moved);
        if (!again.wrong.empty()) break;
        again.before = again.after;
        again.after = step(world, settings, tick.input, tick.dt, again.before, tick.neighbours).state;
        ++again.ticks;
        if (hash(again.after) == tick.hash) continue;
        again.first_differs = again.ticks - 1;
        break;
    }
    return again;
}

}  // namespace v0
}  // namespace surefoot
