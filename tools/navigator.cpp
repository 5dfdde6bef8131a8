#include "navigator.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <surefoot/character_settings.hpp>

#include "command.hpp"
#include "game/still_ground.hpp"
#include "kitchen.hpp"
#include "navigator_bars.hpp"
#include "options.hpp"
#include "parse.hpp"
#include "progress.hpp"
#include "surface_words.hpp"
#include "text.hpp"

namespace surefoot::tools {

void WalkerOptions::add_to(CLI::App& command) {
    CLI::Option* const whole = command.add_option("--shape", shape, "Its body (default: ellipsoid:0.4,0.9,0.4)");
    whole->type_name("KIND:SIZES");
    const auto metres = [&](const char* name, std::optional<double>& value, const char* help) {
        return command.add_option(name, value, help)->type_name("METRES");
    };
    metres("--radius", radius, "How wide it is to each side, as an upright ellipsoid (default: 0.4)")->excludes(whole);
    metres("--height", height, "How tall it is, as an upright ellipsoid (default: 1.8)")->excludes(whole);
    metres("--climb", climb, "The highest step that it walks up (default: 0.4)");
    command.add_option("--slope", slope, "The steepest ground that it stands on, from level (default: 50)")
        ->type_name("DEGREES");
    metres("--cell", cell, "The squares in which ground is sampled (default: a quarter of its radius)");
    command.add_option("--threads", threads, "How many threads build (default: 2); the mesh is the same")
        ->type_name("COUNT");
    command.add_flag("--plain", plain, "All surfaces are firm ground, whatever they are called");
}

CharacterSettings WalkerOptions::settings() const {
    CharacterSettings settings;
    if (!shape.empty()) {
        const auto parsed = parse_shape(shape);
        if (!parsed) throw Failure{ExitCode::usage, "--shape: " + parsed.error()};
        settings.volume = *parsed;
    } else if (radius || height) {
        const double half = height.value_or(1.8) / 2;
        settings.volume = Ellipsoid{{radius.value_or(0.4), half, radius.value_or(0.4)}};
    }
    settings.step_up = climb.value_or(settings.step_up);
    settings.slope_limit_deg = slope.value_or(settings.slope_limit_deg);
    if (!is_valid(settings))
        throw Failure{ExitCode::usage,
                      "no character can be like that: sizes are above 0 and at least four times its skin of 0.01 m, "
                      "steps at least 0, slopes 0 to 89 degrees"};
    return settings;
}

void StartOption::add_to(CLI::App& command) {
    command
        .add_option("--start", place,
                    "Where the feet begin: over ground or near it [m] (default: the level's spawn markers, or the "
                    "largest piece of ground)")
        ->type_name("X,Y,Z");
}

std::optional<dvec3> StartOption::value() const {
    if (place.empty()) return std::nullopt;
    return position_of("--start", place);
}

namespace {

/// Areas in the order of `SurfaceGround`, but for what is none.
std::vector<NavigationArea> named_areas() {
    return {{.name = "ground"}, {.name = "ice", .cost = 2}, {.name = "mud", .cost = 2}, {.name = "water", .cost = 3}};
}

}  // namespace

Ground::Ground(const Level& level, const WalkerOptions& walker)
    : regions(navigation_regions(level.markers)), settings(walker.settings()) {
    if (!walker.plain) {
        rules = surface_rules(level.surface_names);
        for (const std::string& name : level.surface_names) {
            const SurfaceGround ground = surface_meaning(name).ground;
            surface_areas.push_back(ground == SurfaceGround::forbidden ? forbidden_area
                                                                       : static_cast<std::uint32_t>(ground));
        }
        areas = named_areas();
        settings.surfaces = SurfaceRules(rules);
        options.areas = areas;
        options.surface_areas = surface_areas;
    }
    options.cell_size = walker.cell.value_or(0);
    options.threads = walker.threads.value_or(options.threads);
    options.regions = regions;
}

StillLevel::StillLevel(const Level& level) : mesh(level.mesh) {
    const auto notes = level_notes(level.mesh);
    if (!notes) throw Failure{ExitCode::file, fmt::format("{}: {}", level.file, notes.error().text)};
    const game::StillGround still = game::still_ground(*notes);
    if (still.is_all()) return;
    auto hidden = level.mesh.with_hidden(still.others);
    if (!hidden) throw Failure{ExitCode::file, fmt::format("{}: {}", level.file, hidden.error().text)};
    mesh = std::move(*hidden);
    moving = still.moving;
    decor = still.decor;
}

std::string StillLevel::text() const {
    if (moving + decor == 0) return {};
    return fmt::format(
        "  still     a level of the platformer: of it the still ground; {} moving bodies and {} pieces of decor are "
        "left "
        "out\n",
        grouped(moving), grouped(decor));
}

std::string StillLevel::json() const {
    return fmt::format(R"(,"moving_left_out":{},"decor_left_out":{})", moving, decor);
}

std::vector<dvec3> starts_of(const Level& level) {
    std::vector<dvec3> starts;
    for (const ImportedMarker& marker : level.markers)
        if (marker.kind == "spawn") starts.push_back(marker.position);
    return starts;
}

NavigationMesh build_ground(const Level& level, const StillLevel& still, const WalkerOptions& walker, Proof proof,
                            const std::optional<dvec3>& given, NavigationAgreement* agreement) {
    World world;
    if (const auto added = world.add(still.mesh); !added) throw Failure{ExitCode::file, added.error().text};
    Ground ground(level, walker);
    const CharacterSettings& settings = ground.settings;
    std::optional<ProgressBar> bar(std::in_place, "looking for ground");
    const auto show = [&](std::size_t done, std::size_t all) {
        bar->show(static_cast<double>(done) / static_cast<double>(all));
    };
    ground.options.progress = NavigationProgress(show);
    auto mesh = NavigationMesh::build(world, settings, ground.options);
    bar.reset();
    if (!mesh) {
        const bool memory = mesh.error().code == ErrorCode::out_of_memory;
        throw Failure{memory ? ExitCode::file : ExitCode::usage, level.file + ": " + mesh.error().text};
    }
    if (proof == Proof::none) return *std::move(mesh);
    std::optional<dvec3> start;
    if (given) {
        const auto found = start_at(*mesh, *given);
        if (!found) throw Failure{ExitCode::usage, level.file + ": " + found.error().text};
        start = *found;
    } else {
        start = best_start(*mesh, starts_of(level));
    }
    if (!start) return *std::move(mesh);
    CheckBars bars;
    const auto show_part = [&](NavigationCheckPart part, std::size_t done, std::size_t all) {
        bars.show(part, done, all);
    };
    NavigationCheckOptions options;
    options.mesh = ground.options;
    options.mesh.progress = {};
    options.threads = ground.options.threads;
    options.progress = NavigationCheckProgress(show_part);
    const NavigationAgreement agreed = prove_by_feet(*mesh, world, settings, *start, options);
    if (agreement != nullptr) *agreement = agreed;
    return *std::move(mesh);
}

std::optional<NavigationMesh> ground_in(const Level& level) {
    auto mesh = is_cooked_name(level.file) ? NavigationMesh::open(level.file) : NavigationMesh::read(level.mesh);
    if (mesh) return *std::move(mesh);
    if (mesh.error().code == ErrorCode::not_found) return std::nullopt;
    throw Failure{ExitCode::file, mesh.error().text};
}

}  // namespace surefoot::tools
