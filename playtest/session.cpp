#include "playtest/session.hpp"

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "game/whole_file.hpp"

namespace surefoot::playtest {
namespace {

using nlohmann::json;
constexpr const char* format = "surefoot session 1";

// A name of a file beside session.json, and nothing that leads elsewhere.
bool is_plain_name(const std::string& name) {
    return !name.empty() && name.find_first_of("/\\:") == std::string::npos && name.front() != '.';
}

}  // namespace

Expected<void> write_session(const Session& session) {
    json notes = json::array();
    for (const SessionNote& note : session.notes)
        notes.push_back({{"run", note.run}, {"seconds", note.seconds}, {"text", note.text}});
    const StartForm& start = session.start;
    const Questionnaire& answers = session.answers;
    const json out{{"format", format},
                   {"start",
                    {{"player", start.player},
                     {"plays_games", start.plays_games},
                     {"device", start.device},
                     {"played_before", start.played_before},
                     {"consent", start.consent}}},
                   {"notes", notes},
                   {"answers",
                    {{"fun", answers.fun},
                     {"difficulty", answers.difficulty},
                     {"control", answers.control},
                     {"way", answers.way},
                     {"again", answers.again},
                     {"remark", answers.remark}}},
                   {"runs", session.runs}};
    return game::write_whole(session.folder + "/session.json",
                             out.dump(2, ' ', false, json::error_handler_t::replace) + "\n");
}

Expected<Session> read_session(const std::string& folder) {
    const std::string file = folder + "/session.json";
    const auto text = game::read_whole(file);
    if (!text) return tl::unexpected(text.error());
    Session session{.folder = folder, .start = {}, .notes = {}, .answers = {}, .runs = {}};
    try {
        const json from = json::parse(*text);
        if (from.at("format").get<std::string>() != format)
            return tl::unexpected(Error{ErrorCode::unsupported, file + ": a session of another version", file, 0});
        const json& start = from.at("start");
        session.start = {.player = start.at("player").get<std::string>(),
                         .plays_games = start.value("plays_games", std::string{}),
                         .device = start.value("device", std::string{}),
                         .played_before = start.value("played_before", false),
                         .consent = start.value("consent", false)};
        for (const json& note : from.value("notes", json::array()))
            session.notes.push_back({note.at("run").get<std::string>(), note.at("seconds").get<double>(),
                                     note.value("text", std::string{})});
        const json answers = from.value("answers", json::object());
        session.answers = {.fun = std::clamp(answers.value("fun", 0), 0, 5),
                           .difficulty = std::clamp(answers.value("difficulty", 0), 0, 5),
                           .control = std::clamp(answers.value("control", 0), 0, 5),
                           .way = std::clamp(answers.value("way", 0), 0, 5),
                           .again = std::clamp(answers.value("again", 0), 0, 5),
                           .remark = answers.value("remark", std::string{})};
        session.runs = from.value("runs", std::vector<std::string>{});
    } catch (const json::exception& error) {
        return tl::unexpected(Error{ErrorCode::unreadable, file + ": no session: " + error.what(), file, 0});
    }
    for (const std::string& run : session.runs)
        if (!is_plain_name(run))
            return tl::unexpected(
                Error{ErrorCode::unreadable, file + ": '" + run + "' is no name of a file beside it", file, 0});
    return session;
}

Expected<std::vector<Session>> read_sessions(const std::string& folder) {
    namespace fs = std::filesystem;
    std::vector<std::string> folders;
    std::error_code error;
    for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error))
        if (fs::exists(at->path() / "session.json")) folders.push_back(at->path().string());
    if (error)
        return tl::unexpected(Error{ErrorCode::not_found, folder + ": there is no such folder of sessions", folder, 0});
    std::ranges::sort(folders);
    std::vector<Session> sessions;
    for (const std::string& of : folders) {
        auto session = read_session(of);
        if (!session) return tl::unexpected(session.error());
        sessions.push_back(std::move(*session));
    }
    return sessions;
}

}  // namespace surefoot::playtest
