// Surefoot's character among Bullet's dynamic bodies, pushed both ways. Bullet moves the boxes; the world of the
// character holds each as a body that goes, in every tick, from where Bullet had it to where Bullet has it now. So the
// character is stopped, pushed and carried by them like by any lift. The other way, a body in Bullet stands for the
// character: boxes meet it, and the impulses between them push the boxes and come back into the character's velocity.
// Explained in docs/movement.md.
#include <algorithm>
#include <array>
#include <btBulletDynamicsCommon.h>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <vector>

#include <surefoot/surefoot.hpp>

namespace {

using surefoot::dvec3;

constexpr double dt = 1.0 / 60;
constexpr double mass = 80;  // of the character [kg]

btVector3 to_bullet(const dvec3& v) {
    return {static_cast<btScalar>(v.x), static_cast<btScalar>(v.y), static_cast<btScalar>(v.z)};
}
dvec3 to_surefoot(const btVector3& v) {
    return {static_cast<double>(v.x()), static_cast<double>(v.y()), static_cast<double>(v.z())};
}
surefoot::Pose pose_of(const btRigidBody& body) {
    const btQuaternion turn = body.getWorldTransform().getRotation();
    return {.position = to_surefoot(body.getWorldTransform().getOrigin()),
            .orientation = surefoot::dquat(static_cast<double>(turn.w()), static_cast<double>(turn.x()),
                                           static_cast<double>(turn.y()), static_cast<double>(turn.z()))};
}

surefoot::Mesh box_mesh(const dvec3& half) {
    std::array<surefoot::vec3, 8> corners;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const dvec3 side{(i & 1U) != 0 ? 1 : -1, (i & 2U) != 0 ? 1 : -1, (i & 4U) != 0 ? 1 : -1};
        corners[i] = surefoot::vec3(half * side);
    }
    const std::array<std::uint32_t, 36> triangles{0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5, 0, 1, 5, 0, 5, 4,
                                                  2, 6, 7, 2, 7, 3, 0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6};
    const auto mesh = surefoot::Mesh::build({.vertices = corners, .indices = triangles});
    if (!mesh) std::abort();  // sizes above zero are fine
    return *mesh;
}

/// A box of Bullet's, and the same in the character's world.
struct Crate {
    std::unique_ptr<btBoxShape> shape;
    std::unique_ptr<btRigidBody> body;
    surefoot::BodyHandle handle;
};

class Game {
public:
    Game() {
        bullet_.setGravity({0, -10, 0});
        floor_.setFriction(0.6F);
        bullet_.addRigidBody(&floor_, level_group, box_group);
        // What boxes of Bullet's meet: as heavy as the character, upright, held by nothing but what we say in each
        // tick.
        stand_in_.setAngularFactor(0);
        stand_in_.setActivationState(DISABLE_DEACTIVATION);
        bullet_.addRigidBody(&stand_in_, character_group, box_group);
        stand_in_.setGravity({0, 0, 0});
        if (!world_.add(box_mesh({100, 1, 100}), {.pose = {.position = {0, -1, 0}}, .body = floor_number}))
            std::abort();
    }
    Game(const Game&) = delete;
    Game& operator=(const Game&) = delete;
    ~Game() {
        for (Crate& crate : crates_) bullet_.removeRigidBody(crate.body.get());
        bullet_.removeRigidBody(&stand_in_);
        bullet_.removeRigidBody(&floor_);
    }

    btRigidBody& add_crate(const dvec3& middle, const dvec3& half, double kilograms, double friction) {
        Crate crate;
        crate.shape = std::make_unique<btBoxShape>(to_bullet(half));
        btVector3 inertia(0, 0, 0);
        crate.shape->calculateLocalInertia(static_cast<btScalar>(kilograms), inertia);
        crate.body =
            std::make_unique<btRigidBody>(static_cast<btScalar>(kilograms), nullptr, crate.shape.get(), inertia);
        crate.body->setWorldTransform(btTransform(btQuaternion::getIdentity(), to_bullet(middle)));
        crate.body->setFriction(static_cast<btScalar>(friction));
        crate.body->setActivationState(DISABLE_DEACTIVATION);
        bullet_.addRigidBody(crate.body.get(), box_group, level_group | box_group | character_group);
        const auto number = static_cast<std::uint32_t>(crates_.size());
        const auto added = world_.add(box_mesh(half), {.pose = pose_of(*crate.body), .body = number});
        if (!added) std::abort();
        crate.handle = *added;
        return *crates_.emplace_back(std::move(crate)).body;
    }

