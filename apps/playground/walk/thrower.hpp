/// Throws shapes at a level: each sweeps from the eye through the place that was clicked, and stays where it stops.
#pragma once

#include <optional>
#include <vector>

#include <surefoot/mesh.hpp>

#include "playground/level_loader.hpp"
#include "view/renderer.hpp"

namespace surefoot::playground {

class Thrower {
public:
    struct Throw {
        Volume volume;
        Motion motion;
        std::optional<Hit> hit;
        QueryWork work;
        double microseconds = 0;  ///< what the sweep took
        double age = 0;           ///< [s]
        double flight = 0;        ///< how long it is shown flying [s]
        view::Colour colour;

        [[nodiscard]] dvec3 position() const;
        [[nodiscard]] bool landed() const { return age >= flight; }
    };

    /// Sweeps from `from` along `direction`, `length` metres far.
    void throw_at(const Mesh& mesh, const dvec3& from, const dvec3& direction, double length);
    bool update(double dt);
    void draw(view::Renderer& renderer, const tools::Level& level) const;
    void ui(const tools::Level& level);
    void clear() { throws_.clear(); }

    [[nodiscard]] const std::vector<Throw>& throws() const { return throws_; }
    [[nodiscard]] Shape shape() const;

    bool timed = true;  ///< print how long sweeps took, which differs from run to run

private:
    int kind_ = 0;
    double wide_ = 0.4;
    double high_ = 0.9;
    std::vector<Throw> throws_;
};

}  // namespace surefoot::playground
