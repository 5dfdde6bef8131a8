/// A navigation mesh of a room's ground, with all that is drawn of it. It is made beside the drawing.
#pragma once

#include <atomic>
#include <future>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include <surefoot/error.hpp>
#include <surefoot/navigation_mesh.hpp>
#include <surefoot/world.hpp>

#include "playground/navigation/draped.hpp"
#include "playground/navigation/ground.hpp"

namespace surefoot::playground {

/// A link, and where the feet go over it: a place a tick.
struct LinkArc {
    NavigationLinkKind kind = NavigationLinkKind::drop;
    std::vector<dvec3> places;
};

struct NavigationScene {
    NavigationGroundPointer ground;
    World world;
    CharacterSettings settings;  ///< with the rules of `ground`
    NavigationMesh mesh;
    std::vector<NavigationOutline> outlines;
    std::vector<LinkArc> arcs;                                ///< by the number of the link
    std::vector<DrapedPolygon> draped{};                      ///< by the place in `outlines`
    std::unordered_map<std::uint32_t, std::size_t> places{};  ///< in `outlines`, by the polygon's id

    [[nodiscard]] const dvec3& up() const { return mesh.up(); }

    /// Where the reference point is when the feet are here.
    [[nodiscard]] dvec3 above(const dvec3& feet) const { return feet + up() * mesh.agent().feet; }

    /// Null for a link, and for a polygon that is not there.
    [[nodiscard]] const DrapedPolygon* draped_of(NavigationPolygon polygon) const;

    /// The polygon at a place of its ground, one that was taken out among them: queries do not know those.
    [[nodiscard]] const NavigationOutline* outline_at(const dvec3& place) const;

    /// Reads the polygons again, after the mesh was changed.
    void read_outlines();
};

/// What is slippery is an area of its own, that paths go around where that is not far.
inline constexpr std::uint32_t slippery_area = 1;

[[nodiscard]] Expected<std::unique_ptr<NavigationScene>> make_scene(const NavigationGroundPointer& ground,
                                                                    const NavigationProgress& progress = {});

/// The simulation of a link over again: from rest at its beginning, with the inputs that are kept with it.
[[nodiscard]] LinkArc arc_of(const World& world, const CharacterSettings& settings, const NavigationMesh& mesh,
                             const NavigationLink& link);

/// Makes scenes beside the drawing, or at once for runs that have to go the same way every time.
class SceneMaker {
public:
    explicit SceneMaker(bool at_once) : at_once_(at_once) {}

    /// Wants a scene of this ground; if one is being made of another, that is finished first and thrown away.
    void want(const NavigationGroundPointer& ground);

    /// The scene once it is there, or why there is none; nothing until then.
    [[nodiscard]] std::optional<Expected<std::unique_ptr<NavigationScene>>> take();

    [[nodiscard]] bool is_busy() const { return result_.valid(); }

    /// How much of the mesh is built [0 to 1].
    [[nodiscard]] double share() const;

private:
    struct Progress {
        std::atomic<std::size_t> done{0};
        std::atomic<std::size_t> all{0};
    };
    void begin();

    bool at_once_;
    NavigationGroundPointer wanted_;
    NavigationGroundPointer made_of_;
    std::shared_ptr<Progress> progress_;
    std::future<Expected<std::unique_ptr<NavigationScene>>> result_;
};

}  // namespace surefoot::playground
