#include "character/recover.hpp"

#include <optional>

#include <surefoot/overlap.hpp>
#include <surefoot/ray.hpp>

#include "world/ask.hpp"

namespace surefoot::internal {

namespace {

// What the body is pushed out of at once.
constexpr std::size_t most_pushes = 32;

// Each round parts the body from everything that it overlaps, one after the other, and asks anew.
constexpr int most_rounds = 8;
constexpr int most_turns_apart = 64;

// Where room is looked for at last: in rings around the body.
constexpr int rings = 12;

// The sines of the sixteenths of a turn.
constexpr double sixteenth[16] = {0,  0.3826834323650898,  0.7071067811865476,  0.9238795325112867,
                                  1,  0.9238795325112867,  0.7071067811865476,  0.3826834323650898,
                                  0,  -0.3826834323650898, -0.7071067811865476, -0.9238795325112867,
                                  -1, -0.9238795325112867, -0.7071067811865476, -0.3826834323650898};

struct Push {
    Vec normal;
    double depth;  // how far to go along `normal` [m]
};

class Recover {
public:
    Recover(Surroundings& surroundings, const Body& body, const Gait& gait) noexcept
        : surroundings_(surroundings),
          body_(body),
          gait_(gait),
          half_(grown(body.volume, 0.5 * gait.skin)),
          full_{body.kept_off, body.shift} {}

    // The whole way is found before any of it is gone, however little of it there is time for: half a way out of one
    // thing may lead into another.
    Recovery run(const Vec& from, double farthest) noexcept {
        Vec place = from;
        for (int round = 0; round < most_rounds; ++round) {
            if (!find_pushes(place)) return {.position = from, .overflow = true};
            if (count_ == 0) return round == 0 ? Recovery{from, false, false} : towards(from, place, farthest);
            const auto out = way_out();
            if (!out) return search(from, farthest);
            if (!(length(*out) > 0) || crosses(place, place + *out)) break;
            place = place + *out;
        }
        if (!find_pushes(place)) return {.position = from, .overflow = true};
        if (deep_) return search(from, farthest);
        return place == from ? Recovery{from, false, false} : towards(from, place, farthest);
    }

private:
    // As far as there is time to go, if the middle of the body crosses nothing on the straight way.
    Recovery towards(const Vec& from, const Vec& place, double farthest) noexcept {
        if (crosses(from, place)) return search(from, farthest);
        const Vec way = place - from;
        const double distance = length(way);
        return {distance > farthest ? from + way * (farthest / distance) : place, true, false};
    }

    // Pushed from several sides at once it gets nowhere. Somewhere near there may be room all the same.
    Recovery search(const Vec& from, double farthest) noexcept {
        const auto [one, other] = across(gait_.up);
        const double size = larger(body_.half_width, 0.5 * body_.size());
        for (int ring = 1; ring <= rings; ++ring) {
            const double distance = 1.5 * size * ring / rings;
            for (int i = 0; i < 16 + 2; ++i) {
                // Sideways first, in sixteen directions; then up and down.
                const Vec direction = i < 16    ? one * sixteenth[(i + 4) % 16] + other * sixteenth[i]
                                      : i == 16 ? gait_.up
                                                : -gait_.up;
                const auto place = room_near(from + direction * distance, size);
                if (!place || crosses(from, *place)) continue;
                const Vec way = *place - from;
                return {.position = from + way * smaller(1, farthest / length(way)), .moved = true};
            }
        }
        return {.position = from, .stuck = true};
    }

    // Where there is room, at a place or one push away from it.
    std::optional<Vec> room_near(const Vec& place, double size) noexcept {
        if (!find_pushes(place)) return std::nullopt;
        if (count_ == 0) return place;
        const auto out = way_out();
        if (!out || length(*out) > size || !find_pushes(place + *out) || count_ > 0) return std::nullopt;
        return place + *out;
    }

    // False if there is no room for the triangles.
    bool find_pushes(const Vec& position) noexcept {
        count_ = 0;
        deep_ = false;
        if (!surroundings_.cover(body_.around(position, {}, 2 * gait_.skin))) return false;
        bool too_near = false;
        for_all(half_, position, [&](const Overlap& overlap) {
            too_near = true;
            deep_ = deep_ || overlap.depth > 0.5 * gait_.skin;
        });
        if (!too_near) return true;
        // Now all within the skin: what is not too near may come as near as half of it, and no nearer.
        for_all(full_, position, [&](const Overlap& overlap) {
            if (count_ == most_pushes) return;
            const bool is_near = overlap.depth <= 0.5 * gait_.skin;
            pushes_[count_++] = {to_vec(overlap.normal), overlap.depth - (is_near ? 0.5 * gait_.skin : 0)};
        });
        return true;
    }

    template <typename Visit>
    void for_all(const GrownVolume& grown_by, const Vec& position, const Visit& visit) const noexcept {
        surroundings_.near_body(body_, grown_by, position, [&](const SourceTriangle& triangle) {
            if (surroundings_.rule_of(triangle.surface).one_way) return;
            const auto found =
                surefoot::overlap(grown_by.volume, to_dvec3(position + grown_by.shift), triangle.triangle);
            if (found && found->status == HitStatus::ok) visit(*found);
        });
    }

    // The shortest way that gets out of all, found by going out of each in turn; none where they are opposed.
    std::optional<Vec> way_out() const noexcept {
        Vec way;
        for (int turn = 0; turn < most_turns_apart; ++turn) {
            bool moved = false;
            for (std::size_t i = 0; i < count_; ++i) {
                const double missing = pushes_[i].depth - dot(pushes_[i].normal, way);
                if (missing <= 1e-9 * gait_.skin) continue;
                way = way + pushes_[i].normal * missing;
                moved = true;
            }
            if (!moved) return way;
        }
        return std::nullopt;
    }

    // Does the middle of the body cross anything? What lies between is not known unless it was gathered.
    bool crosses(const Vec& from, const Vec& to) noexcept {
        const Motion way{to_dvec3(from + body_.middle), to_dvec3(to + body_.middle)};
        const Box3 box = swept_box({}, way);
        if (!surroundings_.cover(box)) return true;
        bool crossed = false;
        surroundings_.near(box, [&](const SourceTriangle& triangle) {
            if (crossed || surroundings_.rule_of(triangle.surface).one_way) return;
            crossed = surefoot::ray(way, triangle.triangle).has_value();
        });
        return crossed;
    }

    Surroundings& surroundings_;
    const Body& body_;
    const Gait& gait_;
    GrownVolume half_;  // the body with half of its skin
    GrownVolume full_;  // and with all of it
    Push pushes_[most_pushes];
    std::size_t count_ = 0;
    bool deep_ = false;
};

}  // namespace

Recovery recover(Surroundings& surroundings, const Body& body, const Gait& gait, const Vec& from,
                 double farthest) noexcept {
    return Recover(surroundings, body, gait).run(from, farthest);
}

}  // namespace surefoot::internal
