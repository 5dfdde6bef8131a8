/// An ellipsoid in the level to which everybody runs: put where one clicks, and grabbed and dragged.
#pragma once

#include <optional>

#include <surefoot/shapes.hpp>

#include "playground/navigation/scene.hpp"
#include "view/camera.hpp"

namespace surefoot::playground {

class NavigationTarget {
public:
    /// Where one looks from, and how large the picture is.
    struct Eye {
        view::Camera camera;
        view::ivec2 size;
    };

    explicit NavigationTarget(const NavigationScene& scene);

    [[nodiscard]] const dvec3& feet() const { return feet_; }
    [[nodiscard]] dvec3 middle() const;
    [[nodiscard]] const Ellipsoid& shape() const { return shape_; }
    [[nodiscard]] bool is_held() const { return held_.has_value(); }

    void put(const dvec3& feet) { feet_ = feet; }

    /// Where on the level the pointer is: a ray against the environment.
    [[nodiscard]] std::optional<dvec3> place_under(const view::dvec2& at, const Eye& eye) const;

    /// Is the pointer on the ellipsoid, with nothing of the level before it? A ray against the ellipsoid itself.
    [[nodiscard]] bool is_under(const view::dvec2& at, const Eye& eye) const;

    /// Takes hold of it if the pointer is on it.
    bool grab(const view::dvec2& at, const Eye& eye);
    /// Its feet go over the level with the pointer; false where there is no level under it, or if it is not held.
    bool drag(const view::dvec2& at, const Eye& eye);
    void let_go() { held_.reset(); }

private:
    const NavigationScene* scene_;
    Ellipsoid shape_;
    dvec3 feet_{0, 0, 0};
    std::optional<view::dvec2> held_;  // from the pointer to its feet, on the picture
};

}  // namespace surefoot::playground
