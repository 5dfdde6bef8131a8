// Rollback netcode: two peers play one game over a link that loses, delays and reorders what they send. Each moves on
// at once with its own input and a guess of the other's; when the other's input arrives and the guess was wrong, it
// goes back to the tick before and plays all ticks since then again. Nothing but inputs is ever sent. That both come to
// the same game, bit for bit, is what `step` promises: it is checked for each tick. Explained in docs/movement.md.
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <span>
#include <vector>

#include <surefoot/surefoot.hpp>

namespace {

constexpr double dt = 1.0 / 60;
constexpr std::size_t game_length = 1800;  // ticks: half a minute
constexpr std::size_t window = 24;         // how many ticks a peer may be ahead of what it knows of the other

/// Chance that is the same in each run.
class Dice {
public:
    explicit Dice(std::uint64_t seed) : state_(seed) {}
    std::uint32_t below(std::uint32_t count) {
        state_ = state_ * 6364136223846793005U + 1442695040888963407U;
        return static_cast<std::uint32_t>(state_ >> 33U) % count;
    }

private:
    std::uint64_t state_;
};

/// What a player holds down: all that goes over the link.
struct Buttons {
    std::int8_t x = 0;
    std::int8_t z = 0;
    bool jump = false;

    friend bool operator==(const Buttons&, const Buttons&) = default;
};

surefoot::Mesh block(float half, float low, float high) {
    const std::array<surefoot::vec3, 8> corners{{{-half, high, -half},
                                                 {half, high, -half},
                                                 {half, high, half},
                                                 {-half, high, half},
                                                 {-half, low, -half},
                                                 {half, low, -half},
                                                 {half, low, half},
                                                 {-half, low, half}}};
    const std::array<std::uint32_t, 36> triangles{0, 2, 1, 0, 3, 2, 4, 5, 6, 4, 6, 7, 0, 1, 5, 0, 5, 4,
                                                  1, 2, 6, 1, 6, 5, 2, 3, 7, 2, 7, 6, 3, 0, 4, 3, 4, 7};
    const auto mesh = surefoot::Mesh::build({.vertices = corners, .indices = triangles});
    if (!mesh) std::abort();  // the corners above are fine
    return *mesh;
}

/// Two players on a floor with a lift in its middle. What they do to each other and where the lift takes them depends
/// on every tick before.
// [game]
using Players = std::array<surefoot::CharacterState, 2>;

struct Snapshot {  // all that a tick changes
    Players players;
    surefoot::BodyPose lift;
};

class Game {
public:
    Game() {
        if (!world_.add(block(30, -1, 0), {.body = 0})) std::abort();
        lift_ = *world_.add(block(2, -0.3F, 0.1F), {.body = 1});
        players_[0].position = {-4, 1, 0};
        players_[1].position = {4, 1, 0};
    }

    void play(std::size_t tick, const std::array<Buttons, 2>& buttons) {
        world_.begin_tick();
        surefoot::Pose next = world_.poses(lift_).end;
        next.position.y += (tick / 120 % 2 == 0 ? 0.5 : -0.5) * dt;
        if (!world_.move(lift_, next)) std::abort();

        const Players before = players_;  // both read where the other was
        for (std::size_t i = 0; i < 2; ++i) {
            const surefoot::CharacterInput input{.wish = {4.0 * buttons[i].x, 0, 4.0 * buttons[i].z},
                                                 .jump = buttons[i].jump};
            const surefoot::Neighbour other = neighbour_of(settings_, {}, before[1 - i]);
            players_[i] = step(world_, settings_, input, dt, before[i], {&other, 1}).state;
        }
    }

