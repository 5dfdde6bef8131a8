/// What a picture of a route shows: the level, the bodies that were swept through it, and the contacts.
#pragma once

#include <variant>
#include <vector>

#include <surefoot/mesh.hpp>

#include "tour/canvas.hpp"
#include "tour/route.hpp"
#include "tour/solids.hpp"

namespace surefoot::tools {

/// A solid with its colour.
struct Figure {
    std::variant<SweptEllipsoid, ArrowHead> solid;
    Colour colour{1, 1, 1};
    double alpha = 1;       ///< how much it hides what is behind it [0, 1]
    bool glass = false;     ///< clearer in the middle than at its rim
    bool marker = false;    ///< shines through the bodies, though not through the level
    bool shadow = false;    ///< casts one
    dvec3 centre{0, 0, 0};  ///< of a ball around it
    double reach = 0;
};

/// The colour that stands for a feature, in the picture and its legend.
[[nodiscard]] Colour colour_of(Feature feature);

/// The bodies where they stopped, the volumes they swept, the contacts and their normals.
[[nodiscard]] std::vector<Figure> figures_of(const Route& route, const Walker& walker);

/// One contact alone: the body at its start, at its touch, the contact and its normal, larger.
[[nodiscard]] std::vector<Figure> figures_of(const Leg& leg, const Walker& walker);

}  // namespace surefoot::tools
