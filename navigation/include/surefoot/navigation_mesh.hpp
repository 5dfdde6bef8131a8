/// A navigation mesh: the ground on which one kind of character can stand, as convex polygons in tiles, and the links
/// between them. Places on it are places of feet; `NavigationAgent::feet` above them is the character's reference
/// point.
///
/// Built from a `World` with the settings that `step` takes, so that path finding and feet obey one rule. It is kept in
/// a section of a `.surefoot` file. docs/navigation.md tells how it is made.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <surefoot/bounds.hpp>
#include <surefoot/character_settings.hpp>
#include <surefoot/error.hpp>
#include <surefoot/file.hpp>
#include <surefoot/math.hpp>
#include <surefoot/mesh.hpp>
#include <surefoot/navigation_build.hpp>
#include <surefoot/navigation_link.hpp>
#include <surefoot/world.hpp>

namespace surefoot::navigation {
struct MeshState;
}

namespace [[gnu::visibility("default")]] surefoot {
inline namespace v0 {

/// Names a polygon, or nothing. A name is dead once its tile was built anew; queries then know no such polygon.
struct NavigationPolygon {
    std::uint32_t id = 0;

    [[nodiscard]] explicit operator bool() const noexcept { return id != 0; }
    friend bool operator==(const NavigationPolygon&, const NavigationPolygon&) = default;
};

/// A polygon as it is drawn and counted.
struct NavigationOutline {
    NavigationPolygon polygon;
    std::uint32_t area = 0;
    bool taken_out = false;       ///< by `take_out`: it is there, but no path goes over it
    std::uint32_t corners = 0;    ///< 3 to 6
    dvec3 corner[6] = {};         ///< counter-clockwise when seen from above [m]
    NavigationPolygon beside[6];  ///< over the side from corner[i] to corner[i + 1]; of several the first; or none
};

/// What building found.
struct NavigationReport {
    std::size_t tiles = 0;     ///< with ground in them
    std::size_t polygons = 0;  ///< links not counted
    double area = 0;           ///< of all polygons, seen from above [m^2]
    double seconds = 0;
};

/// See the top of this file. Threads: const calls may run on any number of threads at once; everything else runs alone,
/// and not while a query runs. Memory: building, opening and changing allocate.
class NavigationMesh {
public:
    /// Builds the mesh of all bodies of the world that stand still. Fails with `invalid` for settings or options out
    /// of range, a world without bodies, or a `require` region without ground; with `limit` for a level that needs more
    /// tiles than there are or more polygons in a tile than references of 32 bits can name.
    [[nodiscard]] static Expected<NavigationMesh> build(const World& world, const CharacterSettings& settings,
                                                        const NavigationOptions& options = {});

    /// Builds the tiles anew that reach into `changed`, a box of the world: call it after a body came, went or moved.
    /// Links that begin or end in them are dropped. The world, settings and options must be those of `build` but for
    /// the change; what lies beyond the tiles of `build` gets no ground. Fails as `build` does, with nothing changed.
    /// Returns how many tiles were built.
    [[nodiscard]] Expected<std::size_t> rebuild(const World& world, const CharacterSettings& settings,
                                                const NavigationOptions& options, const Bounds& changed);

    /// The mesh in a cooked file, mapped privately: what path finding writes into it stays in this process. Every count
    /// and index is looked at first. Fails as `Mesh::open` does; with `not_found` when the file has none.
    [[nodiscard]] static Expected<NavigationMesh> open(const std::string& path);

    /// The same from a mesh that is open already, by a copy.
    [[nodiscard]] static Expected<NavigationMesh> read(const Mesh& mesh);

    /// The same from the bytes of a section.
    [[nodiscard]] static Expected<NavigationMesh> read(std::span<const std::byte> bytes, const std::string& file = {});

    /// What `Mesh::write` takes as an extra section: `navigation_section` with these bytes.
    [[nodiscard]] std::vector<std::byte> to_bytes() const;

    NavigationMesh(NavigationMesh&& other) noexcept;
    NavigationMesh& operator=(NavigationMesh&& other) noexcept;
    ~NavigationMesh();

    [[nodiscard]] const NavigationAgent& agent() const noexcept;
    [[nodiscard]] const dvec3& up() const noexcept;  ///< unit
    [[nodiscard]] NavigationReport report() const noexcept;

    /// The areas of `NavigationOptions`, or the one that is there without any.
    [[nodiscard]] std::span<const NavigationArea> areas() const noexcept;

    /// From now on: opens and shuts a door, or makes ground dearer; links cost what area 0 does. Requires: an area that
    /// is there and a cost from 1 to 1e6; asserts otherwise, and with asserts off changes nothing and says false.
    bool set_area(std::uint32_t area, bool closed, double cost = 1) noexcept;

    [[nodiscard]] std::span<const NavigationLink> links() const noexcept;

    /// Replaces all links. Those that begin or end too far from the mesh are left out, and those that end farther away
    /// than in the next tile, which Detour cannot join; how many is returned. Their names and those of the polygons in
    /// their tiles are new. A link is open as long as the areas at both its ends are. Fails with `limit` when a tile
    /// has more than references can name, and with `invalid` for a mesh that was opened: build it.
    [[nodiscard]] Expected<std::size_t> set_links(std::span<const NavigationLink> links);

    /// No path goes over these polygons any more, or does again. Names that are dead do nothing.
    void take_out(std::span<const NavigationPolygon> polygons, bool out = true) noexcept;

    /// Fills `found` with polygons, tile by tile, and returns how many there are, which may be more than found room.
    std::size_t outlines(std::span<NavigationOutline> found) const noexcept;

    /// One of them; of no corners if there is no such polygon.
    [[nodiscard]] NavigationOutline outline(NavigationPolygon polygon) const noexcept;

    /// For the parts of the wing.
    [[nodiscard]] const navigation::MeshState& state() const noexcept { return *state_; }

private:
    explicit NavigationMesh(std::unique_ptr<navigation::MeshState> state) noexcept;
    std::unique_ptr<navigation::MeshState> state_;
};

/// The section under which a `.surefoot` file keeps it; `made_from`: that of the mesh.
[[nodiscard]] Section navigation_section(std::span<const std::byte> bytes, std::uint64_t made_from = 0) noexcept;

}  // namespace v0
}  // namespace surefoot
