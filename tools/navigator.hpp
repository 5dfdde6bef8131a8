/// What `surefoot nav` asks with: for whom the ground is, and the mesh for them.
#pragma once

#include <optional>
#include <string>
#include <vector>

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

    void add_to(CLI::App& command);

    /// Is anything said about the walker or the cells?
    [[nodiscard]] bool any() const { return !shape.empty() || radius || height || climb || slope || cell; }

    /// Throws `Failure` with ExitCode::usage, in words.
    [[nodiscard]] CharacterSettings settings() const;
};

/// What a mesh of a level is built with. The options refer to this.
struct Ground {
    Ground(const Level& level, const WalkerOptions& walker);
    Ground(const Ground&) = delete;
    Ground& operator=(const Ground&) = delete;

    std::vector<NavigationRegion> regions;
    NavigationOptions options;
};

/// Where the level's markers say that characters begin.
[[nodiscard]] std::vector<dvec3> starts_of(const Level& level);

/// How much is done to a mesh.
enum class Proof : std::uint8_t {
    none,     ///< ground alone, at once
    by_feet,  ///< links that a simulated character gets over, and without what it does not reach
};

/// Builds the mesh of a level with a progress bar. What the proof took out is told in `agreement`. Throws `Failure`.
[[nodiscard]] NavigationMesh build_ground(const Level& level, const WalkerOptions& walker, Proof proof,
                                          NavigationAgreement* agreement = nullptr);

/// The mesh that the level's file holds, if it holds one. Throws `Failure` if that is damaged.
[[nodiscard]] std::optional<NavigationMesh> ground_in(const Level& level);

}  // namespace surefoot::tools
