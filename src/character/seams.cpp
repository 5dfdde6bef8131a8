#include "character/seams.hpp"

#include <optional>

#include "character/body.hpp"
#include "nearest.hpp"

namespace surefoot::internal {

namespace {

// How far a face may reach out in front of a plane and still lie in it, as a share of its own size: rounding of the
// touch's normal.
constexpr double in_plane = 1e-7;

// How far from the point of touch a surface may be and still hold it, as a share of the skin.
constexpr double holds_within = 0.5;

// How far behind a face a body with edges may be and still be led by it, as a share of the skin: what is met together
// and some more. What rises higher is a kerb, and such a body does not roll over it: it has to step up.
constexpr double sharp_sinks = 0.3;
static_assert(met_together < sharp_sinks && sharp_sinks < holds_within);

struct Face {
    Vec normal;  // unit, towards the body; zero for a triangle without area
    Vec corners[3];
    double size = 0;
};

Face face_of(const Triangle& triangle, const Vec& centre) noexcept {
    Face face{{}, {to_vec(triangle.a), to_vec(triangle.b), to_vec(triangle.c)}, 0};
    const Vec ab = face.corners[1] - face.corners[0];
    const Vec ac = face.corners[2] - face.corners[0];
    face.size = larger(norm1(ab), norm1(ac));
    const Vec across = cross(ab, ac);
    const double area = length(across);
    if (area <= 1e-12 * face.size * face.size) return face;
    face.normal = across / area;
    if (dot(face.normal, centre - face.corners[0]) < 0) face.normal = -face.normal;
    return face;
}

// The point of the face that is nearest to a point of touch, if the face holds that.
std::optional<Vec> held_at(const Face& face, const Vec& point, double reach) noexcept {
    const Vec nearest = nearest_on_triangle(point, face.corners);
    const Vec away = nearest - point;
    return dot(away, away) <= reach * reach ? std::optional(nearest) : std::nullopt;
}

// A body that skims over an edge within the sweep's hair, h, meets it with a normal that is off by the root of h over
// the body's size. What is as near as this to the normal of a face is that.
constexpr double nearly = 1e-4;

bool is_nearly(const Vec& a, const Vec& b) noexcept {
    const Vec difference = a - b;
    return dot(difference, difference) < nearly * nearly;
}

double reaches_out(const Face& face, const Vec& point, const Vec& normal) noexcept {
    return larger(dot(normal, face.corners[0] - point),
                  larger(dot(normal, face.corners[1] - point), dot(normal, face.corners[2] - point)));
}

// Is all of the body in front of the face's plane, but for `reach`? Only then does obeying the plane keep it off.
bool is_before(const Body& body, const Vec& centre, const Face& face, double reach) noexcept {
    const double height = dot(face.normal, centre + body.shift - face.corners[0]);
    return height - reach_along(body.kept_off, -face.normal) >= -reach;
}

template <typename Visit>
void near(const Surroundings& surroundings, const Vec& point, double reach, const Visit& visit) noexcept {
    const Vec around = Vec{1, 1, 1} * reach;
    surroundings.near({point - around, point + around}, visit);
}

// A face of the surroundings at a point of touch, and a body that is there.
struct Meeting {
    const Touch& touch;
    const Surroundings& surroundings;
    const Body& body;
    const Vec& centre;
    double reach;
    double sinks;  // how far the body may be behind a face that it obeys [m]

    // Turned towards the middle of the body: the apex of a cone may be below a face that it stands on.
    [[nodiscard]] Face face(const Triangle& triangle) const noexcept { return face_of(triangle, centre + body.middle); }

    // Can the body have come from the front of the face? The normals at one point of it are at no more than a right
    // angle, but for those of an apex.
    [[nodiscard]] bool is_faced(const Face& face) const noexcept {
        return dot(face.normal, touch.normal) >= -1e-9 || (body.is_sharp && is_before(body, centre, face, sinks));
    }

    // A body with edges touches at one point planes of many directions. One that lies behind a face that goes on in
    // front of it is not to be come at: whoever keeps off that face keeps off both.
    [[nodiscard]] bool is_hidden(const Face& face) const noexcept {
        if (!body.is_sharp) return false;
        bool hidden = false;
        near(surroundings, touch.point, reach, [&](const SourceTriangle& triangle) {
            if (hidden) return;
            const Face other = this->face(triangle.triangle);
            if (other.normal == Vec{} || is_nearly(other.normal, face.normal)) return;
            hidden = reaches_out(other, face.corners[0], face.normal) > in_plane * other.size &&
                     reaches_out(face, other.corners[0], other.normal) <= in_plane * face.size &&
                     held_at(other, touch.point, reach) && is_before(body, centre, other, sinks);
        });
        return hidden;
    }
};

// Of the surfaces that hold a point of touch the one that looks most along `up`.
class Uppermost {
public:
    Uppermost(const Touch& touch, const Vec& up) noexcept : up_(up), best_(touch.normal) {}