    Snapshot save() const { return {players_, world_.poses(lift_)}; }
    void restore(const Snapshot& then) {
        players_ = then.players;
        if (!world_.restore_poses({&then.lift, 1})) std::abort();
    }

private:
    surefoot::World world_;
    surefoot::BodyHandle lift_;
    surefoot::CharacterSettings settings_;
    Players players_;
};
// [/game]

std::uint64_t hash_of(const Snapshot& snapshot) {
    const std::array<std::uint64_t, 2> players{hash(snapshot.players[0]), hash(snapshot.players[1])};
    return surefoot::hash_bytes(std::as_bytes(std::span(players)),
                                surefoot::hash_bytes(std::as_bytes(std::span(&snapshot.lift, 1))));
}

/// All inputs that the other has not confirmed yet, so that the next packet repairs the loss of one.
struct Packet {
    std::size_t arrives = 0;         // in this tick of the link's clock
    std::size_t first = 0;           // the tick of the first of these
    std::vector<Buttons> buttons{};  // one a tick
    std::size_t next_wanted = 0;     // all of the receiver's before this tick are known to the sender
};

/// One direction of the network.
class Link {
public:
    explicit Link(std::uint64_t seed) : dice_(seed) {}
    void send(std::size_t now, Packet packet) {
        if (dice_.below(100) < 25) return;  // one in four is lost
        packet.arrives = now + 2 + dice_.below(8);
        under_way_.push_back(std::move(packet));
    }
    std::optional<Packet> receive(std::size_t now) {
        const auto there = std::find_if(under_way_.begin(), under_way_.end(),
                                        [&](const Packet& packet) { return packet.arrives <= now; });
        if (there == under_way_.end()) return std::nullopt;
        const Packet packet = *there;
        under_way_.erase(there);
        return packet;
    }

private:
    Dice dice_;
    std::vector<Packet> under_way_;
};

class Peer {
public:
    Peer(std::size_t me, std::uint64_t seed) : me_(me), dice_(seed) {}

    void hear(const Packet& packet) {
        known_ = std::max(known_, packet.next_wanted);
        for (std::size_t i = 0; i < packet.buttons.size(); ++i) {
            if (packet.first + i == theirs_.size()) theirs_.push_back(packet.buttons[i]);
        }
    }

    // [rollback]
    /// Once a frame, after all that arrived was heard.
    void frame() {
        // Where did we guess wrong?
        const std::size_t heard = std::min(theirs_.size(), now_);
        std::size_t wrong = confirmed_;
        while (wrong < heard && guessed_[wrong] == theirs_[wrong]) ++wrong;
        if (wrong < heard) {
            ++rollbacks;
            deepest = std::max(deepest, now_ - wrong);
            game_.restore(snapshot(wrong));
            for (std::size_t tick = wrong; tick < now_; ++tick) play(tick);
        }
        // What is made of true inputs alone will never change again.
        for (; confirmed_ < heard; ++confirmed_) hashes.push_back(hash_of(snapshot(confirmed_ + 1)));

        if (now_ - confirmed_ == window) {
            ++waited;  // too far ahead: wait for the other
        } else if (now_ < game_length) {
            mine_.push_back(decide());
            guessed_.emplace_back();
            play(now_++);
        }
    }
    // [/rollback]

    Packet packet() const {
        return {.first = known_,
                .buttons = {mine_.begin() + static_cast<std::ptrdiff_t>(known_), mine_.end()},
                .next_wanted = theirs_.size()};
    }
    bool is_done() const { return confirmed_ == game_length; }
    const std::vector<Buttons>& inputs() const { return mine_; }

    std::vector<std::uint64_t> hashes;  // after each confirmed tick
    std::size_t rollbacks = 0;
    std::size_t deepest = 0;
    std::size_t waited = 0;

private:
    Snapshot& snapshot(std::size_t before_tick) { return snapshots_[before_tick % snapshots_.size()]; }

    void play(std::size_t tick) {
        snapshot(tick) = game_.save();
        // The guess: the other goes on holding what it was last known to hold.
        const Buttons last = theirs_.empty() ? Buttons{} : theirs_.back();
        guessed_[tick] = tick < theirs_.size() ? theirs_[tick] : last;
        std::array<Buttons, 2> buttons;
        buttons[me_] = mine_[tick];
        buttons[1 - me_] = guessed_[tick];
        game_.play(tick, buttons);
        snapshot(tick + 1) = game_.save();
    }

