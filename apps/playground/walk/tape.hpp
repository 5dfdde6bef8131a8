/// A measuring tape: two clicks, and how far, how high and how steep it is between them.
#pragma once

#include <optional>

#include "view/renderer.hpp"

namespace surefoot::playground {

struct Measured {
    double distance = 0;   ///< [m]
    double flat = 0;       ///< across `up` [m]
    double height = 0;     ///< along `up` [m]
    double slope_deg = 0;  ///< how steep the way is [degrees, -90 to 90]
};

[[nodiscard]] Measured measure(const dvec3& from, const dvec3& to, const dvec3& up);

class Tape {
public:
    /// The first point, the second, and again the first of another.
    void click(const dvec3& place);
    void hover(const std::optional<dvec3>& place) { over_ = place; }
    void clear() { from_.reset(), to_.reset(); }

    void draw(view::Renderer& renderer, const dvec3& up) const;
    void ui(const dvec3& up) const;

private:
    [[nodiscard]] std::optional<dvec3> end() const { return to_ ? to_ : over_; }

    std::optional<dvec3> from_;
    std::optional<dvec3> to_;
    std::optional<dvec3> over_;
};

}  // namespace surefoot::playground
