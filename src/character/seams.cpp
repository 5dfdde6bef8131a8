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

// Of the surfaces that hold a point of touch the one that looks most along `up`.
class Uppermost {
public:
    Uppermost(const Touch& touch, const Vec& up) noexcept : touch_(touch), up_(up), best_(touch.normal) {}

    void offer(const Face& held) noexcept {
        // Turned away from the touch: not what it stands on.
        if (dot(held.normal, touch_.normal) < -1e-9) return;
        const double height = dot(held.normal, up_);
        if (!(height > height_)) return;
        height_ = height;
        best_ = held.normal;
    }
    [[nodiscard]] const Vec& normal() const noexcept { return best_; }

private:
    const Touch& touch_;
    const Vec& up_;
    Vec best_;
    double height_ = -1;
};

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
    if (touch.feature != Feature::face) {
        const Face own = face_of(surroundings.triangle(touch.index).triangle, centre);
        Uppermost uppermost(touch, up);
        bool covered = false;
        near(surroundings, touch.point, reach, [&](const SourceTriangle& triangle) {
            const Face face = face_of(triangle.triangle, centre);
            if (face.normal == Vec{}) return;
            const auto held = held_at(face, touch.point, reach);
            if (held) uppermost.offer(face);
            if (held && is_nearly(face.normal, touch.normal)) {
                faces.add(face.normal);
                return;
            }
            if (!held || reaches_out(face, *held, touch.normal) <= in_plane * face.size) return;
            // It reaches out, but against its back the body cannot have come.
            if (dot(face.normal, touch.normal) < -1e-9) return;
            covered = true;
            // What lies behind the face is behind it for all of the motion. What rises before it is met by itself.
            if (reaches_out(own, face.corners[0], face.normal) <= in_plane * own.size + 0.5 * reach &&
                is_before(body, centre, face, reach)) {
                faces.add(face.normal);
            }
        });
        if (covered && !(own.normal == Vec{}) && dot(own.normal, touch.normal) >= -1e-9 &&
            is_before(body, centre, own, reach)) {
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
        uppermost.offer(face);
    });
    return uppermost.normal();
}

}  // namespace surefoot::internal
