#include <nlohmann/json.hpp>

#include "playtest/telemetry.hpp"

namespace surefoot::playtest {
namespace {

using nlohmann::json;

json point(const dvec3& v) {
    const auto centimetres = [](double x) { return std::isfinite(x) ? std::round(x * 100) / 100 : 0; };
    return json::array({centimetres(v.x), centimetres(v.y), centimetres(v.z)});
}

dvec3 point_of(const json& from) {
    return {from.at(0).get<double>(), from.at(1).get<double>(), from.at(2).get<double>()};
}

json heat(const HeatMap& map) {
    json cells = json::array();
    for (const auto& [cell, count] : map) cells.push_back({cell[0], cell[1], count});
    return cells;
}

HeatMap heat_of(const json& from) {
    HeatMap map;
    for (const json& cell : from) map[{cell.at(0).get<int>(), cell.at(1).get<int>()}] = cell.at(2).get<std::uint32_t>();
    return map;
}

}  // namespace

std::string to_json(const Telemetry& telemetry) {
    json out{{"format", "surefoot telemetry 1"},
             {"level", telemetry.level},
             {"player", telemetry.player},
             {"won", telemetry.won},
             {"seconds", telemetry.seconds},
             {"begun_in", telemetry.begun_in},
             {"section", telemetry.section},
             {"section_seconds", telemetry.section_seconds},
             {"section_deaths", telemetry.section_deaths},
             {"section_reached", telemetry.section_reached},
             {"taken", telemetry.taken},
             {"jumps", telemetry.jumps},
             {"presses", telemetry.presses},
             {"gave_up", telemetry.gave_up},
             {"stood", heat(telemetry.stood)},
             {"looked", heat(telemetry.looked)}};
    json& incidents = out["incidents"] = json::array();
    for (const Incident& incident : telemetry.incidents) {
        json trail = json::array();
        for (const dvec3& place : incident.trail) trail.push_back(point(place));
        incidents.push_back({{"kind", int(incident.kind)},
                             {"what", std::string(name_of(incident.kind))},
                             {"cause", int(incident.cause)},
                             {"section", incident.section},
                             {"tick", incident.tick},
                             {"place", point(incident.place)},
                             {"trail", std::move(trail)},
                             {"note", incident.note}});
    }
    return out.dump();
}

Expected<Telemetry> telemetry_of(const std::string& text, const std::string& file) {
    Telemetry told;
    try {
        const json from = json::parse(text);
        if (from.at("format").get<std::string>() != "surefoot telemetry 1")
            return tl::unexpected(Error{ErrorCode::unsupported, file + ": telemetry of another version", file, 0});
        told.level = from.at("level").get<std::string>();
        told.player = from.at("player").get<std::string>();
        told.won = from.at("won").get<bool>();
        told.seconds = from.at("seconds").get<double>();
        told.begun_in = from.value("begun_in", 0U);  // older ones all began at the spawn
        told.section = from.at("section").get<std::uint32_t>();
        told.section_seconds = from.at("section_seconds").get<std::vector<double>>();
        told.section_deaths = from.at("section_deaths").get<std::vector<std::uint32_t>>();
        told.section_reached = from.at("section_reached").get<std::vector<bool>>();
        told.taken = from.at("taken").get<std::vector<std::uint32_t>>();
        told.jumps = from.at("jumps").get<std::uint64_t>();
        told.presses = from.at("presses").get<std::uint64_t>();
        told.gave_up = from.at("gave_up").get<std::string>();
        told.stood = heat_of(from.at("stood"));
        told.looked = heat_of(from.at("looked"));
        for (const json& item : from.at("incidents")) {
            Incident incident;
            const int kind = item.at("kind").get<int>();
            const int cause = item.at("cause").get<int>();
            if (kind < 0 || kind > int(Incident::Kind::overflow) || cause < 0 || cause > int(game::Cause::gave_up))
                return tl::unexpected(Error{ErrorCode::unreadable, file + ": an incident of no known kind", file, 0});
            incident.kind = Incident::Kind(kind);
            incident.cause = game::Cause(cause);
            incident.section = item.at("section").get<std::uint32_t>();
            incident.tick = item.at("tick").get<std::uint64_t>();
            incident.place = point_of(item.at("place"));
            for (const json& place : item.at("trail")) incident.trail.push_back(point_of(place));
            incident.note = item.at("note").get<std::string>();
            told.incidents.push_back(std::move(incident));
        }
    } catch (const json::exception& error) {
        return tl::unexpected(Error{ErrorCode::unreadable, file + ": not telemetry: " + error.what(), file, 0});
    }
    return told;
}

}  // namespace surefoot::playtest
