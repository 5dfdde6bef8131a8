// The incidents of a level on the page: one card a place. Runs are played again for those of which frames are drawn.
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <map>
#include <set>

#include "playtest/report/exhibit.hpp"
#include "playtest/report/incident_groups.hpp"
#include "playtest/report/report_parts.hpp"
#include "playtest/vectors.hpp"

namespace surefoot::playtest {
namespace {

constexpr std::size_t most_cards = 30;  // places of a level, on the page
constexpr std::uint64_t lead_in = 240;  // ticks before the moment, from which a replay is watched
constexpr std::size_t mover_every = 3;  // samples of a clip
constexpr const char* run_type = "data:application/octet-stream;base64,";

double seconds_of(std::uint64_t tick) {
    return double(tick) * game::tick_seconds;
}

long centimetres(double metres) {
    return std::lround(std::clamp(metres, -1e5, 1e5) * 100);
}

// In centimetres and whole degrees: a clip is small beside the frames.
std::string json_of(const Clip& clip) {
    constexpr double degree = 3.14159265358979323846 / 180;
    const auto append = [](std::string& out, const dvec3& place, double degrees) {
        out += fmt::format("{}{},{},{},{}", out.back() == '[' ? "" : ",", centimetres(place.x), centimetres(place.y),
                           centimetres(place.z), std::lround(degrees));
    };
    std::string out = fmt::format(R"({{"t":{:.3f},"dt":{:.5f},"p":[)", seconds_of(clip.first_tick),
                                  double(clip_every) * game::tick_seconds);
    for (std::size_t i = 0; i < clip.feet.size(); ++i) append(out, clip.feet[i], clip.looks[i]);
    out += R"(],"m":[)";
    for (const ClipMover& mover : clip.movers) {
        std::string places = "[";
        const bool stands = std::ranges::all_of(mover.places, [&](const dvec3& p) { return p == mover.places[0]; }) &&
                            std::ranges::all_of(mover.yaws, [&](double yaw) { return yaw == mover.yaws[0]; });
        for (std::size_t i = 0; i < (stands ? 1 : mover.places.size()); i += mover_every)
            append(places, mover.places[i], mover.yaws[i] / degree);
        out += fmt::format(R"({}{{"e":{},"w":{:.2f},"d":{:.2f},"n":{},"p":{}]}})", out.back() == '[' ? "" : ",",
                           mover.is_enemy ? 1 : 0, mover.half.x, mover.half.z, mover_every, places);
    }
    return out + "]}";
}

class IncidentsWriter {
public:
    IncidentsWriter(Report& report, const Findings& of, const PlanFrame& plan, const IncidentsPart& part)
        : report_(report), of_(of), plan_(plan), part_(part), groups_(group_incidents(of)), room_(part.room) {}

    void write() {
        play_again();
        for (std::size_t i = 0; i < std::min(most_cards, groups_.size()); ++i) add_card(groups_[i]);
        report_.html += "<h3>Incidents</h3>" + summary();
        report_.html += fmt::format(
            "<div class=\"incidents\" data-plan=\"p{}\" data-west=\"{:.3f}\" data-north=\"{:.3f}\" "
            "data-scale=\"{:.4f}\">\n{}</div>\n",
            part_.level, plan_.west, plan_.north, plan_.scale, cards_);
        if (!replays_.empty()) report_.html += "<h4>Replays</h4><ul>" + replays_ + "</ul>\n";
    }

private:
    // Each run once, for all of its incidents of which there shall be frames.
    void play_again() {
        std::map<std::size_t, std::vector<const IncidentGroup*>> by_run;
        int framed = 0;
        for (const IncidentGroup& group : groups_) {
            if (framed >= part_.framed) break;
            if (of_.runs[group.shown.run].recording.inputs.empty()) continue;
            by_run[group.shown.run].push_back(&group);
            ++framed;
        }
        if (by_run.empty()) return;
        const FramePainter painter(*of_.level);
        std::size_t done = 0;
        for (const auto& [run, groups] : by_run) {
            std::vector<Incident> incidents;
            for (const IncidentGroup* group : groups) incidents.push_back(incident_of(of_, group->shown));
            auto made = exhibits_of(of_.level, of_.runs[run].recording, incidents, painter);
            for (std::size_t i = 0; made && i < groups.size(); ++i) exhibits_[groups[i]] = std::move((*made)[i]);
            if (!made) not_drawn_ = made.error().text;
            part_.progress(double(++done) / double(by_run.size()));
        }
    }

    [[nodiscard]] bool takes_room(std::size_t bytes) {
        if (bytes > room_) return false;
        room_ -= bytes;
        return true;
    }

    // The frames, or nothing where they find no room.
    [[nodiscard]] std::string frames_of(const Exhibit& exhibit, const std::string& title) {
        std::string aside;
        std::string largest;
        for (const Still& still : exhibit.stills) {
            const Still& moment = exhibit.stills[exhibit.moment];
            std::string caption = fmt::format("{:.1f} s", seconds_of(still.tick));
            if (still.tick < moment.tick)
                caption = fmt::format("{:.1f} s before", seconds_of(moment.tick - still.tick));
            if (still.tick > moment.tick) caption = fmt::format("{:.1f} s later", seconds_of(still.tick - moment.tick));
            (&still == &moment ? largest : aside) += fmt::format(
                "<figure><img width=\"{}\" height=\"{}\" alt=\"{}\" src=\"{}\"><figcaption>{}</figcaption></figure>",
                still.picture.width, still.picture.height, title, data_uri(still.picture), caption);
        }
        std::string all = fmt::format("{}<div class=\"aside\">{}</div>", largest, aside);
        if (exhibit.stills.empty() || !takes_room(all.size())) return {};
        ++framed_;
        return all;
    }

