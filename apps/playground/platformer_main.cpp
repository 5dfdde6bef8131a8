// The platformer: the playground's house with one room.
#include <cstdio>
#include <fmt/format.h>

#include "playground/app.hpp"
#include "playground/platformer_options.hpp"

int main(int argc, char** argv) {
    using namespace surefoot::playground;
    Options options;
    if (const auto code = read_platformer_options(argc, argv, options)) return static_cast<int>(*code);
    auto app = App::open(options);
    if (!app) {
        fmt::print(stderr, "surefoot-platformer: {}\n", app.error().text);
        return static_cast<int>(ExitCode::display);
    }
    const ExitCode code = (*app)->run();
    if (!(*app)->failure().empty()) fmt::print(stderr, "surefoot-platformer: {}\n", (*app)->failure());
    return static_cast<int>(code);
}
