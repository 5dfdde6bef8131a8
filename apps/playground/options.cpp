#include "playground/options.hpp"

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <fmt/format.h>
#include <tuple>

#include <surefoot/version.hpp>

#include "course/catalogue.hpp"
#include "playground/picture_options.hpp"
#include "playground/room.hpp"

namespace surefoot::playground {
namespace {

constexpr const char* footer = R"(
Examples:
  surefoot-playground
  surefoot-playground --room walk --level castle.obj
  surefoot-playground --room walk --level levels/training-ground.glb --headless --frames 30 --screenshot out.png
  surefoot-playground --room course --scene stairs-up --ghost-exec 'node my-mover.mjs'
  surefoot-playground --headless --script tour.txt --size 1280x720 --preset software

Without --room it begins on the start screen. F1 shows the keys. docs/playground.md tells how scripts are written.
Exit codes: 0 well, 1 a script went wrong or a picture could not be written, 2 wrong usage, 3 a file cannot be read,
            4 no display or no OpenGL that is new enough.)";

std::optional<glm::dvec3> parse_place(const std::string& text) {
    glm::dvec3 place{0, 0, 0};
    char end = 0;
    if (std::sscanf(text.c_str(), "%lf,%lf,%lf%c", &place.x, &place.y, &place.z, &end) != 3) return std::nullopt;
    const bool is_finite = std::isfinite(place.x) && std::isfinite(place.y) && std::isfinite(place.z);
    return is_finite ? std::optional(place) : std::nullopt;
}

}  // namespace

std::optional<ExitCode> read_options(int argc, const char* const* argv, Options& options) {
    CLI::App program{"Sweeps to look at and to play with: a window with rooms.", "surefoot-playground"};
    const Version v = library_version();
    program.set_version_flag("--version", fmt::format("surefoot-playground {}.{}.{}", v.major, v.minor, v.patch));
    program.get_formatter()->column_width(28);
    program.footer(footer);
    std::vector<std::string> ids;
    for (const RoomCard& card : rooms()) ids.emplace_back(card.id);
    std::string size;
    std::string from;
    std::string to;
    program.add_option("--room", options.room, "Enter this room at once")->check(CLI::IsMember(ids));
    program.add_option("--level", options.level, "The level: .surefoot, or any file that `surefoot cook` reads");
    program.add_option("--scene", options.scene, "Of the course, for --room course")
        ->check([](const std::string& name) {
            std::string all;
            for (const course::Scene& scene : course::all_scenes()) {
                if (scene.name == name) return std::string();
                all += (all.empty() ? "" : ", ") + scene.name;
            }
            return "there is no scene " + name + ": " + all;
        })
        ->type_name("NAME");
    program
        .add_option(
            "--ghost-exec", options.ghost_command,
            "For --room course: a program, started by the shell, that walks beside ours (docs/course-protocol.md)")
        ->type_name("PROGRAM");
    program.add_flag("--navigation", options.navigation, "Show the navigation mesh of the room's ground (F2)");
    program.add_option("--from", from, "Where its way begins, at the feet")->type_name("X,Y,Z");
    program.add_option("--to", to, "Where it ends, at the feet")->type_name("X,Y,Z");
    add_picture_options(program, options, size);
    bool list_rooms = false;
    program.add_flag("--list-rooms", list_rooms, "Print what --room takes, a line each, and end");
    try {
        program.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return program.exit(error) == 0 ? ExitCode::ok : ExitCode::usage;
    }
    if (list_rooms) {
        for (const std::string& id : ids) fmt::print("{}\n", id);
        return ExitCode::ok;
    }
    if (!take_size(size, "surefoot-playground", options)) return ExitCode::usage;
    for (const auto& [name, text, place] :
         {std::tuple{"--from", &from, &options.from}, std::tuple{"--to", &to, &options.to}}) {
        if (text->empty()) continue;
        *place = parse_place(*text);
        options.navigation = true;
        if (*place) continue;
        fmt::print(stderr, "surefoot-playground: {} {}: write it as 1.5,0,-20\n", name, *text);
        return ExitCode::usage;
    }
    if (options.headless && !options.frames && options.scripts.empty()) options.frames = 60;
    return std::nullopt;
}

}  // namespace surefoot::playground
