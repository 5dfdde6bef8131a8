// Exact contacts and what is an ulp away from them.
#include "exact_contact.hpp"
#include "families.hpp"

namespace judge {
namespace {

void shake(Draw& draw, Vec& v) {
    double& part = draw.any_part(v);
    part = Draw::ulps(part, draw.coin() ? 1 : -1);
}

/// A direction by how it stands to the contact: > 0 approaching, 0 sliding, < 0 leaving.
Vec direction_of(Draw& draw, const ExactContact& contact, int toward) {
    const int i = draw.integer(-3, 3), j = draw.integer(-3, 3);
    const Vec slide = contact.tangent[0] * i + contact.tangent[1] * j;
    if (toward == 0 && slide.x == 0 && slide.y == 0 && slide.z == 0) return contact.tangent[0];
    return slide + contact.out * (toward * draw.integer(1, 3));
}

}  // namespace

void make_tangent(const Source& source, std::vector<Query>& queries) {
    Draw& draw = source.draw;
    const ExactContact contact = draw_contact(draw, source.kind);
    Query query = contact.query;
    const double speed = std::ldexp(1.0, draw.integer(-6, 6));
    const Vec way = direction_of(draw, contact, 0) * speed;
    query.from = contact.here - way * draw.integer(1, 4);
    query.to = contact.here + way * draw.integer(0, 4);
    queries.push_back(query);
    Vec* const points[5] = {&query.from, &query.to, &query.a, &query.b, &query.c};
    Vec& moved = *points[draw.pick(5)];
    shake(draw, moved);
    queries.push_back(query);
}

void make_touching(const Source& source, std::vector<Query>& queries) {
    Draw& draw = source.draw;
    const ExactContact contact = draw_contact(draw, source.kind);
    const double speed = std::ldexp(1.0, draw.integer(-12, 6));
    for (const int toward : {1, 0, -1}) {
        Query query = contact.query;
        query.from = contact.here;
        query.to = query.from + direction_of(draw, contact, toward) * speed;
        queries.push_back(query);
        // An ulp in or out, and the motion as it comes or an ulp more or less.
        Query near = query;
        Vec& moved = draw.coin() ? near.from : near.a;
        shake(draw, moved);
        if (draw.coin()) shake(draw, near.to);
        queries.push_back(near);
        // Some ulps off along the normal, and gliding parallel: the hair's own country.
        const double side = draw.coin() ? 1 : -1, off = side * draw.magnitude(1e-16, 1e-9);
        query.from = query.from - contact.out * (off * length(contact.here) / length(contact.out) + off);
        query.to = query.to - contact.out * (off * length(contact.here) / length(contact.out) + off);
        queries.push_back(query);
    }
}

void make_inside(const Source& source, std::vector<Query>& queries) {
    Draw& draw = source.draw;
    if (draw.coin()) {
        const ExactContact contact = draw_contact(draw, source.kind);
        Query query = contact.query;
        query.from = contact.here + contact.out * draw.pick({0x1p-40, 0x1p-20, 0x1p-10, 0.125, 0.5, 1});
        if (draw.one_in(4)) query.from = draw.coin() ? query.a : (query.a + query.b) * 0.5;
        const double speed = std::ldexp(1.0, draw.integer(-6, 6));
        query.to = query.from + direction_of(draw, contact, draw.integer(-1, 1)) * speed;
        queries.push_back(query);
        return;
    }
    Query query;
    query.kind = source.kind;
    draw_size(draw, query, 0.1, 2);
    draw_orientation(draw, query);
    draw_triangle_near(draw, query, {}, 4, 0.2, 4);
    const double b = draw.uniform(0, 1), c = draw.uniform(0, 1 - b);
    const Vec target = query.a + (query.b - query.a) * b + (query.c - query.a) * c;
    query.from = target + turned(query, draw.box(1) * (0.7 * reach_of(query)));
    if (draw.one_in(6)) query.from = target;
    query.to = query.from + draw.arrow(1e-3, 10);
    queries.push_back(query);
}

void make_still(const Source& source, std::vector<Query>& queries) {
    Draw& draw = source.draw;
    const ExactContact contact = draw_contact(draw, source.kind);
    Query query = contact.query;
    query.from = contact.here;
    switch (draw.pick(4)) {
        case 0:
            break;
        case 1:
            query.from = query.from + contact.out * draw.pick({0.5, -0.5, 1e-3, -1e-3});
            break;
        case 2:
            query.from = query.from + draw.direction() * reach_of(query);
            break;
        default:
            shake(draw, query.from);
    }
    query.to = query.from;
    if (draw.coin()) shake(draw, query.to);
    queries.push_back(query);
}

void make_parallel(const Source& source, std::vector<Query>& queries) {
    Draw& draw = source.draw;
    if (draw.coin()) {
        // Gliding exactly in touch from beside the triangle or from within it, or just above it.
        const ExactContact contact = draw_contact(draw, source.kind);
        Query query = contact.query;
        const double speed = std::ldexp(1.0, draw.integer(-3, 8));
        const Vec way = direction_of(draw, contact, 0) * speed;
        const double before = draw.pick({0, 0.5, 1, 2});
        const double above = draw.pick({0, 0, 0x1p-44, -0x1p-44, 0x1p-50, -0x1p-50, -0x1p-10});
        query.from = contact.here - way * before + contact.out * above;
        query.to = query.from + way;
        queries.push_back(query);
        return;
    }
    Query query;
    query.kind = source.kind;
    draw_size(draw, query, 0.1, 2);
    draw_orientation(draw, query);
    draw_triangle_near(draw, query, {}, 4, 0.5, 6);
    aim(draw, query, 1);
    Vec along = query.b - query.a;
    if (draw.coin()) {
        const double u = draw.uniform(-1, 1), v = draw.uniform(-1, 1);
        along = along * u + (query.c - query.a) * v;
    }
    const double scale = draw.pick({0.5, 1, 2, 4});
    query.from = query.from - along * (scale * draw.uniform(0, 1));
    query.to = query.from + along * scale;
    if (draw.coin()) query.to = query.to + draw.box(draw.pick({1e-16, 1e-13, 1e-10, 1e-7}));  // nearly parallel
    queries.push_back(query);
}

void make_edge_on(const Source& source, std::vector<Query>& queries) {
    Draw& draw = source.draw;
    Query query;
    query.kind = source.kind;
    const double unit = std::ldexp(1.0, draw.integer(-4, 2));
    query.size = {draw.integer(1, 8) * unit, draw.integer(1, 8) * unit, draw.integer(1, 8) * unit};
    if (draw.coin()) draw_orientation(draw, query);
    const auto whole = [&](int low, int high) { return draw.integer(low, high) * unit; };
    // The ledge lies in the plane y = level; the motion is level, too.
    const double level = whole(-8, 8);
    query.a = {whole(0, 4), level, whole(-20, -1)};
    query.b = {whole(0, 4), level, whole(1, 20)};
    query.c = {whole(8, 30), level, whole(-20, 20)};
    const double height = level + draw.pick({0, 0, query.size.y, -query.size.y, 1e-12, -1e-12, 0.5 * query.size.y});
    query.from = {whole(-40, -6), height, whole(-16, 16)};
    query.to = {whole(6, 40), height, draw.coin() ? query.from.z : whole(-16, 16)};
    if (draw.one_in(3)) std::swap(query.from, query.to);
    if (draw.one_in(3)) {  // the same, standing up
        for (Vec* v : {&query.a, &query.b, &query.c, &query.from, &query.to}) std::swap(v->x, v->y);
    }
    queries.push_back(query);
}

void make_one_sided(const Source& source, std::vector<Query>& queries) {
    Draw& draw = source.draw;
    if (draw.coin()) {
        std::vector<Query> plain;
        draw.coin() ? make_random(source, plain) : make_slivers(source, plain);
        for (Query& query : plain) query.one_sided = true;
        queries.insert(queries.end(), plain.begin(), plain.end());
        return;
    }
    // Along the plane, exactly or an ulp off: d . N is 0 or tiny.
    Query query;
    query.kind = source.kind;
    draw_size(draw, query, 0.1, 2);
    draw_orientation(draw, query);
    query.one_sided = true;
    const Vec at = draw.box(4);
    query.a = at;
    query.b = at + draw.box(3);
    query.c = at + draw.box(3);
    to_floats(query);
    const double u = draw.pick({1, 0.5, -1, 2}), v = draw.pick({0, 1, -1, 0.5});
    const Vec along = (query.b - query.a) * u + (query.c - query.a) * v;
    const Vec normal = cross(query.b - query.a, query.c - query.a);
    query.from = query.a + (query.b - query.a) * 0.3 + (query.c - query.a) * 0.3 - along * draw.uniform(0.2, 1);
    if (length(normal) > 0) {
        query.from = query.from + normal * (draw.uniform(-0.9, 0.9) * reach_of(query) / length(normal));
    }
    to_floats(query.from);
    query.to = query.from + along;
    if (draw.coin()) shake(draw, query.to);
    queries.push_back(query);
}

}  // namespace judge
