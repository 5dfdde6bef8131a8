#include "pair/simplex.hpp"

#include "exact/products.hpp"

namespace surefoot::internal {

namespace {

using Corner = Simplex::Corner;

Simplex of_one(const Corner& a) noexcept {
    Simplex s;
    s.count = 1;
    s.corner[0] = a;
    s.corner[0].weight = 1;
    return s;
}

Vec point_of(const Simplex& s) noexcept {
    Vec sum;
    for (int i = 0; i < s.count; ++i) sum = sum + s.corner[i].at * s.corner[i].weight;
    return sum;
}

double size_of(const Simplex& s) noexcept {
    const Vec p = point_of(s);
    return dot(p, p);
}

Simplex nearer(const Simplex& a, const Simplex& b) noexcept {
    return size_of(b) < size_of(a) ? b : a;
}

Simplex of_two(const Corner& a, const Corner& b) noexcept {
    const Vec e = b.at - a.at;
    const double along = -dot(a.at, e);
    const double squared = dot(e, e);
    if (!(along > 0)) return of_one(a);
    if (along >= squared) return of_one(b);
    Simplex s;
    s.count = 2;
    s.corner[0] = a;
    s.corner[1] = b;
    s.corner[1].weight = along / squared;
    s.corner[0].weight = 1 - s.corner[1].weight;
    return s;
}

// The foot on the plane if it is within, else the nearest of the sides: no case is decided twice, so none can disagree.
Simplex of_three(const Corner& a, const Corner& b, const Corner& c) noexcept {
    const Vec normal = accurate_cross(b.at - a.at, c.at - a.at);
    const double squared = dot(normal, normal);
    if (squared > 0) {
        const double wa = dot(accurate_cross(b.at, c.at), normal);
        const double wb = dot(accurate_cross(c.at, a.at), normal);
        const double wc = dot(accurate_cross(a.at, b.at), normal);
        const double sum = wa + wb + wc;
        if (wa > 0 && wb > 0 && wc > 0 && sum > 0) {
            Simplex s;
            s.count = 3;
            s.corner[0] = a;
            s.corner[1] = b;
            s.corner[2] = c;
            s.corner[0].weight = wa / sum;
            s.corner[1].weight = wb / sum;
            s.corner[2].weight = wc / sum;
            return s;
        }
    }
    return nearer(of_two(a, b), nearer(of_two(b, c), of_two(c, a)));
}

// The nearest point of a tetrahedron is on one of the faces that have the origin on their outer side.
Simplex of_four(const Corner (&c)[4]) noexcept {
    static constexpr int faces[4][4] = {{0, 1, 2, 3}, {0, 2, 3, 1}, {0, 3, 1, 2}, {1, 3, 2, 0}};
    Simplex best;
    double weight[4] = {};
    for (const auto& face : faces) {
        const Corner& a = c[face[0]];
        const Vec normal = accurate_cross(c[face[1]].at - a.at, c[face[2]].at - a.at);
        const double opposite = dot(normal, c[face[3]].at - a.at);
        const double origin = -dot(normal, a.at);
        if (origin * opposite > 0) {
            weight[face[3]] = origin / opposite;
            continue;
        }
        const Simplex side = of_three(a, c[face[1]], c[face[2]]);
        best = best.count == 0 ? side : nearer(best, side);
    }
    if (best.count == 0) {
        for (; best.count < 4; ++best.count) {
            best.corner[best.count] = c[best.count];
            best.corner[best.count].weight = weight[best.count];
        }
        best.holds_origin = true;
    }
    return best;
}

}  // namespace

bool Simplex::has(const Vec& at) const noexcept {
    for (int i = 0; i < count; ++i) {
        if (corner[i].at == at) return true;
    }
    return false;
}

Vec Simplex::reduce() noexcept {
    switch (count) {
        case 1:
            *this = of_one(corner[0]);
            break;
        case 2:
            *this = of_two(corner[0], corner[1]);
            break;
        case 3:
            *this = of_three(corner[0], corner[1], corner[2]);
            break;
        default:
            *this = of_four(corner);
            break;
    }
    return point_of(*this);
}

}  // namespace surefoot::internal
