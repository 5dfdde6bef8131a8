#include "markers.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <string>

namespace surefoot::internal::quake3 {
namespace {

/// From the origin of a player to its feet.
constexpr double feet = 24;
constexpr double usual_gravity = 800;  // units a second, a second; the world may have another

bool is_finite(const dvec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// Text as JSON. The game's letters are bytes; what is no ASCII is told as Latin-1.
void append_text(std::string& json, std::string_view text) {
    constexpr std::string_view digits = "0123456789abcdef";
    json += '"';
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (c == '"' || c == '\\') {
            json += '\\';
            json += c;
        } else if (byte < 0x20 || byte >= 0x7f) {
            json += "\\u00";
            json += digits[byte >> 4];
            json += digits[byte & 15];
        } else {
            json += c;
        }
    }
    json += '"';
}

void append_number(std::string& json, double value) {
    std::array<char, 40> text{};
    json.append(text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr);
}

void append_vector(std::string& json, std::string_view name, const dvec3& v) {
    json += ",\"";
    json += name;
    json += "\":[";
    append_number(json, v.x);
    json += ',';
    append_number(json, v.y);
    json += ',';
    append_number(json, v.z);
    json += ']';
}

struct Place {
    dvec3 middle{0, 0, 0};
    std::optional<dvec3> half_extents;  ///< of a trigger or mover
};

class MarkerMaker {
public:
    MarkerMaker(const Map& map, const std::vector<Entity>& entities, const Placement& placement)
        : map_(map), placement_(placement) {
        for (const Entity& entity : entities) {
            const std::string_view name = entity.value("targetname");
            // The game takes one at random when several have the name; the first is as good.
            if (!name.empty()) targets_.try_emplace(name, &entity);
            if (entity.value("classname") == "worldspawn") gravity_ = entity.number("gravity").value_or(usual_gravity);
        }
    }

    ImportedMarker marker(const Entity& entity) const {
        const std::string_view class_name = entity.value("classname");
        const std::string_view kind = kind_of(class_name);
        const Place place = place_of(entity);
        ImportedMarker result;
        result.name = class_name;
        result.kind = kind;
        result.position = placement_.position(stands(kind) ? on_floor(place.middle) : place.middle);
        if (!is_finite(result.position)) result.position = dvec3(0, 0, 0);
        result.orientation = orientation_of(entity, kind);

        std::string& extras = result.extras;
        if (!kind.empty()) {
            extras = "\"surefoot\":{\"kind\":";
            append_text(extras, kind);
            if (place.half_extents) append_vector(extras, "half_extents", size_of(*place.half_extents));
            if (const auto target = targets_.find(entity.value("target")); target != targets_.end())
                append_target(extras, kind, place.middle, place_of(*target->second).middle);
            extras += "},";
        }
        extras = "{" + extras + "\"quake3\":{";
        for (const auto& [key, value] : entity.pairs) {
            if (extras.back() != '{') extras += ',';
            append_text(extras, key);
            extras += ':';
            append_text(extras, value);
        }
        extras += "}}";
        return result;
    }

private:
    static bool stands(std::string_view kind) { return kind == "spawn" || kind == "destination"; }
    static dvec3 on_floor(const dvec3& origin) { return {origin.x, origin.y, origin.z - feet}; }

    [[nodiscard]] Place place_of(const Entity& entity) const {
        Place place{.middle = entity.vector("origin").value_or(dvec3(0, 0, 0)), .half_extents = {}};
        if (const auto number = entity.model(map_.models.size())) {
            const Model& model = map_.models[*number];
            const dvec3 min(model.min);
            const dvec3 max(model.max);
            if (is_finite(min) && is_finite(max)) {
                place.middle += (min + max) / 2.0;
                place.half_extents = (max - min) / 2.0;
            }
        }
        return place;
    }

    /// Extents have no sign to turn.
    [[nodiscard]] dvec3 size_of(const dvec3& half_extents) const {
        return placement_.factors(half_extents) * placement_.scale;
    }

    /// A yaw of 0 looks along the file's +X; our own front is +Z, so that a quarter turn comes first.
    [[nodiscard]] dquat orientation_of(const Entity& entity, std::string_view kind) const {
        std::optional<double> yaw = entity.number("angle");
        if (const auto angles = entity.vector("angles")) yaw = angles->y;
        if (!yaw && stands(kind)) yaw = 0;
        if (!yaw) return {1, 0, 0, 0};
        constexpr double half_degree = 3.14159265358979323846 / 360;
        const double half = std::fmod(*yaw, 360) * half_degree;
        const double root_half = std::sqrt(0.5);
        const dquat turn = placement_.orientation({std::cos(half), 0, 0, std::sin(half)});
        return turn * dquat(root_half, 0, root_half, 0);
    }

    void append_target(std::string& extras, std::string_view kind, const dvec3& from, const dvec3& to) const {
        if (kind == "teleporter") {
            append_vector(extras, "target", placement_.position(on_floor(to)));
        } else if (kind == "jump_pad") {
            append_vector(extras, "target", placement_.position(to));
            // Thrown so that the target is the highest point of the flight: v^2 / 2 g = height.
            const double height = to.z - from.z;
            if (!(height > 0) || !(gravity_ > 0)) return;
            const double rise = std::sqrt(2 * height / gravity_);
            const dvec3 velocity =
                placement_.position({(to.x - from.x) / rise, (to.y - from.y) / rise, gravity_ * rise});
            if (!is_finite(velocity)) return;
            append_vector(extras, "velocity", velocity);
            extras += ",\"gravity\":";
            append_number(extras, gravity_ * placement_.scale);
        }
    }

    const Map& map_;
    Placement placement_;
    std::map<std::string_view, const Entity*, std::less<>> targets_;
    double gravity_ = usual_gravity;
};

}  // namespace

std::string_view kind_of(std::string_view class_name) {
    if (class_name == "info_player_intermission") return "view";
    if (class_name == "trigger_push") return "jump_pad";
    if (class_name == "trigger_teleport") return "teleporter";
    if (class_name == "misc_teleporter_dest") return "destination";
    if (class_name == "trigger_hurt") return "hurt";
    for (const std::string_view start :
         {"team_CTF_redplayer", "team_CTF_blueplayer", "team_CTF_redspawn", "team_CTF_bluespawn"}) {
        if (class_name == start) return "spawn";
    }
    for (const std::string_view mover :
         {"func_door", "func_plat", "func_button", "func_bobbing", "func_train", "func_rotating", "func_pendulum"}) {
        if (class_name == mover) return "mover";
    }
    constexpr std::array<std::pair<std::string_view, std::string_view>, 7> beginnings{{{"info_player_", "spawn"},
                                                                                       {"item_", "item"},
                                                                                       {"weapon_", "item"},
                                                                                       {"ammo_", "item"},
                                                                                       {"holdable_", "item"},
                                                                                       {"team_CTF_", "item"},
                                                                                       {"trigger_", "trigger"}}};
    for (const auto& [beginning, kind] : beginnings) {
        if (class_name.starts_with(beginning)) return kind;
    }
    return {};
}

std::vector<ImportedMarker> markers_of(const Map& map, const std::vector<Entity>& entities,
                                       const Placement& placement) {
    const MarkerMaker maker(map, entities, placement);
    std::vector<ImportedMarker> markers;
    for (const Entity& entity : entities) {
        if (entity.value("classname") != "worldspawn") markers.push_back(maker.marker(entity));
    }
    return markers;
}

}  // namespace surefoot::internal::quake3
