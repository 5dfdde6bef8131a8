#include "character/carry.hpp"

#include <array>

#include "character/seams.hpp"

namespace surefoot::internal {

namespace {

// Each pass goes on to the next thing that is met.
constexpr int most_carries = 12;
constexpr std::size_t most_pushers = 12;

// Rounds of satisfying the pushers one after the other; opposite ones never settle, and that is being crushed.
constexpr int most_parting_rounds = 24;

// How far ahead of what pushes it a body is taken, as a share of the skin: enough not to be met again by rounding.
constexpr double kept_ahead = 1e-3;

class Carry {
public:
    Carry(Surroundings& surroundings, const Body& body, const Gait& gait, BodyHandle support,
          const TickPart& part) noexcept
        : surroundings_(surroundings),
          world_(surroundings.world()),
          body_(body),
          gait_(gait),
          support_(support),
          time_(part.begin),
          end_(part.end) {
        if (world_.contains(support)) {
            support_id_ = world_.poses(support).body;
            rides_ = moves(world_, support);
        }
    }

    Carried run(const Vec& from) noexcept {
        result_.position = from;
        if (!rides_ && !anything_comes()) return result_;
        for (int pass = 0; pass < most_carries && time_ < end_; ++pass) {
            const Vec way = way_to_go();
            const auto hit = first(way);
            if (!hit) {
                result_.position = result_.position + way;
                break;
            }
            if (hit->status != HitStatus::ok) {
                result_.crushed = true;
                break;
            }
            const double left = end_ - time_;
            result_.position = result_.position + way * hit->t;
            time_ += left * hit->t;
            if (!meet(*hit)) break;
        }
        result_.moved = !(result_.position == from);
        return result_;
    }

private:
    struct Pusher {
        Vec normal;
        Vec point;
        BodyHandle body;
    };

    // Anything that moves and meets the body where it stands.
    bool anything_comes() const noexcept {
        const auto is_moving = [&](std::uint32_t id) { return moves(world_, world_.find(id)); };
        const dvec3 place = to_dvec3(result_.position + body_.shift);
        return world_.sweep_any(body_.kept_off, {place, place}, query(BodyFilter(is_moving)));
    }

    WorldQuery query(const BodyFilter& filter) const noexcept {
        WorldQuery query;
        query.bodies = filter;
        query.begin = time_;
        query.end = end_;
        query.turn_gap = 0.25 * gait_.skin;
        return query;
    }

    std::optional<Hit> first(const Vec& way) const noexcept {
        const auto is_other = [&](std::uint32_t id) { return !rides_ || id != support_id_; };
        const Vec from = result_.position + body_.shift;
        return world_.sweep(body_.kept_off, {to_dvec3(from), to_dvec3(from + way)}, query(BodyFilter(is_other)));
    }

    // How the support takes the body along for the rest of the tick, changed by what pushes.
    Vec way_to_go() noexcept {
        Vec way;
        if (rides_) way = to_vec(world_.carried(support_, to_dvec3(result_.position), time_, end_)) - result_.position;
        for (int round = 0; round < most_parting_rounds; ++round) {
            bool moved = false;
            for (std::size_t i = 0; i < count_; ++i) {
                const double missing = missing_of(pushers_[i], way);
                if (missing <= 0.5 * kept_ahead * gait_.skin) continue;
                way = way + pushers_[i].normal * missing;
                moved = true;
            }
            if (!moved) return way;
        }
        for (std::size_t i = 0; i < count_; ++i) {
            if (missing_of(pushers_[i], way) > 0.5 * gait_.skin) result_.crushed = true;
        }
        return way;
    }

    // How much farther along the pusher's normal the way would have to go to keep clear of it [m].
    double missing_of(const Pusher& pusher, const Vec& way) const noexcept {
        const Vec goes = world_.contains(pusher.body)
                             ? to_vec(world_.carried(pusher.body, to_dvec3(pusher.point), time_, end_)) - pusher.point
                             : Vec{};
        return dot(pusher.normal, goes - way) + kept_ahead * gait_.skin;
    }

    // False when there is no room for one more.
    bool meet(const Hit& hit) noexcept {
        const BodyHandle handle = world_.find(hit.body);
        if (moves(world_, handle)) {
            result_.pushed = true;
            return add({to_vec(hit.normal), to_vec(hit.point), handle});
        }
        // What stands still is pushed against; a seam in it, as between two bodies of one floor, is none of its faces.
        const Faces faces = faces_at(hit);
        for (const Vec& normal : faces.get()) {
            // Clear of the seam from here on, or it would be met again at once.
            if (faces.replaced) result_.position = result_.position + normal * (kept_ahead * gait_.skin);
            if (!add({normal, to_vec(hit.point), handle})) return false;
        }
        return true;
    }

    bool add(const Pusher& pusher) noexcept {
        if (count_ == most_pushers) {
            result_.crushed = true;
            return false;
        }
        pushers_[count_++] = pusher;
        return true;
    }

    Faces faces_at(const Hit& hit) const noexcept {
        Faces faces;
        if (surroundings_.cover(body_.around(result_.position, {}, 2 * gait_.skin))) {
            if (const auto index = surroundings_.find({hit.body, hit.triangle})) {
                const Touch touch{hit.t, to_vec(hit.point), to_vec(hit.normal), *index, hit.feature, hit.status};
                return faces_of(touch, surroundings_, body_, gait_.skin, result_.position, gait_.up);
            }
        }
        faces.add(to_vec(hit.normal));
        return faces;
    }

    Surroundings& surroundings_;
    const World& world_;
    const Body& body_;
    const Gait& gait_;
    BodyHandle support_;
    double time_;
    double end_;
    std::uint32_t support_id_ = 0;
    bool rides_ = false;
    Carried result_{};
    std::array<Pusher, most_pushers> pushers_{};
    std::size_t count_ = 0;
};

bool same(const Pose& a, const Pose& b) noexcept {
    return to_vec(a.position) == to_vec(b.position) && a.orientation.w == b.orientation.w &&
           a.orientation.x == b.orientation.x && a.orientation.y == b.orientation.y &&
           a.orientation.z == b.orientation.z;
}

}  // namespace

bool moves(const World& world, BodyHandle handle) noexcept {
    if (!world.contains(handle)) return false;
    const BodyPose poses = world.poses(handle);
    return !same(poses.start, poses.end);
}

Carried carry(Surroundings& surroundings, const Body& body, const Gait& gait, const Vec& from, BodyHandle support,
              const TickPart& part) noexcept {
    return Carry(surroundings, body, gait, support, part).run(from);
}

}  // namespace surefoot::internal
