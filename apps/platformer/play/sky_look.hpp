/// The sky of a level: its light by the hour, and what stands in it: clouds, a moon, stars.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <surefoot/bounds.hpp>

#include "view/renderer.hpp"

namespace surefoot::platformer {

/// Of the hour that a level names: "day", "dusk", "night", "cave"; the day for any other word.
[[nodiscard]] view::Sky sky_of(const std::string& name);

class SkyLook {
public:
    /// `box` holds the level, and `lowest` is where who falls is gone [m]: a sea of clouds lies below it.
    SkyLook(const std::string& name, const Bounds& box, double lowest);

    /// `seconds` moves the clouds; the sky itself goes into the renderer.
    void draw(view::Renderer& renderer, double seconds) const;

    /// How much what shines stands out: 0 by day, 1 at night.
    [[nodiscard]] double darkness() const { return darkness_; }

private:
    void make_clouds(const Bounds& box, double lowest);

    view::Sky sky_;
    double darkness_ = 0;
    bool is_open_ = true;  // no roof over it
    std::shared_ptr<const view::Model> clouds_;
    std::vector<view::Disc> stars_;  // seen from the eye
};

}  // namespace surefoot::platformer
