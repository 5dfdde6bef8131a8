#include "playtest/report/frame.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <thread>
#include <utility>
#include <vector>

#include "playtest/report/frame_sky.hpp"
#include "playtest/vectors.hpp"

namespace surefoot::playtest {
namespace {

constexpr double farthest = 350;      // that anything is seen [m]
constexpr double sun_reach = 120;     // what casts a shadow is nearer than this [m]
constexpr double lift = 2e-3;         // of a place off its triangle, before it looks for the sun [m]
constexpr double water_share = 0.38;  // of the colour of what lies behind its surface
constexpr dvec3 water_colour{0.18, 0.61, 0.84};
constexpr dvec3 hero_colour{1.0, 0.5, 0.1};
constexpr double hero_reach = 1.1;   // no part of it is farther from its middle [m]
constexpr double dots_from = 2.5;    // the eye, so that none fills the picture [m]
constexpr double hero_share = 0.35;  // of the hero, through what hides it

const WorldQuery now{.begin = 1, .end = 1};  // bodies have reached the end of their tick, as the hero has

dvec3 mixed(const dvec3& a, const dvec3& b, double share) {
    return a + (b - a) * share;
}

// Colours are squared to compute with light and rooted to show it.
dvec3 as_light(const dvec3& colour) {
    return colour * colour;
}

constexpr std::uint64_t figure_bit = std::uint64_t{1} << 40U;  // what is no part of the game's own world
constexpr std::uint64_t decor_bit = std::uint64_t{1} << 60U;

// What a line of sight meets first.
struct Seen {
    double distance = farthest;
    dvec3 normal{0, 0, 0};
    dvec3 colour{0, 0, 0};
    double glow = 0;
    std::uint64_t what = 0;  // of one kind, so that where it changes there is a border

    [[nodiscard]] bool is_sky() const { return what == 0; }
    [[nodiscard]] bool is_hero() const { return what >> 10U == figure_bit + Figures::hero; }
};

class Painting {
public:
    Painting(const game::Game& game, const FrameCamera& camera, const World& figures, const FrameSize& size)
        : game_(game),
          level_(game.level()),
          figures_(figures),
          camera_(camera),
          sky_(frame_sky(level_.sky)),
          size_(size),
          per_pixel_(2 * std::tan(camera.field_of_view / 2) / size.height),
          decor_from_(std::max(0.0, length(game.hero().body.position - camera.eye) - hero_reach)),
          seen_(std::size_t(size.width) * std::size_t(size.height)),
          picture_(size.width, size.height) {}

    Picture run() {
        for_each_row([this](int y) {
            for (int x = 0; x < size_.width; ++x) seen_[at(x, y)] = look(direction(x + 0.5, y + 0.5));
        });
        for_each_row([this](int y) {
            for (int x = 0; x < size_.width; ++x) put(x, y, colour_of_pixel(x, y));
        });
        return std::move(picture_);
    }

private:
    // Each row is a thread's own, so that the picture does not depend on who drew it.
    template <typename Work>
    void for_each_row(const Work& work) const {
        std::atomic<int> next{0};
        const auto run = [&] {
            for (int y = next++; y < size_.height; y = next++) work(y);
        };
        std::vector<std::jthread> helpers;
        for (unsigned i = 1; i < std::thread::hardware_concurrency(); ++i) helpers.emplace_back(run);
        run();
    }

    [[nodiscard]] std::size_t at(int x, int y) const {
        return std::size_t(y) * std::size_t(size_.width) + std::size_t(x);
    }

    [[nodiscard]] dvec3 direction(double x, double y) const {
        return unit(camera_.forward + camera_.right * ((x - 0.5 * size_.width) * per_pixel_) +
                    camera_.up * ((0.5 * size_.height - y) * per_pixel_));
    }

    [[nodiscard]] dvec3 material_colour(std::uint32_t surface) const {
        static constexpr std::array<dvec3, 4> others{
            {{0.78, 0.76, 0.71}, {0.66, 0.71, 0.62}, {0.72, 0.64, 0.57}, {0.61, 0.66, 0.72}}};
        if (surface < level_.materials.size() && level_.materials[surface].colour) {
            const auto& colour = *level_.materials[surface].colour;
            return {colour[0], colour[1], colour[2]};
        }
        return others[surface % others.size()];
    }

