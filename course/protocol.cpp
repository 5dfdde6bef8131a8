#include "course/protocol.hpp"

#include <charconv>

namespace surefoot::course::protocol {
namespace {

// The shortest text that reads back to the same number, whatever the locale.
template <typename Number>
void add(std::string& out, Number value) {
    char text[40];
    const auto [end, error] = std::to_chars(text, text + sizeof text, value);
    static_cast<void>(error);  // 40 characters hold every number
    out += ' ';
    out.append(text, end);
}

template <typename Vector>
void add_vector(std::string& out, const Vector& v) {
    add(out, v.x);
    add(out, v.y);
    add(out, v.z);
}

void add_pose(std::string& out, const Pose& pose) {
    add_vector(out, pose.position);
    add(out, pose.orientation.w);
    add(out, pose.orientation.x);
    add(out, pose.orientation.y);
    add(out, pose.orientation.z);
    out += '\n';
}

}  // namespace

std::string text_of(const Run& run) {
    std::string out = "run " + run.name + "\n";
    const CharacterSettings& settings = run.settings;
    const auto set = [&](std::string_view name, double value) {
        out += "set ";
        out += name;
        add(out, value);
        out += '\n';
    };
    const Capsule capsule = capsule_of(settings);
    set("radius", capsule.radius);
    set("half_height", capsule.half_height);
    set("skin", settings.skin);
    set("slope_limit_deg", settings.slope_limit_deg);
    set("step_up", settings.step_up);
    set("step_depth", settings.step_depth);
    set("snap_down", settings.snap_down);
    set("perch_distance", settings.perch_distance);
    set("gravity", settings.gravity);
    set("terminal_speed", settings.terminal_speed);
    set("jump_height", settings.jump_height);
    for (std::size_t i = 0; i < run.level->bodies.size(); ++i) {
        const LevelBody& body = run.level->bodies[i];
        out += "body";
        add(out, i);
        add(out, body.triangles.vertices.size());
        add(out, body.triangles.indices.size() / 3);
        add_pose(out, body.pose);
        for (const vec3& vertex : body.triangles.vertices) {
            out += 'v';
            add_vector(out, vertex);
            out += '\n';
        }
        for (std::size_t k = 0; k < body.triangles.indices.size(); k += 3) {
            out += 'f';
            for (std::size_t corner = k; corner < k + 3; ++corner) add(out, body.triangles.indices[corner]);
            out += '\n';
        }
        if (!body.path) continue;
        out += "moves";
        add(out, i);
        out += '\n';
    }
    out += "start";
    add_vector(out, run.start);
    return out + "\ngo\n";
}

std::string text_of(const Level& level, const Input& input, double dt, std::span<const Pose> poses) {
    std::string out;
    for (std::size_t i = 0; i < level.bodies.size(); ++i) {
        if (!level.bodies[i].path) continue;
        out += "pose";
        add(out, i);
        add_pose(out, poses[i]);
    }
    out += "tick";
    add(out, dt);
    add_vector(out, input.wish);
    out += input.jump ? " 1\n" : " 0\n";
    return out;
}

std::optional<Answer> answer_of(const std::string& line) {
    // By hand, because streams read neither "nan" nor "inf", and a mover that has lost its way says so.
    std::string_view rest = line;
    if (!rest.starts_with("at ")) return std::nullopt;
    rest.remove_prefix(2);
    double numbers[4];
    for (double& number : numbers) {
        while (rest.starts_with(' ')) rest.remove_prefix(1);
        const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), number);
        if (error != std::errc{}) return std::nullopt;
        rest.remove_prefix(static_cast<std::size_t>(end - rest.data()));
    }
    if (!rest.empty() || (numbers[3] != 0 && numbers[3] != 1)) return std::nullopt;
    return Answer{{numbers[0], numbers[1], numbers[2]}, numbers[3] == 1};
}

}  // namespace surefoot::course::protocol
