#include "draw.hpp"

#include <algorithm>

namespace judge {

Vec turned(const Query& query, const Vec& v) {
    const Vec q{query.qx, query.qy, query.qz};
    const double s = query.qw * query.qw + dot(q, q);
    const Vec r = q * (2 * dot(q, v)) + v * (query.qw * query.qw - dot(q, q)) + cross(q, v) * (2 * query.qw);
    return {r.x / s, r.y / s, r.z / s};
}

void draw_size(Draw& draw, Query& query, double low, double high) {
    query.size = {draw.magnitude(low, high), draw.magnitude(low, high), draw.magnitude(low, high)};
}

void draw_orientation(Draw& draw, Query& query) {
    double* const q[4] = {&query.qw, &query.qx, &query.qy, &query.qz};
    for (double* part : q) *part = 0;
    switch (draw.pick(4)) {
        case 0:
            query.qw = 1;
            return;
        case 1:  // a quarter turn, or half of one about a diagonal
            query.qw = draw.coin() ? 0.7 : 1;
            {
                double& part = *q[1 + draw.pick(3)];
                part = draw.coin() ? query.qw : -query.qw;
            }
            return;
        case 2:
            do
                for (double* part : q) *part = draw.integer(-4, 4);
            while (*q[0] == 0 && *q[1] == 0 && *q[2] == 0 && *q[3] == 0);
            return;
        default: {
            double size = 0;
            do {
                size = 0;
                for (double* part : q) {
                    *part = draw.uniform(-1, 1);
                    size += *part * *part;
                }
            } while (size < 0.01);
            for (double* part : q) *part /= std::sqrt(size);
        }
    }
}

void to_floats(Vec& v) {
    // Through memory: g++ 12 at -O2 takes two such round trips that stand side by side for no change at all.
    volatile float rounded = 0;
    for (double* part : {&v.x, &v.y, &v.z}) {
        rounded = static_cast<float>(*part);
        *part = static_cast<double>(rounded);
    }
}

void to_floats(Query& query) {
    for (Vec* v : {&query.a, &query.b, &query.c}) to_floats(*v);
}

void draw_triangle(Draw& draw, Query& query, const Vec& centre, double size) {
    query.a = centre + draw.box(size);
    query.b = centre + draw.box(size);
    query.c = centre + draw.box(size);
    if (draw.one_in(4)) {  // level or upright, as most of a level is
        const int axis = draw.pick(3);
        for (Vec* v : {&query.a, &query.b, &query.c})
            (axis == 0 ? v->x : (axis == 1 ? v->y : v->z)) =
                axis == 0 ? query.a.x : (axis == 1 ? query.a.y : query.a.z);
    }
    if (!draw.one_in(4)) to_floats(query);
}

void draw_triangle_near(Draw& draw, Query& query, const Vec& origin, double spread, double low, double high) {
    const Vec centre = origin + draw.box(spread);
    const double size = draw.uniform(low, high);
    draw_triangle(draw, query, centre, size);
}

double reach_of(const Query& query) {
    const double dims[3] = {query.size.x, query.size.y, query.size.z};
    double reach = 0;
    for (int i = 0; i < size_count(query.kind); ++i) reach = std::max(reach, dims[i]);
    return reach;
}

void aim(Draw& draw, Query& query, double length) {
    double b = draw.uniform(0, 1), c = draw.uniform(0, 1);
    if (b + c > 1) b = 1 - b, c = 1 - c;
    const int part = draw.pick(3);  // face, edge, corner
    if (part == 1) c = draw.coin() ? 0 : 1 - b;
    if (part == 2) b = 0, c = draw.coin() ? 0 : 1;
    const Vec target = query.a + (query.b - query.a) * b + (query.c - query.a) * c;
    const Vec beside =
        turned(query, {draw.uniform(-1.3, 1.3) * query.size.x,
                       draw.uniform(-1.3, 1.3) * (size_count(query.kind) > 1 ? query.size.y : query.size.x),
                       draw.uniform(-1.3, 1.3) * (size_count(query.kind) > 2 ? query.size.z : query.size.x)});
    const Vec way = draw.direction() * length;
    const double before = draw.uniform(0.1, 1.2);
    query.from = target + beside - way * before;
    query.to = query.from + way;
}

}  // namespace judge
