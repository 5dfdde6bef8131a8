#include <algorithm>
#include <fmt/format.h>

#include "playtest/report/report_parts.hpp"
#include "playtest/vectors.hpp"

namespace surefoot::playtest {
namespace {

constexpr double frame_scale = 10;  // pixels a metre
constexpr double frame_wide = 214;  // pixels
constexpr double frame_high = 150;

std::string dot(double x, double y, double radius, const std::string& colour, const std::string& title) {
    return fmt::format(
        "<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\" fill=\"{}\" fill-opacity=\".75\" stroke=\"#fff\" "
        "stroke-width=\".7\"><title>{}</title></circle>",
        x, y, radius, colour, title);
}

}  // namespace

std::string colour_of(Incident::Kind kind) {
    switch (kind) {
        case Incident::Kind::death:
            return "#b3261e";
        case Incident::Kind::failed_jump:
            return "#d98500";
        case Incident::Kind::stuck:
            return "#7b1fa2";
        default:
            break;
    }
    return "#000";
}

std::string title_of(const Findings& of, const Incident& incident) {
    std::string title(name_of(incident.kind));
    if (incident.cause != game::Cause::none) title += ": " + std::string(game::sentence(incident.cause));
    if (!incident.note.empty()) title += ": " + incident.note;
    const std::size_t section = std::min<std::size_t>(incident.section, of.level->checkpoints.size() - 1);
    return title + ", in " + of.level->checkpoints[section].section;
}

std::string from_above(const Incident& incident, const PlanFrame& plan, std::size_t level) {
    const double zoom = frame_scale / plan.scale;
    const double left = plan.x(incident.place) * zoom - frame_wide / 2;
    const double top = plan.y(incident.place) * zoom - frame_high / 2;
    std::string trail;
    for (const dvec3& place : incident.trail)
        trail += fmt::format("{:.1f},{:.1f} ", plan.x(place) * zoom - left, plan.y(place) * zoom - top);
    return fmt::format(
        "<div class=\"from-above p{}\" style=\"background-size:{:.0f}px {:.0f}px;background-position:{:.0f}px "
        "{:.0f}px\"><svg width=\"{:.0f}\" "
        "height=\"{:.0f}\"><polyline points=\"{}\" fill=\"none\" stroke=\"#0a58ca\" stroke-width=\"2\"/>{}</svg></div>",
        level, plan.width * zoom, plan.height * zoom, -left, -top, frame_wide, frame_high, trail,
        dot(frame_wide / 2, frame_high / 2, 5, colour_of(incident.kind), ""));
}

std::string escaped(std::string_view text) {
    std::string out;
    for (const char c : text) {
        if (c == '<')
            out += "&lt;";
        else if (c == '>')
            out += "&gt;";
        else if (c == '&')
            out += "&amp;";
        else if (c == '"')
            out += "&quot;";
        else
            out += c;
    }
    return out;
}

void add_plans(std::string& out, const Findings& of, const PlanFrame& frame, std::size_t level) {
    out += fmt::format("<style>.p{}{{background-image:url({})}}</style>\n<div class=\"plans\">", level,
                       plan_picture(*of.level, frame));
    std::string marks;
    for (const game::Checkpoint& checkpoint : of.level->checkpoints)
        marks += dot(frame.x(checkpoint.feet), frame.y(checkpoint.feet), 4, "#18723a", escaped(checkpoint.section));
    marks += dot(frame.x(of.level->goal), frame.y(of.level->goal), 6, "#18723a", "the goal");
    for (const std::uint32_t pickup : of.never_taken) {
        const dvec3 place = of.level->pickups[pickup].place;
        marks += dot(frame.x(place), frame.y(place), 3, "#e0b400",
                     fmt::format("never taken: {}", game::name_of(of.level->pickups[pickup].kind)));
    }
    for (const PlayedRun& run : of.runs)
        for (const Incident& incident : run.telemetry.incidents)
            marks += dot(frame.x(incident.place), frame.y(incident.place), 3, colour_of(incident.kind),
                         escaped(title_of(of, incident)));
    HeatMap stood;
    HeatMap looked;
    for (const PlayedRun& run : of.runs) {
        for (const auto& [cell, count] : run.telemetry.stood) stood[cell] += count;
        for (const auto& [cell, count] : run.telemetry.looked) looked[cell] += count;
    }
    const auto figure = [&](const std::string& caption, const std::string& inside) {
        out += fmt::format(
            "<figure><div class=\"plan p{}\" style=\"width:{}px;height:{}px\"><svg width=\"{}\" "
            "height=\"{}\">{}</svg></div><figcaption>{}</figcaption></figure>\n",
            level, frame.width, frame.height, frame.width, frame.height, inside, caption);
    };
    const auto heat = [&](const HeatMap& map) {
        return fmt::format("<image width=\"{}\" height=\"{}\" href=\"{}\"/>", frame.width, frame.height,
                           heat_picture(map, frame));
    };
    figure(
        "Deaths red, failed jumps orange, stuck violet, checkpoints and goal green, never taken yellow. North is up.",
        marks);
    figure("Where they stood", heat(stood));
    figure("Where they looked", heat(looked));
    out += "</div>\n";
}

}  // namespace surefoot::playtest
