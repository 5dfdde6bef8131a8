// The playground: a window with rooms.
#include <cstdio>
#include <fmt/format.h>

#include "playground/app.hpp"

int main(int argc, char** argv) {
    using namespace surefoot::playground;
    Options options;
    if (const auto code = read_options(argc, argv, options)) return static_cast<int>(*code);
    auto app = App::open(options);
    if (!app) {
        fmt::print(stderr, "surefoot-playground: {}\n", app.error().text);
        return static_cast<int>(ExitCode::display);
    }
    const ExitCode code = (*app)->run();
    if (!(*app)->failure().empty()) fmt::print(stderr, "surefoot-playground: {}\n", (*app)->failure());
    return static_cast<int>(code);
}
