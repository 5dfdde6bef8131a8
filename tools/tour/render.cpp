#include "tour/render.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "tour/ground.hpp"
#include "tour/paint.hpp"
#include "tour/rows.hpp"

namespace surefoot::tools {
namespace {

/// One picture in the making: first what each pixel sees and how it is lit, then the colours, with borders smoothed by
/// four samples where neighbours see different things.
class Rendering {
public:
    explicit Rendering(const RenderInput& input)
        : input_(input),
          camera_(input.camera),
          sunshine_{.mesh = *input.mesh, .casters = {}, .one_sided = input.one_sided},
          seen_(pixel_count()),
          light_(pixel_count()) {
        const Bounds bounds = input.mesh->bounds();
        const dvec3 middle = (bounds.min + bounds.max) * 0.5;
        const double radius = glm::length(bounds.max - bounds.min);
        far_ = glm::length(camera_.eye - middle) + radius;
        // The sun stands over the left shoulder: shadows fall into the picture and to the right.
        const dvec3 flat = glm::normalize(dvec3(camera_.forward.x, 0, camera_.forward.z));
        sunshine_.to_sun = glm::normalize(dvec3(0, 1.15, 0) - camera_.right * 0.75 - flat * 0.15);
        sunshine_.far = 2 * radius;
        sunshine_.ceiling = camera_.ceiling;
        sunshine_.reach = 1.6 * input.unit;
        for (const Figure& figure : input.figures)
            if (figure.shadow)
                if (const auto* body = std::get_if<SweptEllipsoid>(&figure.solid)) sunshine_.casters.push_back(*body);
    }

    Canvas run() {
        pass(0.00, 0.60, [&](int y) { see_row(y); });
        for (const int step : {1, 2}) {
            std::vector<Light> next(light_.size());
            pass(0.60 + 0.05 * (step - 1), 0.05, [&](int y) {
                for (int x = 0; x < camera_.width; ++x) next[at(x, y)] = smoothed(light_, seen_, camera_, x, y, step);
            });
            light_ = std::move(next);
        }
        Canvas canvas(camera_.width, camera_.height);
        pass(0.70, 0.30, [&](int y) { colour_row(canvas, y); });
        return canvas;
    }

private:
    [[nodiscard]] std::size_t pixel_count() const {
        return static_cast<std::size_t>(camera_.width) * static_cast<std::size_t>(camera_.height);
    }
    [[nodiscard]] std::size_t at(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(camera_.width) + static_cast<std::size_t>(x);
    }

    template <typename Work>
    void pass(double begin, double share, const Work& work) {
        for_each_row(camera_.height, work, [&](int done) {
            if (input_.progress) input_.progress(begin + share * done / camera_.height);
        });
    }

    void see_row(int y) {
        for (int x = 0; x < camera_.width; ++x) {
            Seen& seen = seen_[at(x, y)];
            seen = look(*input_.mesh, camera_, x + 0.5, y + 0.5, far_, input_.one_sided);
            if (seen.met) light_[at(x, y)] = light_at(sunshine_, seen, static_cast<std::uint32_t>(at(x, y)));
        }
    }

    [[nodiscard]] bool alike(const Seen& a, const Seen& b) const {
        if (a.met != b.met) return false;
        if (!a.met) return true;
        return a.surface == b.surface && glm::dot(a.normal, b.normal) > 0.97 &&
               std::abs(glm::dot(a.point - b.point, a.normal)) < 3 * camera_.footprint(a.distance);
    }

    /// The light of the neighbour that sees the same piece of level, else fresh rays.
    [[nodiscard]] Light light_for(const Seen& seen, int x, int y, std::uint32_t seed) const {
        for (int j = -1; j <= 1; ++j)
            for (int i = -1; i <= 1; ++i) {
                const int px = std::clamp(x + i, 0, camera_.width - 1);
                const int py = std::clamp(y + j, 0, camera_.height - 1);
                if (alike(seen, seen_[at(px, py)])) return light_[at(px, py)];
            }
        return light_at(sunshine_, seen, seed);
    }

    [[nodiscard]] Colour colour_of_ground(const Seen& seen, const Light& light, double y) const {
        const Colour behind = sky(1 - y / camera_.height);
        if (!seen.met) return behind;
        // The level fades into the air away from what the picture is about.
        const double away = glm::length(seen.point - input_.focus) / input_.focus_reach;
        const Colour base = seen.surface < input_.surfaces.size() ? input_.surfaces[seen.surface] : Colour(0.45);
        const double haze = std::clamp((away - 1) * 0.35, 0.0, 0.8);
        return glm::mix(ground(*input_.mesh, base, camera_, seen, light, sunshine_.to_sun), behind, haze);
    }

