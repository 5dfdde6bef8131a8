#include "debugger/question_text.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "debugger/worlds.hpp"
#include "query.hpp"

namespace surefoot::debugger {

namespace {

using nlohmann::json;

constexpr const char* triangles_usage =
    R"("triangles" must be a list of triangles, each [[x,y,z],[x,y,z],[x,y,z]] with 64 of them at the most)";

tools::Parsed<dvec3> corner_from(const json& value) {
    if (!value.is_array() || value.size() != 3) return tl::unexpected(std::string(triangles_usage));
    for (const json& number : value)
        if (!number.is_number()) return tl::unexpected(std::string(triangles_usage));
    return dvec3(value[0].get<double>(), value[1].get<double>(), value[2].get<double>());
}

tools::Parsed<std::vector<Triangle>> triangles_from(const json& list) {
    if (!list.is_array() || list.empty() || list.size() > most_triangles)
        return tl::unexpected(std::string(triangles_usage));
    std::vector<Triangle> triangles;
    for (const json& corners : list) {
        if (!corners.is_array() || corners.size() != 3) return tl::unexpected(std::string(triangles_usage));
        Triangle triangle;
        for (std::size_t i = 0; i < 3; ++i) {
            const tools::Parsed<dvec3> corner = corner_from(corners[i]);
            if (!corner) return tl::unexpected(corner.error());
            if (const auto wrong = tools::complaint("triangles", *corner)) return tl::unexpected(*wrong);
            corner_of(triangle, i) = *corner;
        }
        triangles.push_back(triangle);
    }
    return triangles;
}

/// Takes "triangles" out of a line, if it is there, and leaves a line that the command line understands. What is wrong
/// with the rest is left for the command line to say.
struct Split {
    std::string rest;
    json triangles;  ///< null if there are none
};

Split split(std::string_view line) {
    std::size_t names = 0;
    const json::parser_callback_t count_names = [&names](int, json::parse_event_t event, json&) {
        names += event == json::parse_event_t::key;
        return true;
    };
    json value = json::parse(line, count_names, /*allow_exceptions=*/false);
    if (!value.is_object() || !value.contains("triangles")) return {std::string(line), nullptr};
    std::size_t kept = value.size();
    for (const json& member : value)
        if (member.is_object()) kept += member.size();
    if (kept != names)
        return {std::string(line), nullptr};  // a name is there twice, and which is meant is not ours to say
    Split parts{{}, value["triangles"]};
    value.erase("triangles");
    parts.rest = value.dump();
    return parts;
}

bool are_the_same(const std::vector<Triangle>& a, const std::vector<Triangle>& b) {
    Question one;
    Question other;
    one.triangles = a;
    other.triangles = b;
    return one == other;
}

/// A world of our own, if these are its triangles.
WorldKind world_of(const std::vector<Triangle>& triangles) {
    for (const WorldKind world : {WorldKind::triangle, WorldKind::fold, WorldKind::wedge})
        if (are_the_same(triangles, triangles_of(world))) return world;
    return WorldKind::own;
}

/// A double is written with as many digits as it takes to read it back.
std::string list_of(const dvec3& v) {
    return fmt::format("[{},{},{}]", v.x, v.y, v.z);
}

}  // namespace

std::string to_line(const Question& question) {
    const Volume volume = question.volume();
    const tools::ShapeParts parts = tools::parts_of(volume.shape);
    const double* const sizes = parts.dimensions.data();
    const dquat& q = volume.orientation;
    std::string line =
        fmt::format(R"({{"shape":{{"{}":[{}]}},"from":{},"to":{},"rotate":[{},{},{},{}],"one_sided":{})", parts.name,
                    fmt::join(sizes, sizes + parts.count, ","), list_of(question.motion.from),
                    list_of(question.motion.to), q.w, q.x, q.y, q.z, question.one_sided);
    std::string triangles;
    for (const Triangle& t : question.triangles)
        triangles +=
            fmt::format("{}[{},{},{}]", triangles.empty() ? "" : ",", list_of(t.a), list_of(t.b), list_of(t.c));
    if (!triangles.empty()) line += fmt::format(R"(,"triangles":[{}])", triangles);
    return line + '}';
}

tools::Parsed<Question> from_line(std::string_view line, const Question& now) {
    const Split parts = split(line);
    const Volume volume = now.volume();
    const tools::Parsed<tools::SweepQuery> query = tools::parse_query(
        parts.rest, {.shape = volume.shape, .rotate = volume.orientation, .one_sided = now.one_sided});
    if (!query) return tl::unexpected(query.error());
    Question question = now;
    question.motion = query->motion;
    question.sizes.set(query->volume.shape);
    question.shape = name_of(query->volume.shape);
    question.orientation = query->volume.orientation;
    question.one_sided = query->one_sided;
    if (!parts.triangles.is_null()) {
        tools::Parsed<std::vector<Triangle>> triangles = triangles_from(parts.triangles);
        if (!triangles) return tl::unexpected(triangles.error());
        question.triangles = std::move(*triangles);
        question.world = world_of(question.triangles);
        question.level.clear();
        question.opened = 0;
    }
    return question;
}

}  // namespace surefoot::debugger