    // [tick]
    void tick(const dvec3& wish) {
        // Bullet moves its bodies. Among them is one that stands for the character, as heavy and as fast: what it and
        // the boxes do to each other is worked out where such things are worked out best.
        const dvec3 had = state.velocity + state.ground_velocity;
        stand_in_.setWorldTransform(btTransform(btQuaternion::getIdentity(), to_bullet(state.position)));
        stand_in_.setLinearVelocity(to_bullet(had));
        bullet_.stepSimulation(static_cast<btScalar>(dt), 4, static_cast<btScalar>(dt / 4));
        const dvec3 blow = to_surefoot(stand_in_.getLinearVelocity() - to_bullet(had));

        // The character's world takes over where they went in this tick.
        world_.begin_tick();
        for (const Crate& crate : crates_) {
            if (!world_.move(crate.handle, pose_of(*crate.body))) std::abort();
        }

        // What hit it goes into its velocity; then it moves.
        const surefoot::CharacterInput input{.wish = wish, .impulse = blow};
        const surefoot::StepResult result = step(world_, settings, input, dt, state);
        state = result.state;
        events = result.events;
        press_on_the_ground();
    }
    // [/tick]

    /// How deep it is in a box, at the end of the tick [m].
    [[nodiscard]] double depth() const {
        std::array<surefoot::Overlap, 64> found;
        const std::size_t count = world_.overlap(settings.volume, state.position, found, {.begin = 1, .end = 1});
        double deepest = 0;
        for (std::size_t i = 0; i < std::min(count, found.size()); ++i) deepest = std::max(deepest, found[i].depth);
        return deepest;
    }

    const surefoot::CharacterSettings settings{.volume = surefoot::Capsule{.radius = 0.4, .half_height = 0.5}};
    surefoot::CharacterState state{.position = {0, 0.91, 0}};
    surefoot::CharacterEvents events;

private:
    enum Group { level_group = 1, box_group = 2, character_group = 4 };
    static constexpr std::uint32_t floor_number = 1000;  // boxes have their places in the list as numbers

    [[nodiscard]] btRigidBody* crate_of(std::uint32_t number) const {
        return number < crates_.size() ? crates_[number].body.get() : nullptr;
    }

    /// What it stands on carries its weight, in the middle of its feet.
    void press_on_the_ground() {
        btRigidBody* const crate = state.footing == surefoot::Footing::ground ? crate_of(state.ground_body) : nullptr;
        if (crate == nullptr) return;
        const dvec3 feet = state.position - dvec3{0, 0.9, 0};
        crate->applyImpulse(to_bullet({0, -10 * mass * dt, 0}),
                            to_bullet(feet - to_surefoot(crate->getWorldTransform().getOrigin())));
    }

    btDefaultCollisionConfiguration configuration_;
    btCollisionDispatcher dispatcher_{&configuration_};
    btDbvtBroadphase broadphase_;
    btSequentialImpulseConstraintSolver solver_;
    btDiscreteDynamicsWorld bullet_{&dispatcher_, &broadphase_, &solver_, &configuration_};
    btStaticPlaneShape plane_{{0, 1, 0}, 0};
    btRigidBody floor_{0, nullptr, &plane_};
    btCapsuleShape capsule_{0.4F, 1.0F};
    btRigidBody stand_in_{static_cast<btScalar>(mass), nullptr, &capsule_};
    std::vector<Crate> crates_;
    surefoot::World world_;
};

double x_of(const btRigidBody& body) {
    return to_surefoot(body.getWorldTransform().getOrigin()).x;
}

