#include "platformer/play/sky_look.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace surefoot::platformer {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double far_away = 1500;  // where moon and stars are [m]

/// 0 to 1; the same for the same numbers.
double chance(std::uint32_t number, std::uint32_t which) {
    std::uint32_t h = number * 0x9E3779B1U ^ (which + 1) * 0x85EBCA77U;
    h = (h ^ h >> 15U) * 0x2C1B3C6DU;
    h = (h ^ h >> 13U) * 0x297A2D39U;
    return (h ^ h >> 16U) / 4294967296.0;
}

/// Balls of few triangles, drawn flat.
struct Puffs {
    std::vector<vec3> vertices;
    std::vector<std::uint32_t> indices;

    void add(const dvec3& middle, const dvec3& radii, double turn) {
        constexpr std::array degrees{40.0, -18.0};
        constexpr std::uint32_t around = 7;
        const auto first = static_cast<std::uint32_t>(vertices.size());
        vertices.emplace_back(middle + dvec3(0, radii.y, 0));
        vertices.emplace_back(middle - dvec3(0, 0.7 * radii.y, 0));
        for (const double up : degrees)
            for (std::uint32_t i = 0; i < around; ++i) {
                const double angle = turn + 2 * pi * i / around;
                const double level = std::cos(up * pi / 180);
                vertices.emplace_back(middle + dvec3(radii.x * level * std::cos(angle),
                                                     radii.y * std::sin(up * pi / 180),
                                                     radii.z * level * std::sin(angle)));
            }
        const auto at = [&](std::uint32_t ring, std::uint32_t i) { return first + 2 + ring * around + i % around; };
        for (std::uint32_t i = 0; i < around; ++i) {
            indices.insert(indices.end(), {first, at(0, i + 1), at(0, i), first + 1, at(1, i), at(1, i + 1)});
            indices.insert(indices.end(), {at(0, i), at(0, i + 1), at(1, i), at(0, i + 1), at(1, i + 1), at(1, i)});
        }
    }

    void add_cloud(const dvec3& place, double size, std::uint32_t number) {
        const double turn = pi * chance(number, 10);
        for (std::uint32_t i = 0; i < 3; ++i) {
            const double along = (i - 1.0) * 0.72 * size;
            const double tall = (i == 1 ? 0.42 : 0.27) * size * (0.85 + 0.3 * chance(number, 11 + i));
            add(place + dvec3(std::cos(turn) * along, 0.3 * tall, std::sin(turn) * along),
                {size * (0.55 + 0.2 * chance(number, 15 + i)), tall, size * (0.45 + 0.15 * chance(number, 19 + i))},
                6 * chance(number, 23 + i));
        }
    }
};

view::Colour shown(const vec3& light) {
    const auto byte = [](float x) {
        return static_cast<std::uint8_t>(std::lround(std::sqrt(std::clamp(x, 0.0F, 1.0F)) * 255));
    };
    return {byte(light.x), byte(light.y), byte(light.z), 255};
}

}  // namespace

view::Sky sky_of(const std::string& name) {
    view::Sky sky;
    sky.shadow_radius = 60;
    sky.fog_distance = 260;
    // Softer than noon, so that snow and sand keep their drawing, and bluer.
    sky.towards_sun = {0.52, 0.74, 0.43};
    sky.sun = {0.98F, 0.88F, 0.70F};
    sky.above = {0.29F, 0.36F, 0.48F};
    sky.below = {0.22F, 0.20F, 0.20F};
    sky.zenith = {0.07F, 0.27F, 0.64F};
    sky.horizon = {0.58F, 0.77F, 0.88F};
    sky.nadir = {0.42F, 0.62F, 0.78F};
    if (name == "dusk") {
        sky.towards_sun = {0.78, 0.38, 0.5};
        sky.sun = {1.20F, 0.74F, 0.45F};
        sky.above = {0.45F, 0.42F, 0.62F};
        sky.below = {0.32F, 0.24F, 0.28F};
        sky.zenith = {0.11F, 0.13F, 0.36F};
        sky.horizon = {0.88F, 0.48F, 0.33F};
        sky.nadir = {0.36F, 0.28F, 0.38F};
    } else if (name == "night") {
        // A full moon from the side: one face of everything is bright, and the sky behind it is not black.
        sky.towards_sun = {-0.72, 0.50, 0.48};
        sky.sun = {0.86F, 0.98F, 1.20F};
        sky.above = {0.30F, 0.35F, 0.54F};
        sky.below = {0.18F, 0.17F, 0.30F};
        sky.zenith = {0.010F, 0.018F, 0.075F};
        sky.horizon = {0.085F, 0.13F, 0.29F};
        sky.nadir = {0.035F, 0.045F, 0.13F};
        sky.fog_distance = 190;
    } else if (name == "cave") {
        sky.towards_sun = {0.2, 0.95, 0.25};
        sky.sun = {0.70F, 0.64F, 0.56F};
        sky.above = {0.30F, 0.32F, 0.38F};
        sky.below = {0.20F, 0.17F, 0.16F};
        sky.zenith = {0.035F, 0.05F, 0.07F};
        sky.horizon = {0.12F, 0.16F, 0.19F};
        sky.nadir = {0.06F, 0.07F, 0.09F};
        sky.fog_distance = 120;
    }
    return sky;
}

