#include "exact_contact.hpp"

#include <cstdlib>

namespace judge {
namespace {

struct Ints {
    long long x = 0, y = 0, z = 0;
};
Ints operator+(const Ints& a, const Ints& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
Ints operator*(const Ints& a, long long k) {
    return {a.x * k, a.y * k, a.z * k};
}
Ints cross(const Ints& a, const Ints& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
long long dot(const Ints& a, const Ints& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// Divides out what the three have in common.
Ints reduced(Ints v) {
    long long g = 0;
    for (long long part : {v.x, v.y, v.z}) {
        part = std::llabs(part);
        while (part != 0) {
            const long long rest = g % part;
            g = part;
            part = rest;
        }
    }
    return g > 1 ? Ints{v.x / g, v.y / g, v.z / g} : v;
}

struct Surface {
    Ints size, point, out;
    bool sharp = false;
};

/// A vector of length 5 in two of its parts.
void draw_345(Draw& draw, long long& a, long long& b) {
    switch (draw.pick(4)) {
        case 0:
            a = 3, b = 4;
            break;
        case 1:
            a = 4, b = 3;
            break;
        case 2:
            a = 5, b = 0;
            break;
        default:
            a = 0, b = 5;
    }
    if (draw.coin()) a = -a;
    if (draw.coin()) b = -b;
}

Ints draw_on_sphere(Draw& draw) {
    long long a = 0, b = 0;
    draw_345(draw, a, b);
    const int hole = draw.pick(3);
    return hole == 0 ? Ints{0, a, b} : (hole == 1 ? Ints{a, 0, b} : Ints{a, b, 0});
}

Surface draw_surface(Draw& draw, Kind kind) {
    const long long tall = draw.integer(1, 9);
    long long a = 0, b = 0;
    draw_345(draw, a, b);
    switch (kind) {
        case Kind::sphere: {
            const Ints p = draw_on_sphere(draw);
            return {{5, 0, 0}, p, p};
        }
        case Kind::ellipsoid: {
            const long long sx = 1LL << draw.pick(3), sy = 1LL << draw.pick(3), sz = 1LL << draw.pick(3);
            const Ints p = draw_on_sphere(draw);
            return {{5 * sx, 5 * sy, 5 * sz},
                    {p.x * sx, p.y * sy, p.z * sz},
                    {p.x * sy * sz, p.y * sx * sz, p.z * sx * sy}};
        }
        case Kind::capsule: {
            const long long sign = draw.coin() ? 1 : -1;
            if (draw.coin())
                return {{5, tall, 0}, {a, draw.integer(-static_cast<int>(tall), static_cast<int>(tall)), b}, {a, 0, b}};
            Ints p = draw_on_sphere(draw);
            p.y = std::llabs(p.y) * sign;
            return {{5, tall, 0}, {p.x, p.y + sign * tall, p.z}, p};
        }
        case Kind::box: {
            const Ints size{draw.integer(1, 9), draw.integer(1, 9), draw.integer(1, 9)};
            Ints p{draw.integer(-1, 1), draw.integer(-1, 1), draw.integer(-1, 1)};
            if (p.x == 0 && p.y == 0 && p.z == 0) p.y = 1;
            const Ints out{p.x * draw.integer(1, 3), p.y * draw.integer(1, 3), p.z * draw.integer(1, 3)};
            return {size, {p.x * size.x, p.y * size.y, p.z * size.z}, out};
        }
        case Kind::cylinder: {
            const long long sign = draw.coin() ? 1 : -1;
            switch (draw.pick(3)) {
                case 0: {  // mantle
                    const long long y = draw.integer(-static_cast<int>(tall), static_cast<int>(tall));
                    return {{5, tall, 0}, {a, y, b}, {a, 0, b}, std::llabs(y) == tall};
                }
                case 1:  // cap
                    return {{5, tall, 0}, {draw.integer(-3, 3), sign * tall, draw.integer(-3, 3)}, {0, sign, 0}};
                default: {  // rim
                    const int up = draw.integer(0, 9);
                    return {{5, tall, 0}, {a, sign * tall, b}, {a, sign * up, b}, up == 0};
                }
            }
        }
        case Kind::cone:
            break;
    }
    switch (draw.pick(4)) {
        case 0: {  // apex
            if (draw.coin()) return {{5, tall, 0}, {0, 0, 0}, {0, -1, 0}};
            return {{5, tall, 0}, {0, 0, 0}, {a, -(25 / tall + draw.integer(1, 5)), b}, true};
        }
        case 1:  // disc
            return {{5, tall, 0}, {draw.integer(-3, 3), tall, draw.integer(-3, 3)}, {0, 1, 0}};
        case 2:  // mantle, half way up
            return {{10, 2 * tall, 0}, {a, tall, b}, {tall * a, -25, tall * b}};
        default: {  // rim
            const long long up = 5LL * draw.integer(0, 9);
            return {{5, tall, 0}, {a, tall, b}, {tall * a, up - 25, tall * b}, true};
        }
    }
}

}  // namespace

ExactContact draw_contact(Draw& draw, Kind kind) {
    const Surface s = draw_surface(draw, kind);
    // Rotations by whole quaternions turn multiples of |q|^2 into whole vectors.
    constexpr int turns[][4] = {{1, 0, 0, 0}, {1, 1, 0, 0},  {1, 0, 1, 0}, {1, 1, 1, 1}, {2, 1, 0, 0}, {2, 0, 1, 0},
                                {2, 0, 0, 1}, {1, -2, 0, 0}, {0, 1, 2, 0}, {1, 2, 2, 0}, {3, 1, 0, 0}};
    const int* q = turns[draw.pick(11)];
    const long long w = q[0];
    const Ints u{q[1], q[2], q[3]};
    const long long norm = w * w + dot(u, u);
    const auto turn = [&](const Ints& v) {  // times norm
        return u * (2 * dot(u, v)) + v * (w * w - dot(u, u)) + cross(u, v) * (2 * w);
    };

    ExactContact contact;
    contact.sharp = s.sharp;
    contact.unit = std::ldexp(1.0, draw.integer(-8, 4));
    const double unit = contact.unit;
    const auto vec = [&](const Ints& v) {
        return Vec{static_cast<double>(v.x) * unit, static_cast<double>(v.y) * unit, static_cast<double>(v.z) * unit};
    };
    Query& query = contact.query;
    query.kind = kind;
    query.size = vec(s.size * norm);
    query.qw = q[0], query.qx = q[1], query.qy = q[2], query.qz = q[3];

    const Ints out = reduced(turn(s.out));
    const Ints axis = std::llabs(out.x) < std::llabs(out.y) ? Ints{1, 0, 0} : Ints{0, 1, 0};
    Ints first = cross(out, axis);
    if (first.x == 0 && first.y == 0 && first.z == 0) first = cross(out, {0, 0, 1});
    first = reduced(first);
    const Ints second = reduced(cross(out, first));
    contact.out = vec(out);
    contact.tangent[0] = vec(first);
    contact.tangent[1] = vec(second);

    const Vec at = vec(turn(s.point));
    const double grow = std::ldexp(1.0, draw.integer(-2, 6));
    const auto along = [&](int i, int j, int k) {
        return at + (contact.tangent[0] * i + contact.tangent[1] * j + contact.out * k) * grow;
    };
    contact.part = static_cast<Feature>(draw.pick(3));
    switch (contact.part) {
        case Feature::face: {  // any p, q that are not parallel, and a third corner opposite
            const int px = draw.integer(1, 4), py = draw.integer(-4, 4), qx = draw.integer(-4, 4);
            const int qy = draw.integer(1, 4) * (px * 5 > py * qx ? 1 : -1), m = draw.integer(1, 2);
            const bool parallel = px * qy == py * qx;
            query.a = along(px, py, 0);
            query.b = along(parallel ? -1 : qx, parallel ? 5 : qy, 0);
            query.c = along(-m * (px + (parallel ? -1 : qx)), -m * (py + (parallel ? 5 : qy)), 0);
            break;
        }
        case Feature::edge: {
            const int i = draw.integer(1, 4), j = draw.integer(-4, 4), k = draw.integer(-4, 4), l = draw.integer(-4, 4);
            query.a = along(i, j, 0);
            query.b = along(-i, -j, 0);
            query.c = along(k, l, draw.integer(0, 4));
            break;
        }
        case Feature::vertex: {
            query.a = at;
            for (Vec* corner : {&query.b, &query.c}) {
                const int k = draw.integer(-4, 4), l = draw.integer(-4, 4);
                *corner = along(k, l, draw.integer(0, 4));
            }
        }
    }
    // Far from the origin the same whole numbers, as long as they fit.
    const double away = unit * std::ldexp(1.0, draw.integer(0, 20));
    const int x = draw.integer(-4, 4), y = draw.integer(-4, 4), z = draw.integer(-4, 4);
    const Vec offset{x * away, y * away, z * away};
    contact.here = offset;
    contact.at = at + offset;
    for (Vec* v : {&query.a, &query.b, &query.c}) *v = *v + offset;
    return contact;
}

}  // namespace judge