    // Requires: the face is not turned away from the touch; that would not be what it stands on.
    void offer(const Face& held) noexcept {
        const double height = dot(held.normal, up_);
        if (!(height > height_)) return;
        height_ = height;
        best_ = held.normal;
    }
    [[nodiscard]] const Vec& normal() const noexcept { return best_; }

private:
    const Vec& up_;
    Vec best_;
    double height_ = -1;
};

// Is a point of the face this near to its border?
bool is_on_border(const Face& face, const Vec& point, double near) noexcept {
    for (int i = 0; i < 3; ++i) {
        const Vec along = face.corners[(i + 1) % 3] - face.corners[i];
        const Vec off = cross(along, point - face.corners[i]);
        if (dot(off, off) <= near * near * dot(along, along)) return true;
    }
    return false;
}

// A flat side that meets a face flat does so at its border where the one ends and the other begins: that may be a seam
// too, as between the blocks of a wall. What is met together with that wall is met a little behind it.
void add_behind(const Meeting& at, Faces& faces) noexcept {
    if (!at.body.is_sharp) return;
    const Face own = at.face(at.surroundings.triangle(at.touch.index).triangle);
    if (own.normal == Vec{} || !is_on_border(own, at.touch.point, at.reach) || !at.is_hidden(own)) return;
    near(at.surroundings, at.touch.point, at.reach, [&](const SourceTriangle& triangle) {
        const Face face = at.face(triangle.triangle);
        if (face.normal == Vec{} || !held_at(face, at.touch.point, at.reach) ||
            reaches_out(face, own.corners[0], own.normal) <= in_plane * face.size) {
            return;
        }
        if (is_before(at.body, at.centre, face, at.sinks) && !at.is_hidden(face)) faces.add(face.normal);
    });
    faces.replaced = faces.count > 0;
}

}  // namespace

void Faces::add(const Vec& normal) noexcept {
    for (const Vec& old : get()) {
        if (dot(old, normal) > 1 - 1e-12) return;
    }
    if (count < most) normals[count++] = normal;
}

Faces faces_of(const Touch& touch, const Surroundings& surroundings, const Body& body, double skin, const Vec& centre,
               const Vec& up) noexcept {
    Faces faces;
    faces.surface = touch.normal;
    const double reach = holds_within * skin;
    const double sinks = body.is_sharp ? sharp_sinks * skin : reach;
    const Meeting at{touch, surroundings, body, centre, reach, sinks};
    if (touch.feature == Feature::face) {
        add_behind(at, faces);
    } else {
        const Face own = at.face(surroundings.triangle(touch.index).triangle);
        Uppermost uppermost(touch, up);
        bool covered = false;
        near(surroundings, touch.point, reach, [&](const SourceTriangle& triangle) {
            const Face face = at.face(triangle.triangle);
            if (face.normal == Vec{}) return;
            const auto held = held_at(face, touch.point, reach);
            if (!held) return;
            const bool is_faced = at.is_faced(face);
            if (is_faced) uppermost.offer(face);
            if (is_nearly(face.normal, touch.normal)) {
                if (!at.is_hidden(face)) faces.add(face.normal);
                return;
            }
            // If it reaches out it covers the touch; but against its back the body cannot have come.
            if (!is_faced || reaches_out(face, *held, touch.normal) <= in_plane * face.size) return;
            covered = true;
            // What lies behind the face is behind it for all of the motion. What rises before it is met by itself.
            if (reaches_out(own, face.corners[0], face.normal) <= in_plane * own.size + 0.5 * reach &&
                is_before(body, centre, face, sinks) && !at.is_hidden(face)) {
                faces.add(face.normal);
            }
        });
        if (covered && !(own.normal == Vec{}) && at.is_faced(own) && is_before(body, centre, own, sinks) &&
            !at.is_hidden(own)) {
            faces.add(own.normal);
        }
        faces.surface = uppermost.normal();
        faces.replaced = faces.count > 0;
    }
    if (!faces.replaced) faces.add(touch.normal);
    return faces;
}

Vec surface_under(const Touch& touch, const Surroundings& surroundings, double skin, const Vec& centre,
                  const Vec& up) noexcept {
    if (touch.feature == Feature::face) return touch.normal;
    const double reach = holds_within * skin;
    Uppermost uppermost(touch, up);
    near(surroundings, touch.point, reach, [&](const SourceTriangle& triangle) {
        const Face face = face_of(triangle.triangle, centre);
        if (face.normal == Vec{} || !held_at(face, touch.point, reach)) return;
        if (dot(face.normal, touch.normal) >= -1e-9) uppermost.offer(face);
    });
    return uppermost.normal();
}

}  // namespace surefoot::internal
