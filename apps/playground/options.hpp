/// The command line of the playground.
#pragma once

#include <glm/ext/vector_double3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "view/input.hpp"

namespace surefoot::playground {

/// What the program says to a script when it ends.
enum class ExitCode : int {
    ok = 0,
    failed = 1,   ///< the script went wrong, or a picture could not be written
    usage = 2,    ///< the command line makes no sense
    file = 3,     ///< a file cannot be read
    display = 4,  ///< no display, or no OpenGL that is new enough
};

struct Options {
    std::string room;
    std::string only_room{};  ///< a program of its own: no start screen, no help and overlay of the house
    std::string program = "surefoot-playground";  ///< before what is told to a terminal
    std::string title = "Surefoot playground";
    int beat = 0;           ///< of the platformer's level: seen as its picture is taken
    bool bot = false;       ///< a bot plays where there is a game
    double watch_from = 0;  ///< into the recording that is watched [s]
    std::string session{};  ///< the folder of an afternoon with people
    std::string level;
    std::string scene;               ///< of the course
    std::string ghost_command;       ///< a program that walks it
    bool navigation = false;         ///< the overlay is shown
    std::optional<glm::dvec3> from;  ///< where its way begins [m]
    std::optional<glm::dvec3> to;    ///< and ends
    bool headless = false;
    std::vector<std::string> scripts;  ///< played one after the other
    std::optional<int> frames;
    std::string screenshot;
    std::string contact_sheet;
    std::optional<view::ivec2> size;
    std::optional<view::ivec2> window{};  ///< how large it was when it was closed, where the house does not know
    std::string preset;
    double scale = 1;
    std::string settings;
    std::string gl;
    bool timing = false;
};

/// Reads the command line. Where there is nothing more to do (help, a mistake), it has said so and the code is what to
/// end with.
[[nodiscard]] std::optional<ExitCode> read_options(int argc, const char* const* argv, Options& options);

}  // namespace surefoot::playground