    /// Figures whose ball may be met by lines of sight of this row.
    [[nodiscard]] std::vector<const Figure*> figures_of_row(int y) const {
        std::vector<const Figure*> figures;
        const dvec3 low = camera_.direction(camera_.width / 2.0, y - 1);
        const dvec3 high = camera_.direction(camera_.width / 2.0, y + 2);
        const dvec3 above = glm::normalize(glm::cross(camera_.right, low));
        const dvec3 below = glm::normalize(glm::cross(camera_.right, high));
        for (const Figure& figure : input_.figures) {
            const dvec3 away = figure.centre - camera_.eye;
            // Between the planes through the eye and the lines just above and below this row.
            const double over = glm::dot(away, above);
            const double under = glm::dot(away, below);
            if (std::min(over, under) <= figure.reach && std::max(over, under) >= -figure.reach)
                figures.push_back(&figure);
        }
        return figures;
    }

    struct Layer {
        double distance;
        const Figure* figure;
        Sighting sighting;
    };

    /// Bodies in front of the ground from back to front, then markers, which shine through bodies.
    [[nodiscard]] Colour with_figures(Colour colour, const std::vector<const Figure*>& figures, const dvec3& direction,
                                      double ground_distance) const {
        std::array<Layer, 48> layers;
        std::size_t count = 0;
        for (const Figure* figure : figures) {
            const dvec3 away = figure->centre - camera_.eye;
            const double along = glm::dot(away, direction);
            if (glm::dot(away, away) - along * along > figure->reach * figure->reach) continue;
            const auto sighting =
                std::visit([&](const auto& solid) { return solid.sight(camera_.eye, direction); }, figure->solid);
            if (!sighting || sighting->distance > ground_distance || count == layers.size()) continue;
            layers[count++] = {sighting->distance, figure, *sighting};
        }
        const auto end = layers.begin() + static_cast<std::ptrdiff_t>(count);
        std::sort(layers.begin(), end, [](const Layer& a, const Layer& b) {
            if (a.figure->marker != b.figure->marker) return b.figure->marker;
            return a.distance > b.distance;
        });
        double nearest_body = 1e300;
        for (auto layer = layers.begin(); layer != end; ++layer) {
            Coat paint = coat(*layer->figure, layer->sighting, direction, sunshine_.to_sun);
            if (!layer->figure->marker && !layer->figure->glass) nearest_body = std::min(nearest_body, layer->distance);
            if (layer->figure->marker && nearest_body < layer->distance) paint.alpha *= 0.55;
            colour = glm::mix(colour, paint.colour, paint.alpha);
        }
        return colour;
    }

    void colour_row(Canvas& canvas, int y) const {
        const std::vector<const Figure*> figures = figures_of_row(y);
        constexpr double quarters[4][2] = {{0.375, 0.125}, {0.875, 0.375}, {0.125, 0.625}, {0.625, 0.875}};
        for (int x = 0; x < camera_.width; ++x) {
            const Seen& middle = seen_[at(x, y)];
            const bool even = (x == 0 || alike(middle, seen_[at(x - 1, y)])) &&
                              (x + 1 == camera_.width || alike(middle, seen_[at(x + 1, y)])) &&
                              (y == 0 || alike(middle, seen_[at(x, y - 1)])) &&
                              (y + 1 == camera_.height || alike(middle, seen_[at(x, y + 1)]));
            const Colour flat = even ? colour_of_ground(middle, light_[at(x, y)], y) : Colour(0);
            Colour sum(0);
            for (std::uint32_t k = 0; k < 4; ++k) {
                const double px = x + quarters[k][0];
                const double py = y + quarters[k][1];
                const dvec3 direction = camera_.direction(px, py);
                Colour colour = flat;
                double distance = middle.met ? middle.distance : 1e300;
                if (!even) {
                    const Seen seen = look(*input_.mesh, camera_, px, py, far_, input_.one_sided);
                    const auto seed = static_cast<std::uint32_t>(at(x, y) * 4 + k);
                    colour = colour_of_ground(seen, seen.met ? light_for(seen, x, y, seed) : Light{}, py);
                    distance = seen.met ? seen.distance : 1e300;
                }
                if (!figures.empty()) colour = with_figures(colour, figures, direction, distance);
                // Colours are mixed as the eye sees them, so that a bright border does not eat a dark one.
                sum += to_eye(colour);
            }
            canvas.at(x, y) = sum * 0.25;
        }
    }

    const RenderInput& input_;
    const Camera& camera_;
    Sunshine sunshine_;
    double far_ = 1;
    std::vector<Seen> seen_;
    std::vector<Light> light_;
};

}  // namespace

Canvas render(const RenderInput& input) {
    return Rendering(input).run();
}

}  // namespace surefoot::tools
