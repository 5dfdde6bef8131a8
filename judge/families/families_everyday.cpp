// Everyday queries at every scale, and data that must be refused.
#include <algorithm>
#include <limits>

#include "families.hpp"

namespace judge {
namespace {

Query everyday(Draw& draw, Kind kind) {
    Query query;
    query.kind = kind;
    draw_size(draw, query, 0.1, 2);
    draw_orientation(draw, query);
    return query;
}

}  // namespace

void make_random(const Source& source, std::vector<Query>& queries) {
    Draw& draw = source.draw;
    Query query = everyday(draw, source.kind);
    draw_triangle_near(draw, query, {}, 8, 0.2, 6);
    if (draw.one_in(5)) {
        query.from = draw.box(8);
        query.to = draw.box(8);
    } else {
        aim(draw, query, draw.uniform(0.05, 10));
    }
    queries.push_back(query);
}

void make_sizes(const Source& source, std::vector<Query>& queries) {
    Draw& draw = source.draw;
    Query query = everyday(draw, source.kind);
    const double size = draw.magnitude(1e-4, 1e5);
    draw_triangle(draw, query, draw.box(2), size);
    aim(draw, query, draw.magnitude(0.1, 10));
    queries.push_back(query);
}

void make_far(const Source& source, std::vector<Query>& queries) {
    Draw& draw = source.draw;
    Query query = everyday(draw, source.kind);
    const double away = draw.pick({1e3, 1e6, 1e7});
    const Vec offset{draw.pick({-away, 0, away}), draw.pick({-away, 0, away}), draw.pick({-away, away})};
    draw_triangle_near(draw, query, offset, 8, 0.2, 6);
    aim(draw, query, draw.uniform(0.05, 10));
    queries.push_back(query);
}

void make_ratios(const Source& source, std::vector<Query>& queries) {
    Draw& draw = source.draw;
    Query query = everyday(draw, source.kind);
    const double small = draw.magnitude(0.01, 1), ratio = draw.uniform(1, 100);
    query.size = {small, small, small};
    draw.any_part(query.size) *= ratio;
    if (draw.coin()) {
        double& part = draw.any_part(query.size);
        part = small * draw.uniform(1, ratio);
    }
    const double extent = draw.magnitude(0.05, 50);
    draw_triangle(draw, query, draw.box(4), extent);
    aim(draw, query, draw.magnitude(0.05, 50));
    queries.push_back(query);
}

void make_motions(const Source& source, std::vector<Query>& queries) {
    Draw& draw = source.draw;
    Query query = everyday(draw, source.kind);
    draw_triangle_near(draw, query, {}, 4, 0.2, 6);
    const double length = draw.magnitude(1e-6, 1e5);
    aim(draw, query, length);
    queries.push_back(query);
    if (length > 1e-3) return;
    // A tiny motion hits only from next to the triangle: stop a longer one at its contact and go on from just before.
    Query longer = query;
    longer.to = longer.from + (longer.to - longer.from) * (8 / length);
    const Answer answer = source.sweep(longer);
    if (!answer.hit || !(answer.t > 0)) return;
    const Vec way = (longer.to - longer.from) * answer.t;
    const double before = std::max(0.0, 1 - draw.uniform(0, 2) * length / (judge::length(way) + length));
    query.to = query.from + way * before + (query.to - query.from);
    query.from = query.from + way * before;
    queries.push_back(query);
}

void make_limits(const Source& source, std::vector<Query>& queries) {
    Draw& draw = source.draw;
    Query query = everyday(draw, source.kind);
    const double base = draw.magnitude(1e-6, 1e6 / 1.001e4), ratio = draw.magnitude(1, 9999);
    query.size = {base, base, base};
    draw.any_part(query.size) *= ratio;
    if (draw.coin()) draw.any_part(query.size) = base * ratio;
    const double size = draw.magnitude(base * 0.01, std::min(base * ratio * 1e4, 1e8));
    const double away = draw.pick({0, 1, 1e4, 9e8});
    draw_triangle(draw, query, draw.box(away), std::min(size, 4e7));
    aim(draw, query, draw.magnitude(base * 0.01, std::min(base * ratio * 1e4, 4e7)));
    for (Vec* v : {&query.a, &query.b, &query.c, &query.from, &query.to})
        for (double* part : {&v->x, &v->y, &v->z}) *part = std::clamp(*part, -1e9, 1e9);
    queries.push_back(query);
}

void make_slivers(const Source& source, std::vector<Query>& queries) {
    Draw& draw = source.draw;
    Query query = everyday(draw, source.kind);
    const Vec at = draw.box(4), along = draw.arrow(0.01, 20);
    const double thin = draw.pick({0, 1e-12, 1e-9, 1e-6, 1e-3});
    switch (draw.pick(6)) {
        case 0:  // a point
            query.a = query.b = query.c = at;
            break;
        case 1:  // two corners are one
            query.a = query.c = at;
            query.b = at + along;
            break;
        case 2:  // three in a row, exactly
            query.a = at;
            query.b = at + along;
            to_floats(query);
            query.c = query.a + (query.b - query.a) * draw.pick({0.5, 0.25, 2, -1});
            break;
        case 3:  // a needle: two corners nearly one
            query.a = at;
            query.b = at + along;
            query.c = at + draw.box(thin);
            break;
        default:  // a sliver: three nearly in a row
            query.a = at;
            query.b = at + along;
            query.c = at + along * draw.uniform(0, 1);
            query.c = query.c + draw.box(thin);
    }
    aim(draw, query, draw.uniform(0.05, 10));
    if (draw.one_in(4)) {  // along the needle
        const Vec way = (query.b - query.a) * draw.pick({-0.5, 0.5, 1});
        query.to = query.from + way;
    }
    queries.push_back(query);
}

void make_invalid(const Source& source, std::vector<Query>& queries) {
    Draw& draw = source.draw;
    Query query = everyday(draw, source.kind);
    draw_triangle(draw, query, draw.box(4), 2);
    aim(draw, query, 2);
    const double huge = std::numeric_limits<double>::max();
    const double bad = draw.pick({std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
                                  -std::numeric_limits<double>::infinity(), huge, -huge, 1.0000001e9});
    const double size = draw.pick({0, -0.0, -1, 9.99e-7, 1.0001e6, std::numeric_limits<double>::denorm_min(), bad});
    double* const dims[3] = {&query.size.x, &query.size.y, &query.size.z};
    Vec* const points[5] = {&query.from, &query.to, &query.a, &query.b, &query.c};
    switch (draw.pick(4)) {
        case 0:
            *dims[draw.pick(size_count(query.kind))] = size;
            break;
        case 1: {
            Vec& moved = *points[draw.pick(5)];
            draw.any_part(moved) = bad;
            break;
        }
        case 2:
            if (draw.coin()) {
                query.qw = query.qx = query.qy = query.qz = 0;
            } else {
                double* const q[4] = {&query.qw, &query.qx, &query.qy, &query.qz};
                double& part = *q[draw.pick(4)];
                part = draw.coin() ? std::numeric_limits<double>::quiet_NaN() : std::numeric_limits<double>::infinity();
            }
            break;
        default:
            if (size_count(query.kind) < 2) {
                query.size.x = size;
            } else {
                query.size = {0.5, 0.5, 0.5};
                *dims[draw.pick(2)] *= 10001;
            }
    }
    queries.push_back(query);
}

}  // namespace judge
