// A mover in a program of its own, as docs/course-protocol.md asks for: it reads lines, moves by surefoot::step, and
// says where it is. Put your own controller in its place.
#include <cstdio>
#include <iostream>
#include <map>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include <surefoot/character.hpp>

namespace {

using namespace surefoot;

/// Everything that belongs to one run.
struct Walk {
    World world;
    std::map<std::uint32_t, BodyHandle> bodies;
    CharacterSettings settings;
    CharacterState state;
};

dvec3 read_vector(std::istream& in) {
    dvec3 v;
    in >> v.x >> v.y >> v.z;
    return v;
}

Pose read_pose(std::istream& in) {
    Pose pose;
    pose.position = read_vector(in);
    in >> pose.orientation.w >> pose.orientation.x >> pose.orientation.y >> pose.orientation.z;
    return pose;
}

void read_setting(std::istream& in, CharacterSettings& settings, Capsule& capsule) {
    std::string name;
    double value = 0;
    in >> name >> value;
    const std::map<std::string, double*> known{{"radius", &capsule.radius},
                                               {"half_height", &capsule.half_height},
                                               {"skin", &settings.skin},
                                               {"slope_limit_deg", &settings.slope_limit_deg},
                                               {"step_up", &settings.step_up},
                                               {"step_depth", &settings.step_depth},
                                               {"snap_down", &settings.snap_down},
                                               {"perch_distance", &settings.perch_distance},
                                               {"gravity", &settings.gravity},
                                               {"terminal_speed", &settings.terminal_speed},
                                               {"jump_height", &settings.jump_height}};
    if (const auto field = known.find(name); field != known.end()) *field->second = value;
    settings.volume = capsule;
}

/// The vertices and triangles of a body follow its line.
bool read_body(std::istream& in, Walk& walk) {
    std::uint32_t number = 0;
    std::size_t vertex_count = 0, triangle_count = 0;
    in >> number >> vertex_count >> triangle_count;
    const Pose pose = read_pose(in);
    std::vector<vec3> vertices(vertex_count);
    std::vector<std::uint32_t> indices(3 * triangle_count);
    std::string word;
    for (vec3& vertex : vertices) std::cin >> word >> vertex.x >> vertex.y >> vertex.z;
    for (std::size_t i = 0; i < triangle_count; ++i)
        std::cin >> word >> indices[3 * i] >> indices[3 * i + 1] >> indices[3 * i + 2];
    std::cin.ignore(1, '\n');
    const auto mesh = Mesh::build({.vertices = vertices, .indices = indices});
    if (!mesh) return false;
    const auto handle = walk.world.add(*mesh, {.pose = pose, .body = number});
    if (handle) walk.bodies[number] = *handle;
    return handle.has_value();
}

}  // namespace

int main() {
    std::ios::sync_with_stdio(false);
    auto walk = std::make_unique<Walk>();
    Capsule capsule;
    for (std::string line; std::getline(std::cin, line);) {
        std::istringstream in(line);
        std::string word;
        in >> word;
        if (word == "surefoot-course") {
            std::cout << "surefoot-course 1" << std::endl;
        } else if (word == "run") {
            walk = std::make_unique<Walk>();
            walk->settings.acceleration = walk->settings.braking = walk->settings.air_acceleration = 1e9;
        } else if (word == "set") {
            read_setting(in, walk->settings, capsule);
        } else if (word == "body") {
            if (!read_body(in, *walk)) return 1;
        } else if (word == "start") {
            walk->state.position = read_vector(in);
        } else if (word == "go") {
            std::cout << "ready" << std::endl;
        } else if (word == "pose") {
            // The poses of a tick come before its "tick". The body was left where the tick before ended.
            std::uint32_t number = 0;
            in >> number;
            if (!walk->world.move(walk->bodies[number], read_pose(in))) return 1;
        } else if (word == "tick") {
            double dt = 0;
            CharacterInput input;
            in >> dt;
            input.wish = read_vector(in);
            in >> input.jump;
            walk->state = step(walk->world, walk->settings, input, dt, walk->state).state;
            const dvec3& at = walk->state.position;
            std::printf("at %.17g %.17g %.17g %d\n", at.x, at.y, at.z, walk->state.footing == Footing::ground ? 1 : 0);
            std::fflush(stdout);
            walk->world.begin_tick();
        }
    }
}