    [[nodiscard]] double material_glow(std::uint32_t surface) const {
        return surface < level_.materials.size() ? level_.materials[surface].glow : 0;
    }

    [[nodiscard]] Seen look(const dvec3& way) const {
        Seen seen;
        if (const auto hit = game_.world().ray({camera_.eye, camera_.eye + way * farthest}, now);
            hit && hit->status == HitStatus::ok) {
            seen = {.distance = hit->t * farthest,
                    .normal = hit->normal,
                    .colour = material_colour(hit->surface),
                    .glow = material_glow(hit->surface),
                    .what = (std::uint64_t(hit->body) + 1) * 1024 + hit->surface};
        }
        if (const auto hit = figures_.ray({camera_.eye, camera_.eye + way * seen.distance}, now);
            hit && hit->status == HitStatus::ok) {
            const Paint& paint = paint_of(hit->surface);
            seen = {.distance = hit->t * seen.distance,
                    .normal = hit->normal,
                    .colour = paint.colour,
                    .glow = paint.glow,
                    .what = (figure_bit + hit->body) * 1024 + hit->surface};
        }
        // Nothing holds the eye off what is drawn only: a tree before the hero is left out.
        const double room = seen.distance - decor_from_;
        if (room <= 0) return seen;
        if (const auto hit = level_.decor.ray({camera_.eye + way * decor_from_, camera_.eye + way * seen.distance});
            hit && hit->status == HitStatus::ok)
            seen = {.distance = decor_from_ + hit->t * room,
                    .normal = hit->normal,
                    .colour = material_colour(hit->surface),
                    .glow = material_glow(hit->surface),
                    .what = decor_bit + hit->surface};
        return seen;
    }

    [[nodiscard]] bool is_in_sun(const dvec3& place) const {
        const Motion ray{place, place + sky_.towards_sun * sun_reach};
        return !game_.world().ray_any(ray, now) &&
               !figures_.ray_any(ray, {.layers = Figures::solid, .begin = 1, .end = 1}) && !level_.decor.ray_any(ray);
    }

    [[nodiscard]] dvec3 sky_colour(const dvec3& way) const {
        const double height = std::pow(std::abs(way.y), 0.6);
        return way.y > 0 ? mixed(sky_.horizon, sky_.zenith, height) : mixed(sky_.horizon, sky_.nadir, height);
    }

    [[nodiscard]] dvec3 shaded(const Seen& seen, const dvec3& way) const {
        const dvec3 albedo = as_light(seen.colour);
        const double facing = dot(seen.normal, sky_.towards_sun);
        dvec3 light = mixed(sky_.below, sky_.above, 0.5 + 0.5 * seen.normal.y);
        const dvec3 place = camera_.eye + way * seen.distance + seen.normal * lift;
        if (facing > 0 && is_in_sun(place)) light += sky_.sun * facing;
        const dvec3 lit = albedo * mixed(light, {1, 1, 1}, seen.glow);
        const double haze = seen.distance * seen.distance / (sky_.fog_distance * sky_.fog_distance);
        return mixed(lit, sky_.horizon, haze / (1 + haze));
    }

    // Is there any water between the eye and this distance?
    [[nodiscard]] bool passes_water(const dvec3& way, double distance) const {
        return std::ranges::any_of(level_.waters, [&](const game::Zone& water) {
            const Pose pose{water.middle, water.orientation};
            const dvec3 eye = to_body(pose, camera_.eye);
            const dvec3 end = to_body(pose, camera_.eye + way * distance);
            double enters = 0;
            double leaves = 1;
            for (int i = 0; i < 3; ++i) {
                const double step = end[i] - eye[i];
                if (std::abs(step) < 1e-12) {
                    if (std::abs(eye[i]) > water.half[i]) return false;
                    continue;
                }
                const double a = (-water.half[i] - eye[i]) / step;
                const double b = (water.half[i] - eye[i]) / step;
                enters = std::max(enters, std::min(a, b));
                leaves = std::min(leaves, std::max(a, b));
            }
            return enters < leaves;
        });
    }

