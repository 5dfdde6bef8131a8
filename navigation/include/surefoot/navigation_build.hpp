/// How a navigation mesh is made: the ground of a world on which one kind of character can stand, cut into convex
/// polygons. docs/navigation.md tells the way from triangles to polygons, with pictures.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include <surefoot/bounds.hpp>
#include <surefoot/character_settings.hpp>
#include <surefoot/math.hpp>
#include <surefoot/notes.hpp>
#include <surefoot/pose.hpp>
#include <surefoot/world.hpp>

namespace [[gnu::visibility("default")]] surefoot {
inline namespace v0 {

/// What a character needs in order to pass, along and across `up`.
struct NavigationAgent {
    double radius = 0.4;          ///< of the narrowest upright cylinder around its body and skin [m, > 0]
    double height = 1.8;          ///< from its feet to its head [m, > 0]
    double climb = 0.4;           ///< the highest step that it walks up [m, >= 0]
    double slope_limit_deg = 50;  ///< the steepest ground that it stands on [degrees, 0 to 89]
    double feet = 0.9;            ///< from its feet up to its reference point [m]
};

/// The one rule for feet and mesh: what `step` uses of these settings. The body is that of `CharacterSettings::volume`;
/// other forms (crouched, in the air) do not count. Requires: valid settings; else an agent of zero height.
[[nodiscard]] NavigationAgent navigation_agent(const CharacterSettings& settings) noexcept;

/// A kind of ground. Area 0 is all ground about which nothing is said.
struct NavigationArea {
    std::string name;
    double cost = 1;      ///< a metre on it is as long as so many on plain ground [1 to 1e6]
    bool closed = false;  ///< no path goes over it: a door that is shut; `NavigationMesh::set_area` opens it
};

/// Instead of the number of an area: what is made of it is no ground. Feet could stand there and are not to: lava.
inline constexpr std::uint32_t forbidden_area = 0xffffffff;

/// A box in the world that says what the ground in it is.
struct NavigationRegion {
    enum class Kind : std::uint8_t {
        forbid,   ///< nobody walks here
        require,  ///< there has to be ground here: building fails with the region's name otherwise
        area,     ///< the ground here is of `area`
    };
    std::string name;             ///< for errors
    Pose pose{};                  ///< of its middle, in the world
    dvec3 half_extents{1, 1, 1};  ///< [m, > 0]
    Kind kind = Kind::forbid;
    std::uint32_t area = 0;
};

/// What a level's markers say about its ground: a marker of the kind `navigation_forbid` or `navigation_require` is the
/// box that reaches from its place as far as its scale to each side, as an empty drawn as a cube is.
[[nodiscard]] std::vector<NavigationRegion> navigation_regions(std::span<const Marker> markers);

/// Any callable `void(std::size_t done, std::size_t all)`, told of tiles as they are finished. Non-owning; called by
/// one thread at a time; may not throw.
class NavigationProgress {
public:
    constexpr NavigationProgress() noexcept = default;

    template <typename Callable>
    requires(
        std::is_invocable_v<const Callable&, std::size_t, std::size_t> &&
        !std::is_same_v<Callable, NavigationProgress>) constexpr NavigationProgress(const Callable& callable) noexcept
        : callable_(&callable), call_([](const void* target, std::size_t done, std::size_t all) {
              (*static_cast<const Callable*>(target))(done, all);
          }) {}

    void operator()(std::size_t done, std::size_t all) const {
        if (call_ != nullptr) call_(callable_, done, all);
    }

private:
    const void* callable_ = nullptr;
    void (*call_)(const void*, std::size_t, std::size_t) = nullptr;
};

/// How to build. Every default is meant to be kept.
struct NavigationOptions {
    /// Against gravity, for the whole mesh; any length but zero.
    dvec3 up{0, 1, 0};

    /// Instead of what the settings need: for a trial of what becomes of paths when mesh and feet do not agree.
    std::optional<NavigationAgent> agent{};

    /// The side of a cell in which ground is sampled [m, > 0]; 0: a quarter of the agent's radius. Too large and narrow
    /// passages close; half of it takes four times as long.
    double cell_size = 0;

    /// The height of a cell [m, > 0]; 0: half of `cell_size`. Steps are told from walls to this accuracy.
    double cell_height = 0;

    /// The side of a tile, which is what is built anew when something in it changes [cells, 16 to 1024]. No link leads
    /// farther than into the next tile. 0: 96, or more where the character jumps farther than such a tile is wide.
    int tile_cells = 0;

    /// What the ground can be; empty: one area, of cost 1. At most 60.
    std::span<const NavigationArea> areas{};

    /// By surface number, which area it is, or `forbidden_area`; a surface beyond the end is area 0.
    std::span<const std::uint32_t> surface_areas{};

    std::span<const NavigationRegion> regions{};

    /// Bodies without a bit of these do not exist for the mesh. Bodies that move in this tick never do.
    std::uint64_t layers = all_layers;

    /// How many threads may work [1 to 64]. The result is the same.
    int threads = 2;

    NavigationProgress progress{};
};

}  // namespace v0
}  // namespace surefoot