SkyLook::SkyLook(const std::string& name, const Bounds& box, double lowest) : sky_(sky_of(name)) {
    is_open_ = name != "cave";
    darkness_ = name == "night" ? 1 : name == "cave" ? 0.8 : name == "dusk" ? 0.42 : 0.15;
    if (!is_open_) return;
    make_clouds(box, lowest);
    if (darkness_ < 0.4) return;
    const std::uint32_t how_many = darkness_ >= 1 ? 180 : 60;
    for (std::uint32_t i = 0; i < how_many; ++i) {
        const double up = 0.06 + 0.94 * chance(i, 20);
        const double turn = 2 * pi * chance(i, 21);
        const double level = std::sqrt(1 - up * up);
        const double bright = chance(i, 22);
        stars_.push_back({.place = dvec3(level * std::cos(turn), up, level * std::sin(turn)) * far_away,
                          .radius = far_away * (0.0022 + 0.0030 * bright * bright * bright),
                          .colour = view::with_opacity(view::rgb(chance(i, 23) < 0.3 ? 0xFFE3BC : 0xDCE8FF),
                                                       (0.35 + 0.65 * bright) * std::min(1.0, up * 3) * darkness_),
                          .core = 0.3,
                          .is_light = true});
    }
}

void SkyLook::make_clouds(const Bounds& box, double lowest) {
    const dvec3 middle = (box.min + box.max) * 0.5;
    const dvec3 half = (box.max - box.min) * 0.5;
    Puffs puffs;
    std::uint32_t number = 0;
    // A ring of clouds around the level, and a sea of them below it.
    for (int i = 0; i < 12; ++i, ++number) {
        const double turn = 2 * pi * (i + 0.8 * chance(number, 0)) / 12;
        const double away = 70 + 60 * chance(number, 1);
        puffs.add_cloud({middle.x + std::cos(turn) * (half.x + away),
                         box.min.y + (0.2 + 1.0 * chance(number, 2)) * (box.max.y - box.min.y + 24),
                         middle.z + std::sin(turn) * (half.z + away)},
                        9 + 8 * chance(number, 3), number);
    }
    for (int i = 0; i < 18; ++i, ++number)
        puffs.add_cloud({middle.x + (2 * chance(number, 0) - 1) * (half.x + 60), lowest - 12 - 10 * chance(number, 1),
                         middle.z + (2 * chance(number, 2) - 1) * (half.z + 60)},
                        10 + 9 * chance(number, 3), number);
    const auto mesh = Mesh::build({.vertices = puffs.vertices, .indices = puffs.indices});
    if (!mesh) return;  // of numbers that are all small there is always one
    // Of the colour of the air that they are in, so that they are as bright as the hour.
    const view::Colour colour = shown(sky_.horizon * 0.9F + sky_.sun * static_cast<float>(0.34 * (1 - darkness_)));
    clouds_ = view::Model::make(*mesh, [&](const SourceTriangle&) { return view::Finish{colour, 0.35}; });
}

void SkyLook::draw(view::Renderer& renderer, double seconds) const {
    renderer.sky = sky_;
    const dvec3 eye = renderer.view().camera.eye;
    // To and fro, and never on to the level.
    if (clouds_) renderer.model(clouds_, {.casts_shadow = false}, {.position = {6 * std::sin(seconds * 0.02), 0, 0}});
    for (view::Disc star : stars_) {
        star.place += eye;
        renderer.disc(star);
    }
    if (!is_open_) return;
    const dvec3 sun = eye + glm::normalize(sky_.towards_sun) * far_away;
    const bool is_moon = darkness_ >= 1;
    const view::Colour colour = is_moon           ? view::rgb(0xF1F4FF)
                                : darkness_ > 0.4 ? view::rgb(0xFFD9A0)
                                                  : view::rgb(0xFFF6DC);
    // A small halo: the sky itself is bright around the sun.
    renderer.disc(
        {.place = sun, .radius = far_away * 0.13, .colour = view::with_opacity(colour, 0.35), .is_light = true});
    renderer.disc({.place = sun, .radius = far_away * 0.055, .colour = colour, .core = 0.9});
    if (!is_moon) return;
    const auto [side, other] = view::across(glm::normalize(sky_.towards_sun));
    for (const dvec3& spot : {dvec3(0.3, 0.2, 0.30), dvec3(-0.25, -0.3, 0.22), dvec3(-0.1, 0.4, 0.16)})
        renderer.disc({.place = sun + (side * spot.x + other * spot.y) * (far_away * 0.055),
                       .radius = far_away * 0.055 * spot.z,
                       .colour = view::rgb(0xC9D2EC, 0.8),
                       .core = 0.6});
}

}  // namespace surefoot::platformer
