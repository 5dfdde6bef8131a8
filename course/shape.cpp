#include "course/shape.hpp"

#include <algorithm>
#include <cmath>

namespace surefoot::course {
namespace {

template <typename... Cases>
struct Overloaded : Cases... {
    using Cases::operator()...;
};
template <typename... Cases>
Overloaded(Cases...) -> Overloaded<Cases...>;  // which clang 14 does not find by itself

template <typename... Cases>
double of_shape(const CharacterSettings& settings, Cases... cases) {
    return std::visit(Overloaded{cases...}, settings.volume.shape);
}

constexpr ShapeName names[] = {
    {BodyShape::capsule, "capsule", "1.8 m high, 0.8 m wide"},
    {BodyShape::ellipsoid, "ellipsoid", "as high and as wide"},
    {BodyShape::sphere, "sphere", "as wide, and so 0.8 m high"},
    {BodyShape::box, "box", "as high and as wide, square to the axes"},
    {BodyShape::cylinder, "cylinder", "as high and as wide"},
    {BodyShape::cone, "cone", "as high and as wide, its apex down"},
};

}  // namespace

std::span<const ShapeName> shapes() {
    return names;
}

Volume volume_as(BodyShape shape, const Capsule& capsule) {
    const double wide = capsule.radius, high = capsule.half_height + capsule.radius;
    switch (shape) {
        case BodyShape::capsule:
            break;
        case BodyShape::ellipsoid:
            return Ellipsoid{{wide, high, wide}};
        case BodyShape::sphere:
            return Sphere{wide};
        case BodyShape::box:
            return Box{{wide, high, wide}};
        case BodyShape::cylinder:
            return Cylinder{wide, high};
        case BodyShape::cone:
            return Cone{wide, 2 * high};
    }
    return capsule;
}

Capsule capsule_of(const CharacterSettings& settings) {
    return std::get<Capsule>(settings.volume.shape);
}

double standing(const CharacterSettings& settings) {
    return of_shape(
        settings, [](const Sphere& ball) { return ball.radius; }, [](const Ellipsoid& body) { return body.radii.y; },
        [](const Capsule& body) { return body.half_height + body.radius; },
        [](const Box& body) { return body.half_extents.y; }, [](const Cylinder& body) { return body.half_height; },
        [](const Cone& body) { return 0.5 * body.height; });
}

double gap_below(const CharacterSettings& settings) {
    const Cone* cone = std::get_if<Cone>(&settings.volume.shape);
    return settings.skin * (cone != nullptr ? std::hypot(cone->radius, cone->height) / cone->radius : 1);
}

double half_width(const CharacterSettings& settings) {
    return reach(settings, {1, 0, 0});
}

double reach(const CharacterSettings& settings, const dvec3& direction) {
    const double x = direction.x;  // clang 14 captures no structured bindings
    const double y = direction.y;
    const double z = direction.z;
    const double level = std::hypot(x, z);
    return of_shape(
        settings, [](const Sphere& ball) { return ball.radius; },
        [=](const Ellipsoid& body) { return std::hypot(body.radii.x * x, body.radii.y * y, body.radii.z * z); },
        [=](const Capsule& body) { return body.half_height * std::abs(y) + body.radius; },
        [=](const Box& body) {
            const dvec3& half = body.half_extents;
            return half.x * std::abs(x) + half.y * std::abs(y) + half.z * std::abs(z);
        },
        [=](const Cylinder& body) { return body.half_height * std::abs(y) + body.radius * level; },
        [=](const Cone& body) {
            return std::max(-0.5 * body.height * y, 0.5 * body.height * y + body.radius * level);
        });
}

dvec3 reference_from_centre(const CharacterSettings& settings) {
    const Cone* cone = std::get_if<Cone>(&settings.volume.shape);
    return {0, cone != nullptr ? -0.5 * cone->height : 0, 0};
}

double touches_below(const CharacterSettings& settings, double degrees) {
    // The point that is farthest along -n has its height from how the reach changes with the vertical part of n.
    const double a = degrees * 0.017453292519943295, s = std::sin(a), c = std::cos(a);
    return of_shape(
        settings, [=](const Sphere& ball) { return ball.radius * c; },
        [=](const Ellipsoid& body) {
            return body.radii.y * body.radii.y * c / std::hypot(body.radii.x * s, body.radii.y * c);
        },
        [=](const Capsule& body) { return body.half_height + body.radius * c; },
        [](const Box& body) { return body.half_extents.y; }, [](const Cylinder& body) { return body.half_height; },
        [=](const Cone& body) { return (body.height * c >= body.radius * s ? 0.5 : -0.5) * body.height; });
}

double tapered_end(const CharacterSettings& settings) {
    return of_shape(
        settings, [](const Sphere& ball) { return ball.radius; }, [](const Ellipsoid& body) { return body.radii.y; },
        [](const Capsule& body) { return body.radius; }, [](const Box&) { return 0.0; },
        [](const Cylinder&) { return 0.0; }, [](const Cone& body) { return body.height; });
}

double dip(const CharacterSettings& settings, double distance) {
    const double skin = settings.skin, d = std::max(0.0, distance);
    const auto round = [&](double wide, double high) {
        const double share = std::min(1.0, d / (wide + skin));
        return (high + skin) * (1 - std::sqrt(1 - share * share));
    };
    return of_shape(
        settings, [&](const Sphere& ball) { return round(ball.radius, ball.radius); },
        [&](const Ellipsoid& body) { return round(body.radii.x, body.radii.y); },
        [&](const Capsule& body) { return round(body.radius, body.radius); }, [](const Box&) { return 0.0; },
        [](const Cylinder&) { return 0.0; }, [&](const Cone& body) { return d * body.height / body.radius; });
}

GrownBody grown_body(const CharacterSettings& settings, double by) {
    return std::visit(
        Overloaded{
            [=](const Sphere& ball) { return GrownBody{Sphere{ball.radius + by}}; },
            [=](const Ellipsoid& body) {
                return GrownBody{Ellipsoid{body.radii + dvec3{by, by, by}}};
            },
            [=](const Capsule& body) {
                return GrownBody{Capsule{body.radius + by, body.half_height}};
            },
            [=](const Box& body) {
                return GrownBody{Box{body.half_extents + dvec3{by, by, by}}};
            },
            [=](const Cylinder& body) {
                return GrownBody{Cylinder{body.radius + by, body.half_height + by}};
            },
            [=](const Cone& body) {
                // The side goes out along its normal, which takes the apex down; the disc goes up by as much.
                const double down = by * std::hypot(body.radius, body.height) / body.radius;
                const double high = body.height + down + by;
                return GrownBody{Cone{body.radius * high / body.height, high}, {0, -0.5 * body.height - down, 0}};
            },
        },
        settings.volume.shape);
}

}  // namespace surefoot::course
