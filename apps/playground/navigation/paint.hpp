/// What the navigation overlay draws, each by itself.
#pragma once

#include <span>

#include "playground/navigation/runners.hpp"
#include "playground/navigation/scene.hpp"
#include "playground/navigation/target.hpp"
#include "playground/navigation/way.hpp"
#include "view/renderer.hpp"

namespace surefoot::playground::navigation_paint {

[[nodiscard]] view::Colour area_colour(std::uint32_t area);
[[nodiscard]] view::Colour link_colour(NavigationLinkKind kind);

inline constexpr view::Colour open_node = view::rgb(0xFFD43B);    ///< waits to be looked at
inline constexpr view::Colour closed_node = view::rgb(0x9775FA);  ///< is done with
inline constexpr view::Colour raw = view::rgb(0xD6336C);
inline constexpr view::Colour pulled = view::rgb(0xFFF3BF);
inline constexpr view::Colour portal = view::rgb(0xF08C00);

/// Polygons in the colour of their area, their sides, and where the mesh ends. What was taken out is grey and hatched.
void mesh(view::Renderer& renderer, const NavigationScene& scene);

void portals(view::Renderer& renderer, const NavigationScene& scene, const NavigationPath& path);
void raw_path(view::Renderer& renderer, const NavigationScene& scene, const NavigationWay& way);
void pulled_path(view::Renderer& renderer, const NavigationScene& scene, const NavigationWay& way);
void links(view::Renderer& renderer, const NavigationScene& scene);
void search(view::Renderer& renderer, const NavigationScene& scene, std::span<const NavigationSearchNode> nodes,
            const NavigationSearchNode* looked_at);
void start(view::Renderer& renderer, const NavigationScene& scene, const dvec3& feet);
void target(view::Renderer& renderer, const NavigationTarget& target, bool is_hovered, bool is_reached);
void runners(view::Renderer& renderer, const NavigationScene& scene, const NavigationRunners& runners, double waiting);

}  // namespace surefoot::playground::navigation_paint
