#include "query.hpp"

#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "number.hpp"

namespace surefoot::tools {
namespace {

using nlohmann::json;

constexpr double coordinate_limit = 1e9;     // surefoot/math.hpp
constexpr double smallest_dimension = 1e-6;  // surefoot/shapes.hpp
constexpr double largest_dimension = 1e6;
constexpr double largest_ratio = 1e4;

/// Parses one line and refuses an object that names the same thing twice, which JSON allows and which would leave it to
/// chance what is asked.
Parsed<json> parse_json(std::string_view line) {
    std::size_t names = 0;
    const json::parser_callback_t count_names = [&names](int, json::parse_event_t event, json&) {
        names += event == json::parse_event_t::key;
        return true;
    };
    json value;
    try {
        value = json::parse(line, count_names);
    } catch (const json::exception& error) {
        // "[json.exception.parse_error.101] parse error at line 1, column 8: ..." - a line of a batch is always line 1.
        std::string_view text = error.what();
        if (const std::size_t start = text.find("column "); start != text.npos)
            text.remove_prefix(start);
        else if (const std::size_t name_end = text.find("] "); name_end != text.npos)
            text.remove_prefix(name_end + 2);
        return tl::unexpected(fmt::format("not JSON: {}", text));
    }
    if (!value.is_object())
        return tl::unexpected(std::string(R"(not an object: write {"shape":...,"from":...,"to":...})"));
    std::size_t kept = value.size();
    for (const json& member : value)
        if (member.is_object()) kept += member.size();
    if (kept < names)
        return tl::unexpected(std::string("a name is there twice (or objects are nested): write each once"));
    return value;
}

/// `count` numbers; a single number may stand without brackets.
Parsed<std::array<double, 4>> numbers(const json& value, std::string_view name, std::size_t count,
                                      std::string_view usage) {
    std::array<double, 4> list{};
    const auto wrong = [&] { return tl::unexpected(fmt::format(R"("{}" must be {})", name, usage)); };
    if (count == 1 && value.is_number()) {
        list[0] = value.get<double>();
        return list;
    }
    if (!value.is_array() || value.size() != count) return wrong();
    for (std::size_t i = 0; i < count; ++i) {
        if (!value[i].is_number()) return wrong();
        list[i] = value[i].get<double>();
    }
    return list;
}

Parsed<Shape> shape_of(const json& value) {
    if (!value.is_object() || value.size() != 1)
        return tl::unexpected(
            std::string(R"("shape" must be an object with one shape, such as {"ellipsoid":[0.4,0.9,0.4]})"));
    const std::string& name = value.begin().key();
    const ShapeKind* kind = find_shape_kind(name);
    if (kind == nullptr)
        return tl::unexpected(fmt::format("there is no shape '{}'; the shapes are {}", name, known_shapes()));
    const Parsed<std::array<double, 4>> dimensions =
        numbers(value.begin().value(), name, kind->count, fmt::format("[{}]", kind->dimensions));
    if (!dimensions) return tl::unexpected(dimensions.error());
    return kind->make(dimensions->data());
}

Parsed<dvec3> vector_of(const json& object, const char* name) {
    const auto found = object.find(name);
    if (found == object.end()) return tl::unexpected(fmt::format(R"("{}" is missing: write "{}":[x,y,z])", name, name));
    const Parsed<std::array<double, 4>> list = numbers(*found, name, 3, "[x,y,z]");
    if (!list) return tl::unexpected(list.error());
    return dvec3((*list)[0], (*list)[1], (*list)[2]);
}

Parsed<SweepQuery> query_of(const json& object, const QueryDefaults& defaults) {
    for (const auto& [name, value] : object.items())
        if (name != "shape" && name != "from" && name != "to" && name != "rotate" && name != "one_sided")
            return tl::unexpected(fmt::format(
                R"("{}" means nothing here; the names are "shape", "from", "to", "rotate" and "one_sided")", name));
    SweepQuery query{.volume = {}, .motion = {}, .one_sided = defaults.one_sided};
    query.volume.orientation = defaults.rotate;
    if (const auto found = object.find("shape"); found != object.end()) {
        const Parsed<Shape> shape = shape_of(*found);
        if (!shape) return tl::unexpected(shape.error());
        query.volume.shape = *shape;
    } else if (defaults.shape) {
        query.volume.shape = *defaults.shape;
    } else {
        return tl::unexpected(
            std::string(R"("shape" is missing: write "shape":{"ellipsoid":[rx,ry,rz]} or give --shape)"));
    }
    const Parsed<dvec3> from = vector_of(object, "from");
    if (!from) return tl::unexpected(from.error());
    const Parsed<dvec3> to = vector_of(object, "to");
    if (!to) return tl::unexpected(to.error());
    query.motion = {*from, *to};
    if (const auto found = object.find("rotate"); found != object.end()) {
        const Parsed<std::array<double, 4>> q = numbers(*found, "rotate", 4, "[w,x,y,z]");
        if (!q) return tl::unexpected(q.error());
        query.volume.orientation = dquat((*q)[0], (*q)[1], (*q)[2], (*q)[3]);
    }
    if (const auto found = object.find("one_sided"); found != object.end()) {
        if (!found->is_boolean()) return tl::unexpected(std::string(R"("one_sided" must be true or false)"));
        query.one_sided = found->get<bool>();
    }
    return query;
}

}  // namespace

std::optional<std::string> complaint(const Volume& volume) {
    const ShapeParts parts = parts_of(volume.shape);
    double least = largest_dimension;
    double most = smallest_dimension;
    for (std::size_t i = 0; i < parts.count; ++i) {
        const double d = parts.dimensions[i];
        if (!(d >= smallest_dimension && d <= largest_dimension))
            return fmt::format("{}: every dimension must lie between 1e-6 and 1e6 metres", to_text(volume.shape));
        least = std::min(least, d);
        most = std::max(most, d);
    }
    if (most > largest_ratio * least)
        return fmt::format("{}: the largest dimension may be at most 1e4 times the smallest", to_text(volume.shape));
    const dquat& q = volume.orientation;
    const bool finite = std::isfinite(q.w) && std::isfinite(q.x) && std::isfinite(q.y) && std::isfinite(q.z);
    if (!finite || (q.w == 0 && q.x == 0 && q.y == 0 && q.z == 0))
        return std::string("rotate: a quaternion w,x,y,z must be finite and not all zero; 1,0,0,0 is upright");
    if (!is_valid(volume)) return std::string("rotate: the quaternion is too large or too small; scale it to length 1");
    return std::nullopt;
}

std::optional<std::string> complaint(std::string_view name, const dvec3& position) {
    for (const double x : {position.x, position.y, position.z})
        if (!(std::abs(x) <= coordinate_limit))
            return fmt::format("{}: every coordinate must lie within -1e9 and 1e9 metres", name);
    return std::nullopt;
}

Parsed<SweepQuery> parse_query(std::string_view line, const QueryDefaults& defaults) {
    if (line.find_first_not_of(" \t\r") == line.npos)
        return tl::unexpected(std::string("empty: every line must be a query, so that answer N belongs to line N"));
    const Parsed<json> object = parse_json(line);
    if (!object) return tl::unexpected(object.error());
    Parsed<SweepQuery> query = query_of(*object, defaults);
    if (!query) return query;
    for (const auto& wrong :
         {complaint(query->volume), complaint("from", query->motion.from), complaint("to", query->motion.to)})
        if (wrong) return tl::unexpected(*wrong);
    return query;
}

std::string_view word(Feature feature) {
    switch (feature) {
        case Feature::face:
            return "face";
        case Feature::edge:
            return "edge";
        case Feature::vertex:
            break;
    }
    return "vertex";
}

void append_answer(std::string& out, const std::optional<Hit>& hit) {
    if (!hit) {
        out += R"({"hit":false})";
        return;
    }
    out += R"({"hit":true,"t":)";
    append_number(out, hit->t);
    out += R"(,"point":)";
    append_array(out, hit->point);
    out += R"(,"normal":)";
    append_array(out, hit->normal);
    out += R"(,"feature":")";
    out += word(hit->feature);
    out += R"(","triangle":)";
    append_number(out, hit->triangle);
    out += R"(,"started_inside":)";
    out += hit->started_inside ? "true}" : "false}";
}

void append_error(std::string& out, std::uint64_t line, std::string_view what) {
    out += R"({"error":)";
    out += json_string(fmt::format("line {}: {}", line, what));
    out += '}';
}

std::string json_string(std::string_view text) {
    return json(std::string(text)).dump(-1, ' ', false, json::error_handler_t::replace);
}

}  // namespace surefoot::tools
