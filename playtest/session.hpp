/// An afternoon with people: what is kept of one who played, in a folder of its own. docs/playtesting.md tells how.
///
///     SESSIONS/2026-11-27-anna/session.json    start form, the observer's notes, answers, names of the runs
///     SESSIONS/2026-11-27-anna/first-steps.run what was pressed; telemetry is made anew from it
///     SESSIONS/2026-11-27-anna/first-steps.json telemetry, for a run that cannot be played again
#pragma once

#include <string>
#include <vector>

#include <surefoot/error.hpp>

namespace surefoot::playtest {

/// Before it begins. Nobody's name is needed: a letter will do.
struct StartForm {
    std::string player{};
    std::string plays_games{};  ///< "never", "sometimes", "often"
    std::string device{};       ///< "keyboard", "keyboard and mouse", "gamepad"
    bool played_before = false;
    bool consent = false;  ///< they agreed to what is kept
};

/// The observer pressed the note key.
struct SessionNote {
    std::string run;     ///< the name of its file, without the ending; empty: between runs
    double seconds = 0;  ///< of the run
    std::string text;    ///< empty: a marker without words
};

struct Questionnaire {
    int fun = 0;         ///< 1 to 5; 0: not answered
    int difficulty = 0;  ///< 1 too easy, 3 right, 5 too hard
    int control = 0;     ///< 1 "it does not do what I want" to 5 "as if by itself"
    int way = 0;         ///< knew where to go: 1 never to 5 always
    int again = 0;       ///< would go on: 1 "no" to 5 "at once"
    std::string remark{};
};

struct Session {
    std::string folder;
    StartForm start;
    std::vector<SessionNote> notes;
    Questionnaire answers;
    std::vector<std::string> runs;  ///< names of files, without the ending
};

/// Writes session.json into its folder, whole or not at all. Fails with `write_failed`.
[[nodiscard]] Expected<void> write_session(const Session& session);

/// Fails with `not_found`, and with `unreadable` or `unsupported` for a session.json that is none.
[[nodiscard]] Expected<Session> read_session(const std::string& folder);

/// All sessions in the folders of a folder, by name. Fails at the first that cannot be read.
[[nodiscard]] Expected<std::vector<Session>> read_sessions(const std::string& folder);

}  // namespace surefoot::playtest