    /// A person who runs after the other or somewhere else, changes mind now and then, and jumps.
    Buttons decide() {
        const Players players = game_.save().players;
        const surefoot::dvec3 way = players[1 - me_].position - players[me_].position;
        if (dice_.below(10) == 0) {
            const bool after = dice_.below(3) > 0;
            held_.x = after ? sign(way.x) : static_cast<std::int8_t>(static_cast<int>(dice_.below(3)) - 1);
            held_.z = after ? sign(way.z) : static_cast<std::int8_t>(static_cast<int>(dice_.below(3)) - 1);
        }
        held_.jump = dice_.below(40) == 0;
        return held_;
    }
    static std::int8_t sign(double value) { return value > 0.3 ? 1 : value < -0.3 ? -1 : 0; }

    std::size_t me_;
    Dice dice_;
    Game game_;
    Buttons held_{};
    std::vector<Buttons> mine_;
    std::vector<Buttons> theirs_;   // as far as they arrived
    std::vector<Buttons> guessed_;  // what was taken for theirs
    std::array<Snapshot, window + 1> snapshots_{};
    std::size_t now_ = 0;
    std::size_t confirmed_ = 0;  // both inputs of all ticks before this one are known
    std::size_t known_ = 0;      // the other knows ours of all ticks before this one
};

/// The first tick of which the hashes differ.
std::optional<std::size_t> first_difference(const std::vector<std::uint64_t>& a, const std::vector<std::uint64_t>& b) {
    const auto [left, right] = std::mismatch(a.begin(), a.end(), b.begin(), b.end());
    if (left == a.end() && right == b.end()) return std::nullopt;
    return static_cast<std::size_t>(left - a.begin());
}

}  // namespace

int main() {
    std::array<Peer, 2> peers{Peer(0, 11), Peer(1, 22)};
    std::array<Link, 2> to{Link(33), Link(44)};
    for (std::size_t clock = 0; !(peers[0].is_done() && peers[1].is_done()); ++clock) {
        if (clock > 10 * game_length) return std::puts("they never come to an end"), 1;
        for (std::size_t i = 0; i < 2; ++i) {
            while (const auto packet = to[i].receive(clock)) peers[i].hear(*packet);
            peers[i].frame();
            to[1 - i].send(clock, peers[i].packet());
        }
    }

    // The same game by somebody who knew all inputs from the beginning.
    Game game;
    std::vector<std::uint64_t> hashes;
    std::size_t together = 0;
    std::size_t riding = 0;
    for (std::size_t tick = 0; tick < game_length; ++tick) {
        game.play(tick, {peers[0].inputs()[tick], peers[1].inputs()[tick]});
        const Snapshot now = game.save();
        hashes.push_back(hash_of(now));
        const surefoot::dvec3 between = now.players[1].position - now.players[0].position;
        if (between.x * between.x + between.z * between.z < 0.83 * 0.83) ++together;
        if (now.players[0].footing == surefoot::Footing::ground && now.players[0].ground_body == 1) ++riding;
    }
    std::printf("in %zu ticks the players touch, in %zu the first rides the lift\n", together, riding);

    for (const Peer& peer : peers) {
        std::printf("peer %td: %zu ticks, %zu rollbacks, the deepest by %zu ticks, %zu frames of waiting\n",
                    &peer - peers.data(), peer.hashes.size(), peer.rollbacks, peer.deepest, peer.waited);
        if (const auto tick = first_difference(peer.hashes, hashes)) {
            return std::printf("tick %zu is another game\n", *tick), 1;
        }
    }
    std::puts("both played the same game, to the last bit of each tick");
    const bool was_hard = peers[0].rollbacks > 100 && peers[0].deepest > 5 && together > 30 && riding > 30;
    return was_hard ? 0 : 1;
}
