// surefoot tour: moves a body along a route through a level, prints what it meets, and draws it.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <vector>

#if __has_include(<unistd.h>)
#include <unistd.h>
#endif

#include "command.hpp"
#include "level.hpp"
#include "options.hpp"
#include "query.hpp"
#include "text.hpp"
#include "tour/camera.hpp"
#include "tour/legend.hpp"
#include "tour/paint.hpp"
#include "tour/render.hpp"
#include "tour/route.hpp"
#include "tour/scene.hpp"

namespace surefoot::tools {
namespace {

using Clock = std::chrono::steady_clock;

struct TourOptionsGiven {
    LevelOptions level;
    VolumeOptions volume;
    std::string out = "out";
    std::string size = "1280x800";
    std::size_t legs = 0;  ///< 0: as many as suit the level
    bool no_pictures = false;
};

struct PictureSize {
    int width;
    int height;
};

PictureSize picture_size(const std::string& text) {
    const std::size_t cross = text.find('x');
    const Parsed<double> width = parse_number(std::string_view(text).substr(0, cross));
    const Parsed<double> height =
        cross == std::string::npos ? Parsed<double>(0.0) : parse_number(std::string_view(text).substr(cross + 1));
    const auto good = [](const Parsed<double>& n) { return n && *n >= 16 && *n <= 8192 && *n == static_cast<int>(*n); };
    if (!good(width) || !good(height))
        throw Failure{
            ExitCode::usage,
            fmt::format("--size: '{}' is no picture size: write WxH, such as 1280x800, each from 16 to 8192", text)};
    return {static_cast<int>(*width), static_cast<int>(*height)};
}

/// A round body for the picture; the route itself would take any shape.
Walker walker_of(const VolumeOptions& options) {
    Walker walker;
    walker.volume = options.has_shape() ? options.volume() : Volume(Ellipsoid{}, options.rotate_value());
    walker.one_sided = options.one_sided;
    if (const auto* ellipsoid = std::get_if<Ellipsoid>(&walker.volume.shape))
        walker.half_size = ellipsoid->radii;
    else if (const auto* sphere = std::get_if<Sphere>(&walker.volume.shape))
        walker.half_size = dvec3(sphere->radius);
    else
        throw Failure{ExitCode::usage,
                      "--shape: a tour is made by an ellipsoid or a sphere, such as ellipsoid:0.4,0.9,0.4"};
    return walker;
}

bool on_terminal(std::FILE* file) {
#if __has_include(<unistd.h>)
    return isatty(fileno(file)) != 0;
#else
    static_cast<void>(file);
    return false;
#endif
}

/// A bar on a terminal, nothing in a log.
std::function<void(double)> progress_bar(std::string_view what) {
    if (!on_terminal(stderr)) return {};
    return [what](double share) {
        constexpr int width = 32;
        const int full = static_cast<int>(share * width);
        fmt::print(stderr, "\r  {} [{:#<{}}{:.<{}}] {:3.0f}%", what, "", full, "", width - full, 100 * share);
        if (share >= 1) fmt::print(stderr, "\r{:{}}\r", "", width + 60);
        std::fflush(stderr);
    };
}

/// Are the triangles wound so that floors face up? Then roofs can be looked through.
bool floors_face_up(const Mesh& mesh) {
    constexpr int cells = 24;
    const Bounds bounds = mesh.bounds();
    const dvec3 size = bounds.max - bounds.min;
    int all = 0;
    int facing = 0;
    for (int i = 0; i < cells; ++i)
        for (int k = 0; k < cells; ++k) {
            const double x = bounds.min.x + size.x * (i + 0.5) / cells;
            const double z = bounds.min.z + size.z * (k + 0.5) / cells;
            const Motion down{{x, bounds.max.y + 1, z}, {x, bounds.min.y - 1, z}};
            all += mesh.ray(down).has_value();
            facing += mesh.ray(down, {.one_sided = true}).has_value();
        }
    return 4 * facing >= 3 * all;
}

std::vector<dvec3> markers_of(const Level& level, const char* kind) {
    std::vector<dvec3> points;
    for (const ImportedMarker& marker : level.markers)
        if (marker.kind == kind) points.push_back(marker.position);
    return points;
}

Route find_route(const Level& level, const Walker& walker, std::span<const dvec3> waypoints) {
    std::vector<dvec3> starts;
    if (!waypoints.empty()) {
        const std::vector<dvec3> spawns = markers_of(level, "spawn");
        const dvec3 ground = spawns.empty() ? waypoints.front() : spawns.front();
        starts.push_back(ground + dvec3(0, walker.half_size.y, 0));
    } else {
        // A little above the floor, for a start in touch is no place to stand.
        constexpr std::size_t most_starts = 8;
        for (const dvec3& spawn : markers_of(level, "spawn")) {
            const dvec3 start = spawn + dvec3(0, 1.01 * walker.half_size.y, 0);
            if (starts.size() < most_starts && level.mesh.overlap(walker.volume, start, {}) == 0)
                starts.push_back(start);
        }
        if (starts.empty()) starts = standing_places(level.mesh, walker);
    }
    if (starts.empty())
        throw Failure{
            ExitCode::failed,
            fmt::format("{}: there is no place where {} could stand; try a smaller --shape, or --up z or --scale "
                        "if the level came out lying on its side or in another unit",
                        level.file, describe(walker.volume))};
    return best_route(level.mesh, walker, starts, waypoints);
}

struct Totals {
    double median_seconds = 0;
    std::size_t contacts = 0;
};

Totals totals_of(const Route& route) {
    std::vector<double> times;
    Totals totals;
    for (const Leg& leg : route.legs) {
        times.push_back(leg.seconds);
        totals.contacts += leg.hit.has_value();
    }
    if (times.empty()) return totals;
    std::nth_element(times.begin(), times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2), times.end());
    totals.median_seconds = times[times.size() / 2];
    return totals;
}

std::string place(const dvec3& v) {
    return fmt::format("{:.3f}, {:.3f}, {:.3f}", v.x, v.y, v.z);
}

std::string route_table(const Route& route) {
    Table table({"#", "", "from [m]", "to [m]", "t", "met", "triangle", "normal", "us"});
    for (std::size_t i = 0; i < route.legs.size(); ++i) {
        const Leg& leg = route.legs[i];
        const std::string us = fmt::format("{:.2f}", leg.seconds * 1e6);
        if (leg.hit)
            table.add({std::to_string(i + 1), std::string(word(leg.step)), place(leg.motion.from), place(leg.motion.to),
                       fmt::format("{:.6f}", leg.hit->t), std::string(word(leg.hit->feature)),
                       std::to_string(leg.hit->triangle), place(leg.hit->normal), us});
        else
            table.add({std::to_string(i + 1), std::string(word(leg.step)), place(leg.motion.from), place(leg.motion.to),
                       "", "free", "", "", us});
    }
    return table.text();
}

std::string totals_text(const Route& route, const Level& level) {
    const Totals totals = totals_of(route);
    return fmt::format(
        "{} sweeps: {} contacts ({} faces, {} edges, {} vertices), {} free; and {} more to look around.\n"
        "A sweep takes {} (median) among {} triangles.\n",
        route.legs.size(), totals.contacts, route.contacts(Feature::face), route.contacts(Feature::edge),
        route.contacts(Feature::vertex), route.legs.size() - totals.contacts, grouped(route.probes),
        duration(totals.median_seconds), grouped(level.mesh.triangle_count()));
}

dvec3 stop_of(const Leg& leg) {
    return leg.motion.from + (leg.hit ? leg.hit->t : 1.0) * (leg.motion.to - leg.motion.from);
}

/// The walk that ends at the rarest feature, after the longest way.
const Leg* interesting(const Route& route) {
    const Leg* best = nullptr;
    double most = -1;
    for (const Leg& leg : route.legs) {
        if (!leg.hit || leg.hit->started_inside) continue;
        const double length = glm::length(stop_of(leg) - leg.motion.from);
        const double rare = leg.hit->feature == Feature::vertex ? 3 : leg.hit->feature == Feature::edge ? 2 : 0;
        const double value = rare + (leg.step == Step::walk ? 2 : 0) + std::min(length, 4.0) / 4;
        if (value > most) {
            most = value;
            best = &leg;
        }
    }
    return best;
}

/// Corners of boxes around the body at each place, for the camera to keep in the picture.
std::vector<dvec3> frame_around(std::span<const dvec3> places, const dvec3& half_size) {
    std::vector<dvec3> points;
    for (const dvec3& p : places)
        for (const double x : {-1.0, 1.0})
            for (const double y : {-1.0, 1.0})
                for (const double z : {-1.0, 1.0}) points.push_back(p + half_size * dvec3(x, y, z));
    return points;
}

struct Shot {
    std::string name;
    std::string doing;
    std::vector<dvec3> places{};
    std::vector<dvec3> across{};
    std::vector<double> pitches{34, 42, 52};
    double margin = 0.1;
    double focus_share = 1;
    std::vector<Figure> figures{};
    std::string title{};
    std::string under{};
    std::vector<LegendLine> legend{};
};

std::string file_name(const Level& level) {
    return std::filesystem::path(level.file).filename().string();
}

Shot overview(const Route& route, const Walker& walker, const Level& level) {
    Shot shot{.name = "tour.png",
              .doing = "the tour",
              .margin = 0.10,
              .focus_share = 1.15,
              .figures = figures_of(route, walker),
              .title = "surefoot tour",
              .under = "",
              .legend = {}};
    for (const Leg& leg : route.legs) {
        shot.places.push_back(leg.motion.from);
        shot.places.push_back(stop_of(leg));
    }
    shot.under = fmt::format("{}, {} triangles", file_name(level), grouped(level.mesh.triangle_count()));
    struct Row {
        Feature feature;
        std::string_view one, many;
    };
    for (const Row& row : {Row{Feature::face, "face", "faces"}, Row{Feature::edge, "edge", "edges"},
                           Row{Feature::vertex, "vertex", "vertices"}}) {
        const std::size_t count = route.contacts(row.feature);
        shot.legend.push_back(
            {fmt::format("{} {}", count, count == 1 ? row.one : row.many), colour_of(row.feature), true});
    }
    shot.legend.push_back(
        {fmt::format("{} sweeps, {} each", route.legs.size(), duration(totals_of(route).median_seconds)), {}, false});
    return shot;
}

Shot close_up(const Leg& leg, const Walker& walker, const Level& level) {
    Shot shot{.name = "contact.png",
              .doing = "one contact",
              .margin = 0.16,
              .focus_share = 2.5,
              .figures = figures_of(leg, walker),
              .title = fmt::format("stopped by {} {}", leg.hit->feature == Feature::edge ? "an" : "a",
                                   word(leg.hit->feature)),
              .under = fmt::format("triangle {} of {}", leg.hit->triangle, file_name(level)),
              .legend = {}};
    // The whole way would make the contact small: two body heights before the touch are enough.
    const dvec3 stop = stop_of(leg);
    const dvec3 way = stop - leg.motion.from;
    const double length = glm::length(way);
    const double shown = std::min(length, 4 * walker.half_size.y);
    shot.pitches = {14, 22, 30};
    shot.across = {length > 0 ? way / length : way, leg.hit->normal};
    shot.places = {stop, length > 0 ? stop - way * (shown / length) : stop};
    shot.legend.push_back({fmt::format("t = {:.6f}", leg.hit->t), colour_of(leg.hit->feature), true});
    shot.legend.push_back(
        {fmt::format("normal {:.3f}, {:.3f}, {:.3f}", leg.hit->normal.x, leg.hit->normal.y, leg.hit->normal.z),
         {},
         false});
    return shot;
}

void take(const Shot& shot, const Level& level, const Walker& walker, bool one_sided, const PictureSize& size,
          const std::string& folder) {
    const Clock::time_point start = Clock::now();
    const std::vector<dvec3> frame = frame_around(shot.places, walker.half_size);
    const Camera camera = choose_camera(level.mesh, {.frame = frame,
                                                     .see = shot.places,
                                                     .across = shot.across,
                                                     .pitches = shot.pitches,
                                                     .margin = shot.margin,
                                                     .one_sided = one_sided,
                                                     .width = size.width,
                                                     .height = size.height});
    dvec3 focus(0);
    for (const dvec3& p : shot.places) focus += p / static_cast<double>(shot.places.size());
    double reach = 3 * walker.half_size.y;
    std::vector<Colour> surfaces;
    for (std::uint32_t i = 0; i < std::max<std::size_t>(level.surface_names.size(), 1); ++i)
        surfaces.push_back(colour_of_surface(i, surface_name(level, i)));
    for (const dvec3& p : shot.places) reach = std::max(reach, glm::length(p - focus));
    Canvas canvas = render({.mesh = &level.mesh,
                            .camera = camera,
                            .figures = shot.figures,
                            .surfaces = surfaces,
                            .one_sided = one_sided,
                            .unit = 2 * walker.half_size.y,
                            .focus = focus,
                            .focus_reach = reach * shot.focus_share,
                            .progress = progress_bar("drawing " + shot.doing)});
    std::vector<Projected> keep_clear;
    for (const dvec3& point : frame)
        if (const auto projected = camera.project(point)) keep_clear.push_back(*projected);
    draw_legend(canvas, shot.title, shot.under, shot.legend, keep_clear);
    const std::string file = (std::filesystem::path(folder) / shot.name).string();
    if (!canvas.write_png(file))
        throw Failure{ExitCode::file,
                      fmt::format("{}: cannot be written: is the folder writable and the disk not full?", file)};
    write_out(fmt::format("{}  ({} x {}, drawn in {})\n", file, size.width, size.height,
                          duration(std::chrono::duration<double>(Clock::now() - start).count())));
}

ExitCode run_tour(TourOptionsGiven given) {
    const PictureSize size = picture_size(given.size);
    Walker walker = walker_of(given.volume);
    if (given.level.file.empty()) given.level.file = "levels/training-ground.glb";
    const Level level = load_level(given.level);
    const Clock::time_point start = Clock::now();
    const std::vector<dvec3> waypoints = markers_of(level, "waypoint");
    walker.legs = given.legs > 0 ? given.legs : waypoints.empty() ? 40 : 400;
    Route route = find_route(level, walker, waypoints);
    const double found_in = std::chrono::duration<double>(Clock::now() - start).count();
    measure(level.mesh, walker, route);
    write_out(fmt::format("{}: {} triangles, {}, route found in {}\n{} goes for a walk:\n\n", level.file,
                          grouped(level.mesh.triangle_count()), level.how_long(), duration(found_in),
                          describe(walker.volume)));
    write_out(route_table(route) + "\n" + totals_text(route, level));
    if (given.no_pictures) return ExitCode::ok;
    std::error_code error;
    std::filesystem::create_directories(given.out, error);
    if (error) throw Failure{ExitCode::file, fmt::format("{}: cannot be made: {}", given.out, error.message())};
    const bool one_sided = floors_face_up(level.mesh);
    write_out("\n");
    take(overview(route, walker, level), level, walker, one_sided, size, given.out);
    if (const Leg* leg = interesting(route))
        take(close_up(*leg, walker, level), level, walker, one_sided, size, given.out);
    return ExitCode::ok;
}

}  // namespace

