#include <algorithm>
#include <fmt/format.h>

#include "playtest/report_parts.hpp"
#include "playtest/vectors.hpp"

namespace surefoot::playtest {
namespace {

constexpr std::size_t most_incidents = 80;  // of a level, on the page
constexpr std::size_t most_of_a_kind = 20;  // deaths are many
constexpr double frame_scale = 10;          // pixels a metre
constexpr double frame_wide = 214;          // pixels
constexpr double frame_high = 150;

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

std::string dot(double x, double y, double radius, const std::string& colour, const std::string& title) {
    return fmt::format(
        "<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\" fill=\"{}\" fill-opacity=\".75\" stroke=\"#fff\" "
        "stroke-width=\".7\"><title>{}</title></circle>",
        x, y, radius, colour, title);
}

std::string title_of(const Findings& of, const Incident& incident) {
    std::string title(name_of(incident.kind));
    if (incident.cause != game::Cause::none) title += ": " + std::string(game::sentence(incident.cause));
    if (!incident.note.empty()) title += ": " + incident.note;
    const std::size_t section = std::min<std::size_t>(incident.section, of.level->checkpoints.size() - 1);
    return title + ", in " + of.level->checkpoints[section].section;
}

// Where it happened from near by, with the trail that led there.
std::string frame_of(const Incident& incident, const PlanFrame& plan, std::size_t level) {
    const double zoom = frame_scale / plan.scale;
    const double left = plan.x(incident.place) * zoom - frame_wide / 2;
    const double top = plan.y(incident.place) * zoom - frame_high / 2;
    std::string trail;
    for (const dvec3& place : incident.trail)
        trail += fmt::format("{:.1f},{:.1f} ", plan.x(place) * zoom - left, plan.y(place) * zoom - top);
    return fmt::format(
        "<div class=\"frame p{}\" style=\"background-size:{:.0f}px {:.0f}px;background-position:{:.0f}px "
        "{:.0f}px\"><svg width=\"{:.0f}\" "
        "height=\"{:.0f}\"><polyline points=\"{}\" fill=\"none\" stroke=\"#0a58ca\" stroke-width=\"2\"/>{}</svg></div>",
        level, plan.width * zoom, plan.height * zoom, -left, -top, frame_wide, frame_high, trail,
        dot(frame_wide / 2, frame_high / 2, 5, colour_of(incident.kind), ""));
}

}  // namespace

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

void add_incidents(Report& report, const Findings& of, const PlanFrame& frame, std::size_t level,
                   const std::string& folder) {
    struct Item {
        std::size_t run = 0;
        std::size_t incident = 0;
    };
    std::string& out = report.html;
    std::vector<Item> items;
    std::size_t all = 0;
    for (const auto kind : {Incident::Kind::not_a_number, Incident::Kind::escape, Incident::Kind::overflow,
                            Incident::Kind::stuck, Incident::Kind::failed_jump, Incident::Kind::death}) {
        std::size_t count = 0;
        for (std::size_t run = 0; run < of.runs.size(); ++run)
            for (std::size_t i = 0; i < of.runs[run].telemetry.incidents.size(); ++i) {
                if (of.runs[run].telemetry.incidents[i].kind != kind) continue;
                ++all;
                if (++count <= most_of_a_kind && items.size() < most_incidents) items.push_back({run, i});
            }
    }
    out += fmt::format(
        "<h3>Incidents</h3><p class=dim>{} of {}. A replay is a file for the game's own player: "
        "<code>surefoot-platformer FILE</code>; a step is for <code>surefoot replay FILE</code>.</p>"
        "<div class=\"incidents\">\n",
        items.size(), all);
    std::vector<std::size_t> kept_runs;
    for (const Item& item : items) {
        const Telemetry& told = of.runs[item.run].telemetry;
        const Incident& incident = told.incidents[item.incident];
        const std::string stem = fmt::format("{}-{}-{}", of.level->id, told.player, item.run + 1);
        std::string links;
        if (!of.runs[item.run].recording.inputs.empty()) {
            if (std::ranges::find(kept_runs, item.run) == kept_runs.end()) {
                kept_runs.push_back(item.run);
                report.files.push_back({.name = stem + ".run", .level = level, .run = item.run});
            }
            links += fmt::format(" <a href=\"{0}/{1}.run\">replay</a> from {2:.1f} s", escaped(folder), escaped(stem),
                                 double(incident.tick) * game::tick_seconds);
        }
        if (incident.capture) {
            const std::string name = fmt::format("{}-step-{}.json", stem, item.incident + 1);
            report.files.push_back({.name = name, .level = level, .run = item.run, .incident = item.incident});
            links += fmt::format(" <a href=\"{}/{}\">step</a>", escaped(folder), escaped(name));
        }
        out += fmt::format("<div class=\"incident\">{}<b>{}</b><br>({:.1f}, {:.1f}, {:.1f}) by {}.{}</div>\n",
                           frame_of(incident, frame, level), escaped(title_of(of, incident)), incident.place.x,
                           incident.place.y, incident.place.z, escaped(told.player), links);
    }
    out += "</div>\n";
}

}  // namespace surefoot::playtest
