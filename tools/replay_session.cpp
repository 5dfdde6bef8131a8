#include <fmt/format.h>

#include "query.hpp"
#include "replays.hpp"
#include "text.hpp"

namespace surefoot::tools {
namespace {

World world_of(const std::string& file, const Session& session, const SessionOptions& given) {
    if (session.bodies.size() != 1) {
        throw Failure{ExitCode::usage,
                      fmt::format("{}: the session is of a world of {} bodies, and a level is one; play it in your own "
                                  "program with replay(session, world)",
                                  file, session.bodies.size())};
    }
    if (given.level.file.empty()) {
        throw Failure{ExitCode::usage, fmt::format("{}: is a session; say on which level with --level", file)};
    }
    World world;
    if (const auto added = world.add(load_level(given.level).mesh, {.body = session.bodies[0].body}); !added) {
        throw Failure{ExitCode::file, fmt::format("{}: {}", given.level.file, added.error().text)};
    }
    return world;
}

double seconds_of(const Session& session, std::size_t ticks) {
    double seconds = 0;
    for (std::size_t i = 0; i < ticks && i < session.ticks.size(); ++i) seconds += session.ticks[i].dt;
    return seconds;
}

std::string outcome_text(const std::string& level, const Session& session, const SessionReplay& again) {
    if (!again.is_same_level) {
        return fmt::format("{} is another level than that of the session: nothing was played.\n", level);
    }
    if (!again.wrong.empty()) return fmt::format("Tick {} cannot be played: {}.\n", again.ticks, again.wrong);
    if (again.first_differs) {
        return fmt::format("Played again by surefoot {}: DIFFERENT from tick {} on, {} s after the beginning.\n",
                           version_text(library_version()), *again.first_differs,
                           short_number(seconds_of(session, *again.first_differs)));
    }
    return fmt::format("Played again: the same in {} ticks, to the last bit.\n", grouped(again.ticks));
}

// The step of one tick, made once more in the world as it was then.
StepCapture step_at(const Session& session, World& world, std::size_t tick) {
    const SessionReplay until = replay(session, world, tick + 1);
    const SessionTick& then = session.ticks[tick];
    return capture_step(world, settings_of(session), then.input, then.dt, until.before, then.neighbours);
}

}  // namespace

ExitCode run_session(const std::string& file, const Session& session, const SessionOptions& given) {
    World world = world_of(file, session, given);
    const SessionReplay again = replay(session, world);
    const std::optional<std::size_t> tick = given.tick ? given.tick : again.first_differs;
    if (tick && *tick >= session.ticks.size()) {
        throw Failure{ExitCode::usage,
                      fmt::format("--tick {}: the session has {} ticks, from 0 on", *tick, session.ticks.size())};
    }
    if (!given.save.empty() && !tick) throw Failure{ExitCode::usage, "--save needs a tick: say which with --tick"};
    const bool can_tell = tick && again.ticks > *tick;
    std::optional<StepCapture> step;
    if (can_tell) step = step_at(session, world, *tick);
    if (given.json) {
        std::string text = fmt::format(R"({{"file":{},"same":{},"ticks":{},"first_differs":{},"wrong":{})",
                                       json_string(file), again.is_same(), again.ticks,
                                       again.first_differs ? std::to_string(*again.first_differs) : "null",
                                       json_string(again.is_same_level ? again.wrong : "another level"));
        text += fmt::format(R"(,"note":{}}})"
                            "\n",
                            json_string(session.note));
        write_out(text);
    } else {
        std::string text = fmt::format("{}, saved by surefoot {} ({})\n", file, version_text(session.origin.library),
                                       session.origin.abi);
        if (!session.note.empty()) text += fmt::format("Note: {}\n", session.note);
        text += fmt::format("A session of {} ticks, {} s: {}.\n", grouped(session.ticks.size()),
                            short_number(seconds_of(session, session.ticks.size())), describe(session.settings.volume));
        text += outcome_text(given.level.file, session, again);
        if (step) {
            text += '\n';
            text += step_report(fmt::format("Tick {}", *tick), *step, replay(*step));
        }
        write_out(text);
    }
    if (step && !given.save.empty()) {
        if (const auto written = write_capture(*step, given.save); !written) {
            throw Failure{ExitCode::file, written.error().text};
        }
    }
    return again.is_same() ? ExitCode::ok : ExitCode::failed;
}

}  // namespace surefoot::tools