void add_tour(CLI::App& program, Run& run) {
    auto* command = program.add_subcommand("tour", "Walk a body through a level, print what it meets, and draw it");
    const auto given = std::make_shared<TourOptionsGiven>();
    given->level.add_to(*command, "LEVEL", false);
    given->volume.add_to(*command, false);
    command->add_option("--out", given->out, "The folder for the pictures (default: out)")->type_name("DIR");
    command->add_option("--size", given->size, "Of the pictures, in pixels (default: 1280x800)")->type_name("WxH");
    command->add_option("--legs", given->legs, "How many sweeps to make at most (default: 40, or 400 along waypoints)")
        ->type_name("N")
        ->check(CLI::Range(1, 100000));
    command->add_flag("--no-pictures", given->no_pictures, "Print the table only");
    command->footer(help_footer(
        "  surefoot tour\n"
        "  surefoot tour castle.obj --out pictures --size 1920x1080\n"
        "  surefoot tour dollhouse.glb --shape ellipsoid:0.04,0.09,0.04 --legs 80\n"
        "\nWithout a LEVEL it takes levels/training-ground.glb. The route follows the level's waypoints (markers of "
        "kind\n"
        "\"waypoint\", from the one of kind \"spawn\"); without them it is found: the same every time.\n"
        "Exit codes: 0 done, 1 there is no place to stand, 2 wrong usage, 3 a file cannot be read or written."));
    command->callback([given, &run] { run = [given] { return run_tour(*given); }; });
}

}  // namespace surefoot::tools
