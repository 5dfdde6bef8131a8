// Several triangles that share an edge or a corner, and going on from a contact.
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

/// `v` turned about the unit vector `axis` by the angle with this tangent of its half.
Vec turned_about(const Vec& axis, const Vec& v, double half_tangent) {
    Query turn;
    turn.qw = 1;
    turn.qx = axis.x * half_tangent;
    turn.qy = axis.y * half_tangent;
    turn.qz = axis.z * half_tangent;
    return turned(turn, v);
}

}  // namespace

void make_resweep(const Source& source, std::vector<Query>& queries) {
    Draw& draw = source.draw;
    Query query = everyday(draw, source.kind);
    const double away = draw.pick({0, 0, 1e3, 1e6});
    draw_triangle_near(draw, query, {away, 0, -away}, 2, 0.2, 6);
    aim(draw, query, draw.uniform(0.5, 10));
    queries.push_back(query);
    for (int step = 0; step < 4; ++step) {
        const Answer answer = source.sweep(query);
        if (!answer.hit || !(answer.t >= 0 && answer.t <= 1)) return;
        const Vec d = query.to - query.from;
        const Vec n = answer.normal;
        query.from = query.from + d * answer.t;  // rounded, as any caller's is: perhaps an ulp inside
        switch (draw.pick(5)) {
            case 0:  // straight on: the classic fall-through
                query.to = query.from + d;
                break;
            case 1:  // slide along the contact
                query.to = query.from + (d - n * dot(d, n));
                break;
            case 2:  // push into it
                query.to = query.from - n * draw.magnitude(1e-6, 10);
                break;
            case 3:  // back off
                query.to = query.from - d * draw.uniform(0.1, 1);
                break;
            default:
                query.to = query.from + draw.arrow(1e-3, 10);
        }
        queries.push_back(query);
    }
}

void make_shared(const Source& source, std::vector<Query>& queries) {
    Draw& draw = source.draw;
    Query query = everyday(draw, source.kind);
    const Vec hub = draw.box(3), axis = draw.direction();
    const int faces = draw.integer(2, 8);
    const bool by_edge = draw.coin();
    const double size = draw.uniform(0.3, 4);
    const Vec other = hub + axis * size;
    Vec rim[9];
    const Vec out = draw.direction() * size;
    for (int i = 0; i <= faces; ++i) {
        rim[i] = hub + turned_about(axis, out, draw.uniform(-3, 3));
        if (draw.coin()) rim[i] = rim[i] + axis * draw.uniform(-1, 1);
        if (i == faces) rim[i] = rim[0];
    }
    // One motion at the hub or the edge, for all faces.
    query.a = hub;
    query.b = by_edge ? other : hub;
    query.c = hub;
    to_floats(query);
    const Vec shared_a = query.a, shared_b = query.b;
    aim(draw, query, draw.uniform(0.5, 6));
    if (draw.coin()) {  // straight at a point of it
        const Vec way = query.to - query.from;
        query.from = shared_a + (shared_b - shared_a) * draw.uniform(0, 1) - way * 2;
        query.to = query.from + way * 4;
    }
    for (int i = 0; i < faces; ++i) {
        query.a = shared_a;
        query.b = by_edge ? shared_b : rim[i];
        query.c = by_edge ? rim[i] : rim[i + 1];
        to_floats(query);
        queries.push_back(query);
    }
}

void make_wedges(const Source& source, std::vector<Query>& queries) {
    Draw& draw = source.draw;
    Query query = everyday(draw, source.kind);
    // tan(angle / 4) for wedges of 5 to 90 degrees: the two faces stand half the wedge to either side of the middle.
    const double quarter = draw.uniform(0.0218, 0.4142);
    const Vec axis = draw.direction(), hub = draw.box(3);
    Vec middle = cross(axis, draw.direction());
    if (!(length(middle) > 0.01)) return;
    middle = middle * (draw.uniform(1, 6) / length(middle));
    Vec ends[2] = {turned_about(axis, middle, quarter), turned_about(axis, middle, -quarter)};
    Vec edge[2] = {axis * -draw.uniform(0.5, 6), axis * draw.uniform(0.5, 6)};
    if (draw.coin() && source.kind == Kind::ellipsoid) {  // a wedge of that angle in squashed space
        query.qw = 1, query.qx = query.qy = query.qz = 0;
        for (Vec* v : {&ends[0], &ends[1], &edge[0], &edge[1], &middle})
            *v = {v->x * query.size.x, v->y * query.size.y, v->z * query.size.z};
    }
    const bool inner = draw.coin();  // into the wedge, or against its outside
    const Vec into = middle * (inner ? -1.0 : 1.0) + draw.box(0.2);
    const double before = draw.uniform(0.5, 2), after = draw.uniform(0.5, 2);
    query.from = hub + edge[0] * 0.3 + edge[1] * 0.3 - into * before;
    query.to = query.from + into * (before + after);
    for (const Vec& end : ends) {
        query.a = hub + edge[0];
        query.b = hub + edge[1];
        query.c = hub + end;
        to_floats(query);
        queries.push_back(query);
    }
}

}  // namespace judge
