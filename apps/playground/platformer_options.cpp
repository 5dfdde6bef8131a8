#include "playground/platformer_options.hpp"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <fmt/format.h>

#include <surefoot/version.hpp>

#include "platformer/screens/game_settings.hpp"
#include "playground/picture_options.hpp"

namespace surefoot::playground {
namespace {

constexpr const char* footer = R"(
Examples:
  surefoot-platformer                        the title
  surefoot-platformer clockwork              a level at once, by the name of its file
  surefoot-platformer run.run                watch a recording, as the page of `surefoot playtest` holds them
  surefoot-platformer run.run --from 41.5    the same from that second on
  surefoot-platformer my/castle.glb          a level of yours: docs/levels.md tells how to make one
  surefoot-platformer first-steps --bot      watch a bot play it
  surefoot-platformer --session afternoon    somebody is tested: docs/playtesting.md is the guide
  surefoot-platformer --headless --script tour.txt

WASD or the left stick runs, Space or A jumps (twice, and off walls), Shift or X dashes, Control or B crouches; the mouse
or the right stick looks around. All of it can be changed under Options. F3 shows the volume that meets the world.
Exit codes: 0 well, 1 a script went wrong or a picture could not be written, 2 wrong usage, 3 a file cannot be read,
            4 no display or no OpenGL that is new enough.)";

}  // namespace

std::optional<ExitCode> read_platformer_options(int argc, const char* const* argv, Options& options) {
    CLI::App program{"A platformer, and the example of how a game is built on Surefoot.", "surefoot-platformer"};
    const Version v = library_version();
    program.set_version_flag("--version", fmt::format("surefoot-platformer {}.{}.{}", v.major, v.minor, v.patch));
    program.get_formatter()->column_width(28);
    program.footer(footer);
    options.only_room = "platformer";
    options.program = "surefoot-platformer";
    options.title = "Surefoot platformer";
    std::string size;
    auto* const level =
        program.add_option("LEVEL", options.level, "Play this level at once: its name, or a .glb; or watch a .run");
    program.add_option("--from", options.watch_from, "Watch the .run from this second on")
        ->check(CLI::Range(0.0, 36000.0))
        ->type_name("SECONDS");
    program.add_flag("--bot", options.bot, "A bot plays");
    program.add_option("--beat", options.beat, "See this beat of the level, as its picture in docs/levels is taken")
        ->check(CLI::Range(1, 100))
        ->needs(level);
    program
        .add_option("--session", options.session,
                    "Somebody is tested: forms, F9 for a note, F10 for a mark; everything is kept in a folder in DIR")
        ->type_name("DIR");
    add_picture_options(program, options, size);
    try {
        program.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return program.exit(error) == 0 ? ExitCode::ok : ExitCode::usage;
    }
    if ((options.level.ends_with(".glb") || options.level.ends_with(".run")) &&
        !std::filesystem::exists(options.level)) {
        fmt::print(stderr, "surefoot-platformer: there is no file {}\n", options.level);
        return ExitCode::file;
    }
    if (options.watch_from > 0 && !options.level.ends_with(".run")) {
        fmt::print(stderr, "surefoot-platformer: --from goes with a .run that is watched\n");
        return ExitCode::usage;
    }
    if (!take_size(size, "surefoot-platformer", options)) return ExitCode::usage;
    const auto kept =
        platformer::read_game_settings(options.settings.empty() ? platformer::game_settings_path() : options.settings);
    if (kept) options.window = view::ivec2(kept->width, kept->height);
    return std::nullopt;
}

}  // namespace surefoot::playground
