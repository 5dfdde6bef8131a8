/// What `surefoot nav` asks with: for whom the ground is, and the mesh for them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <surefoot/character_settings.hpp>
#include <surefoot/navigation_flood.hpp>
#include <surefoot/navigation_mesh.hpp>

#include "level.hpp"

namespace surefoot::tools {

/// The options that say who walks, and how finely the ground is looked at; each as `CharacterSettings` and
/// `NavigationOptions` have it where it was not given.
struct WalkerOptions {
    std::string shape;
    std::optional<double> radius;
    std::optional<double> height;
    std::optional<double> climb;
    std::optional<double> slope;
    std::optional<double> cell;
    std::optional<int> threads;
    bool plain = false;

    void add_to(CLI::App& command);

    /// Is anything said about the walker or the cells?
    [[nodiscard]] bool any() const { return !shape.empty() || radius || height || climb || slope || cell || plain; }

    /// Without what surfaces do. Throws `Failure` with ExitCode::usage, in words.
    [[nodiscard]] CharacterSettings settings() const;
};

/// --start.
struct StartOption {
    std::string place;

    void add_to(CLI::App& command);

    /// Throws `Failure` with ExitCode::usage, in words.
    [[nodiscard]] std::optional<dvec3> value() const;
};

/// What a mesh of a level is built with, and who walks on it. Settings and options refer to this. Throws as
/// `WalkerOptions::settings` does.
struct Ground {
    Ground(const Level& level, const WalkerOptions& walker);
    Ground(const Ground&) = delete;
    Ground& operator=(const Ground&) = delete;

    std::vector<NavigationRegion> regions;
    std::vector<NavigationArea> areas;
    std::vector<std::uint32_t> surface_areas;
    std::vector<SurfaceRule> rules;
    CharacterSettings settings;
    NavigationOptions options;
};

/// What of a level stands still and is solid. Of one of the platformer's the rest is hidden, and said to be left out.
struct StillLevel {
    explicit StillLevel(const Level& level);

    Mesh mesh;  ///< with the triangles' numbers of the level's own
    std::size_t moving = 0;
    std::size_t decor = 0;

    /// "  left out   23 moving bodies ...", a line; empty if nothing is.
    [[nodiscard]] std::string text() const;
    /// `,"moving_left_out":23,"decor_left_out":40`.
    [[nodiscard]] std::string json() const;
};

/// Where the level's markers say that characters begin.
[[nodiscard]] std::vector<dvec3> starts_of(const Level& level);

/// How much is done to a mesh.
enum class Proof : std::uint8_t {
    none,     ///< ground alone, at once
    by_feet,  ///< links that a simulated character gets over, and without what it does not reach
};

/// Builds the mesh of what stands still of a level, with a progress bar. The proof begins at `start`, or else where
/// `best_start` says; what it took out is told in `agreement`. Throws `Failure`.
[[nodiscard]] NavigationMesh build_ground(const Level& level, const StillLevel& still, const WalkerOptions& walker,
                                          Proof proof, const std::optional<dvec3>& start = {},
                                          NavigationAgreement* agreement = nullptr);

/// The mesh that the level's file holds, if it holds one. Throws `Failure` if that is damaged.
[[nodiscard]] std::optional<NavigationMesh> ground_in(const Level& level);

}  // namespace surefoot::tools
