// What does a walking character cost? 1000 of them at 6 m/s and 60 Hz, with gravity, steps, snap and slide.
//
//     surefoot_characters [terrain|city] [--small]
#include <cstdio>
#include <cstring>

#include "characters.hpp"

namespace surefoot::bench {
namespace {

void print(const CharacterReport& report) {
    std::printf("E, Embree's long ray: %.0f ns\n", report.ray);
    std::printf("%-18s %8s %7s %8s %8s %8s %9s  %7s %7s %8s %9s %8s\n", "", "median", "x E", "p50", "p99", "p99.9",
                "worst", "walked", "ground", "blocked", "per core", "2 thr.");
    for (const CharacterRow& row : report.rows) {
        std::printf("%-18s %5.2f us %7.2f %5.2f us %5.2f us %5.2f us %6.1f us  %4.2f/%.0f %6.1f%% %7.1f%% %9.0f",
                    row.name.c_str(), 1e-3 * row.median, report.ray > 0 ? row.median / report.ray : 0, 1e-3 * row.p50,
                    1e-3 * row.p99, 1e-3 * row.p999, 1e-3 * row.worst, row.walked, speed_asked, 100 * row.grounded,
                    100 * row.blocked, 1e9 / 60 / row.median);
        if (row.two_threads > 0) std::printf(" %7.2fx", row.two_threads);
        std::printf("\n");
        if (row.gather > 0) {
            std::printf("%-18s the crowd's own: %.0f ns to gather, %.0f ns to find %.1f others, a character\n", "",
                        row.gather, row.neighbours, row.met);
        }
    }
}

}  // namespace
}  // namespace surefoot::bench

int main(int count, char** arguments) {
    using namespace surefoot::bench;
    CharacterOptions options;
    bool small = false;
    bool city = false;
    for (int i = 1; i < count; ++i) {
        small = small || std::strcmp(arguments[i], "--small") == 0;
        city = city || std::strcmp(arguments[i], "city") == 0;
    }
    if (small) options = {.count = 60, .ticks = 8, .settling = 30, .bullets = 10, .bullet_ticks = 5};
    const Stage stage(city ? make_city(small ? 2 : 8) : make_terrain(small ? 64 : 512));
    std::printf("%s: %zu triangles, %zu characters, 60 Hz, thread CPU time\n", stage.scene.name.c_str(),
                stage.scene.triangle_count(), options.count);
    print(run_characters(stage, options));
}