/// Walks, or waits, for so many ticks. True if it never was in a box, but in ticks in which it was told that it is
/// crushed: between a box that falls and the floor there is no room that a step could find.
bool run(Game& game, int ticks, const dvec3& wish, int most_crushed = 0) {
    int crushed = 0;
    for (int i = 0; i < ticks; ++i) {
        game.tick(wish);
        const bool now = game.events.has(surefoot::CharacterEvent::crushed);
        crushed += now ? 1 : 0;
        if (now || game.depth() == 0) continue;
        std::printf("it is in a box, by %.3g m\n", game.depth());
        return false;
    }
    return crushed <= most_crushed;
}

bool pushes_a_box() {
    Game game;
    const btRigidBody& light = game.add_crate({2, 0.5, 0}, {0.5, 0.5, 0.5}, 150, 0.5);
    const bool outside = run(game, 180, {3, 0, 0});
    std::printf("pushed a box of 150 kg by %.2f m, at %.2f m/s\n", x_of(light) - 2,
                static_cast<double>(light.getLinearVelocity().x()));
    return outside && x_of(light) > 4 && game.state.position.x > 3;
}

bool does_not_push_a_heavy_one() {
    Game game;
    const btRigidBody& heavy = game.add_crate({2, 0.75, 0}, {0.75, 0.75, 0.75}, 3000, 0.5);
    const bool outside = run(game, 180, {3, 0, 0});
    std::printf("pushed a box of 3000 kg by %.3f m\n", x_of(heavy) - 2);
    return outside && std::abs(x_of(heavy) - 2) < 0.01;
}

bool is_pushed_by_a_box_that_comes() {
    Game game;
    btRigidBody& coming = game.add_crate({4, 0.6, 0}, {0.6, 0.6, 0.6}, 400, 0.05);
    coming.setLinearVelocity({-5, 0, 0});
    const bool outside = run(game, 120, {0, 0, 0});
    std::printf("a box that came at 5 m/s pushed it by %.2f m and went on at %.2f m/s\n", -game.state.position.x,
                -static_cast<double>(coming.getLinearVelocity().x()));
    return outside && game.state.position.x < -1;
}

bool is_carried_by_a_box_that_slides() {
    Game game;
    btRigidBody& raft = game.add_crate({0, 0.2, 0}, {1.5, 0.2, 1.5}, 400, 0.02);
    game.state.position = {0, 0.4 + 0.91, 0};
    bool outside = run(game, 30, {0, 0, 0});
    raft.setLinearVelocity({2, 0, 0});
    const double from = x_of(raft);
    outside = run(game, 90, {0, 0, 0}) && outside;
    const double went = x_of(raft) - from;
    std::printf("a box carried it: it went %.2f m, the box %.2f m\n", game.state.position.x, went);
    return outside && went > 1.5 && std::abs(game.state.position.x - went) < 0.02;
}

bool tips_a_plank() {
    Game game;
    game.add_crate({0, 0.5, 0}, {0.5, 0.5, 0.5}, 500, 0.8);
    const btRigidBody& plank = game.add_crate({0, 1.05, 0}, {3, 0.05, 0.5}, 40, 0.8);
    game.state.position = {0, 2.01, 0};
    bool outside = run(game, 30, {0, 0, 0});
    const double height = game.state.position.y;
    outside = run(game, 90, {1.5, 0, 0}) && outside;
    std::printf("it walked out on a plank, which tipped by %.0f degrees, and came down by %.2f m\n",
                static_cast<double>(plank.getOrientation().getAngle()) * 57.29578, height - game.state.position.y);
    return outside && height - game.state.position.y > 0.5;
}

bool gets_out_from_under_a_box_that_falls() {
    Game game;
    const btRigidBody& falling = game.add_crate({0.25, 5, 0}, {0.4, 0.4, 0.4}, 30, 0.5);
    const bool outside = run(game, 180, {0, 0, 0}, 3);
    const double beside = std::abs(x_of(falling) - game.state.position.x);
    std::printf("a box fell on its head and lies %.2f m beside it\n", beside);
    return outside && beside > 0.8;
}

}  // namespace

int main() {
    bool good = pushes_a_box();
    good = does_not_push_a_heavy_one() && good;
    good = is_pushed_by_a_box_that_comes() && good;
    good = is_carried_by_a_box_that_slides() && good;
    good = tips_a_plank() && good;
    good = gets_out_from_under_a_box_that_falls() && good;
    return good ? 0 : 1;
}