    // Whoever hides the hero lets it shine through: it is what the picture is about.
    [[nodiscard]] bool hides_hero(const Seen& seen, const dvec3& way) const {
        if (seen.is_hero()) return false;
        const dvec3 to_hero = game_.hero().body.position - camera_.eye;
        const double along = dot(to_hero, way);
        if (dot(to_hero, to_hero) - along * along > hero_reach * hero_reach) return false;
        const auto is_hero = [](std::uint32_t body) { return body == Figures::hero; };
        return figures_.ray_any({camera_.eye, camera_.eye + way * farthest},
                                {.bodies = BodyFilter(is_hero), .begin = 1, .end = 1});
    }

    [[nodiscard]] dvec3 colour_of(const Seen& seen, const dvec3& way) const {
        dvec3 colour = seen.is_sky() ? sky_colour(way) : shaded(seen, way);
        if (passes_water(way, seen.distance)) colour = mixed(colour, as_light(water_colour), water_share);
        return hides_hero(seen, way) ? mixed(colour, as_light(hero_colour), hero_share) : colour;
    }

    [[nodiscard]] static bool alike(const Seen& a, const Seen& b) {
        return a.what == b.what && dot(a.normal, b.normal) > 0.98 - (a.is_sky() ? 1 : 0) &&
               std::abs(a.distance - b.distance) < 0.04 * std::min(a.distance, b.distance);
    }

    // One sample where a pixel sees what its neighbours see, four where it does not.
    [[nodiscard]] dvec3 colour_of_pixel(int x, int y) const {
        const Seen& middle = seen_[at(x, y)];
        const bool even = (x == 0 || alike(middle, seen_[at(x - 1, y)])) &&
                          (y == 0 || alike(middle, seen_[at(x, y - 1)])) &&
                          (x + 1 == size_.width || alike(middle, seen_[at(x + 1, y)])) &&
                          (y + 1 == size_.height || alike(middle, seen_[at(x, y + 1)]));
        if (even) return shown(colour_of(middle, direction(x + 0.5, y + 0.5)));
        dvec3 sum{0, 0, 0};
        for (const auto& [dx, dy] : {std::pair{0.25, 0.25}, {0.75, 0.25}, {0.25, 0.75}, {0.75, 0.75}}) {
            const dvec3 way = direction(x + dx, y + dy);
            sum += shown(colour_of(look(way), way));
        }
        return sum / 4.0;
    }

    [[nodiscard]] static dvec3 shown(const dvec3& light) {
        return {std::sqrt(std::clamp(light.x, 0.0, 1.0)), std::sqrt(std::clamp(light.y, 0.0, 1.0)),
                std::sqrt(std::clamp(light.z, 0.0, 1.0))};
    }

    void put(int x, int y, const dvec3& colour) {
        std::uint8_t* const pixel = &picture_.rgba[4 * at(x, y)];
        for (int i = 0; i < 3; ++i) pixel[i] = std::uint8_t(std::lround(255 * colour[i]));
        pixel[3] = 255;
    }

    const game::Game& game_;
    const game::Level& level_;
    const World& figures_;
    const FrameCamera& camera_;
    const FrameSky& sky_;
    FrameSize size_;
    double per_pixel_;
    double decor_from_;  // the eye [m]
    std::vector<Seen> seen_;
    Picture picture_;
};

}  // namespace

Picture FramePainter::paint(const game::Game& game, const FrameCamera& camera, std::span<const dvec3> trail,
                            const FrameSize& size) const {
    std::vector<dvec3> dots;
    for (const dvec3& place : trail)
        if (length(place - camera.eye) > dots_from) dots.push_back(place);
    const World figures = figures_.stage(game, dots);
    return Painting(game, camera, figures, size).run();
}

}  // namespace surefoot::playtest
