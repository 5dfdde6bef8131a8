#include "playground/picture_options.hpp"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <fmt/format.h>

namespace surefoot::playground {
namespace {

std::optional<view::ivec2> parse_size(const std::string& text) {
    int width = 0;
    int height = 0;
    char end = 0;
    if (std::sscanf(text.c_str(), "%dx%d%c", &width, &height, &end) != 2) return std::nullopt;
    if (width < 64 || height < 64 || width > 16384 || height > 16384) return std::nullopt;
    return view::ivec2(width, height);
}

}  // namespace

void add_picture_options(CLI::App& program, Options& options, std::string& size) {
    program.add_flag("--headless", options.headless,
                     "Draw without a display; time goes by frames, so every run is alike");
    program.add_option("--script", options.scripts,
                       "Input from this file instead of a hand; several are played one after the other");
    program.add_option("--frames", options.frames, "End after so many frames")->check(CLI::Range(1, 1000000));
    program.add_option("--screenshot", options.screenshot, "Keep the last frame as a PNG");
    program.add_option("--contact-sheet", options.contact_sheet,
                       "A PNG with all screenshots of the scripts, small, with their captions");
    program.add_option("--size", size, "Of the window, as 1280x720")->type_name("WxH");
    program
        .add_option("--preset", options.preset, "What is drawn: full, or software for machines without a graphics card")
        ->check(CLI::IsMember({"software", "full"}));
    program.add_option("--scale", options.scale, "How large letters are, headless (a window asks the system)")
        ->check(CLI::Range(0.5, 4.0));
    program.add_option("--settings", options.settings,
                       "Keep settings in this file (headless runs keep none otherwise)");
    program.add_option("--gl", options.gl, "Take this OpenGL: core (3.3) or es (ES 3.0)")
        ->check(CLI::IsMember({"core", "es"}));
    program.add_flag("--timing", options.timing, "Print how long frames took, and how much of all processors");
}

bool take_size(const std::string& size, const char* program, Options& options) {
    if (size.empty()) return true;
    options.size = parse_size(size);
    if (options.size) return true;
    fmt::print(stderr, "{}: --size {}: write it as 1280x720, 64 to 16384 each\n", program, size);
    return false;
}

}  // namespace surefoot::playground