    // A link to a file: held by the page where it finds room, else beside it.
    [[nodiscard]] std::string file_link(const std::string& name, std::string bytes, const std::string& id,
                                        const std::string& about) {
        std::string data = run_type + base64(bytes);
        if (takes_room(data.size()))
            return fmt::format("<li><a id=\"{}\" download=\"{}\" href=\"{}\">{}</a>{}</li>\n", id, escaped(name), data,
                               escaped(name), about);
        report_.files.push_back({.name = name, .bytes = std::move(bytes)});
        ++beside_;
        return fmt::format("<li><a id=\"{}\" href=\"{}/{}\">{}</a>{}, beside this page</li>\n", id,
                           escaped(part_.folder), escaped(name), escaped(name), about);
    }

    // The replay of an incident's run, which is in the list once, and the step of a stuck moment.
    [[nodiscard]] std::string links_of(const IncidentAt& at, const Incident& incident) {
        const PlayedRun& run = of_.runs[at.run];
        const std::string stem = fmt::format("{}-{}-{}", of_.level->id, run.telemetry.player, at.run + 1);
        std::string links;
        if (!run.recording.inputs.empty()) {
            const std::string id = fmt::format("run-{}-{}", part_.level, at.run);
            if (listed_.insert(at.run).second)
                replays_ += file_link(stem + ".run", game::to_bytes(run.recording), id,
                                      fmt::format(", {:.0f} s", run.telemetry.seconds));
            const std::uint64_t from = incident.tick > lead_in ? incident.tick - lead_in : 0;
            links += fmt::format(
                "<br><a href=\"#{0}\" data-run=\"{0}\">replay</a> <code>surefoot-platformer "
                "{1}.run --from {2:.1f}</code>",
                id, escaped(stem), seconds_of(from));
        }
        if (incident.capture) {
            const std::string id = fmt::format("step-{}-{}-{}", part_.level, at.run, at.incident);
            const std::string name = fmt::format("{}-step-{}.json", stem, at.incident + 1);
            replays_ += file_link(name, capture_text(*incident.capture), id, ", the step of a stuck moment");
            links += fmt::format("<br><a href=\"#{0}\" data-run=\"{0}\">step</a> <code>surefoot replay {1}</code>", id,
                                 escaped(name));
        }
        return links;
    }

    void add_card(const IncidentGroup& group) {
        const Incident& incident = incident_of(of_, group.shown);
        const std::string title = escaped(title_of(of_, incident));
        const auto exhibit = exhibits_.find(&group);
        std::string shown;
        if (exhibit != exhibits_.end()) shown = frames_of(exhibit->second, title);
        const bool is_large = !shown.empty();
        const std::string plan = from_above(incident, plan_, part_.level);
        if (is_large)
            shown += fmt::format("<div class=\"clip\" data-clip='{}'>{}</div>", json_of(exhibit->second.clip), plan);
        else
            shown = plan;
        const std::string often =
            group.members.size() > 1 ? fmt::format(" <b>{} times</b>", group.members.size()) : std::string();
        cards_ += fmt::format(
            "<div class=\"incident{}\">{}<p><b>{}</b>{}<br>({:.1f}, {:.1f}, {:.1f}) at {:.1f} s of {}{}</p></div>\n",
            is_large ? "" : " small", shown, title, often, incident.place.x, incident.place.y, incident.place.z,
            seconds_of(incident.tick), escaped(of_.runs[group.shown.run].telemetry.player),
            links_of(group.shown, incident));
        ++cards_count_;
        incidents_shown_ += group.members.size();
    }

    // What the page shows of all that happened, and what it leaves out.
    [[nodiscard]] std::string summary() const {
        std::size_t incidents = 0;
        for (const IncidentGroup& group : groups_) incidents += group.members.size();
        if (groups_.empty()) return "<p>None.</p>\n";
        std::string out = fmt::format(
            "<p class=dim>{} at {} places; one of each place is shown, what has to be looked at first in front. {} "
            "with "
            "frames and the last ten seconds",
            incidents, groups_.size(), framed_);
        if (cards_count_ > framed_) out += fmt::format(", {} without", cards_count_ - framed_);
        out += '.';
        if (incidents > incidents_shown_)
            out +=
                fmt::format(" Left out: {} at {} places.", incidents - incidents_shown_, groups_.size() - cards_count_);
        if (beside_ > 0)
            out += fmt::format(" Files that would have made this page too long lie beside it: {}, in {}.", beside_,
                               escaped(part_.folder));
        if (!not_drawn_.empty()) out += fmt::format(" Some frames could not be drawn: {}.", escaped(not_drawn_));
        return out + " Dots are where the hero came from.</p>\n";
    }

    Report& report_;
    const Findings& of_;
    const PlanFrame& plan_;
    const IncidentsPart& part_;
    std::vector<IncidentGroup> groups_;
    std::map<const IncidentGroup*, Exhibit> exhibits_;
    std::size_t room_;
    std::string cards_;
    std::string replays_;
    std::set<std::size_t> listed_;  // runs
    std::string not_drawn_;
    std::size_t framed_ = 0;
    std::size_t cards_count_ = 0;
    std::size_t incidents_shown_ = 0;
    std::size_t beside_ = 0;
};

}  // namespace

void add_incidents(Report& report, const Findings& of, const PlanFrame& frame, const IncidentsPart& part) {
    IncidentsWriter(report, of, frame, part).write();
}

}  // namespace surefoot::playtest
