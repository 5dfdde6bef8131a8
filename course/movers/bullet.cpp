// Bullet's btKinematicCharacterController, as its own demo sets it up: a ghost object with a capsule, the world's
// collisions found once a tick, then the controller's action. Volume, slope limit, step height, gravity, jump and
// terminal speed are the scene's; how deep a sweep may end is what that demo sets; all else is Bullet's default.
#include <BulletCollision/CollisionDispatch/btGhostObject.h>
#include <BulletDynamics/Character/btKinematicCharacterController.h>
#include <btBulletCollisionCommon.h>
#include <cmath>
#include <cstdint>

#include "course/movers/movers.hpp"

namespace surefoot::course {
namespace {

btScalar scalar(double value) {
    return static_cast<btScalar>(value);
}

btVector3 to_bullet(const dvec3& v) {
    return {scalar(v.x), scalar(v.y), scalar(v.z)};
}

btTransform to_bullet(const Pose& pose) {
    const dquat& q = pose.orientation;
    return btTransform(btQuaternion(scalar(q.x), scalar(q.y), scalar(q.z), scalar(q.w)), to_bullet(pose.position));
}

// A body that stands or is moved by its pose.
class Body {
public:
    Body(const Triangles& triangles, const Pose& pose) {
        btIndexedMesh mesh;
        mesh.m_numTriangles = static_cast<int>(triangles.indices.size() / 3);
        mesh.m_triangleIndexBase = reinterpret_cast<const unsigned char*>(triangles.indices.data());
        mesh.m_triangleIndexStride = 3 * sizeof(std::uint32_t);
        mesh.m_numVertices = static_cast<int>(triangles.vertices.size());
        mesh.m_vertexBase = reinterpret_cast<const unsigned char*>(triangles.vertices.data());
        mesh.m_vertexStride = sizeof(vec3);
        mesh.m_vertexType = PHY_FLOAT;
        arrays_.addIndexedMesh(mesh);
        constexpr bool quantised = true;  // Bullet's default
        shape_ = std::make_unique<btBvhTriangleMeshShape>(&arrays_, quantised);
        object_.setCollisionShape(shape_.get());
        object_.setWorldTransform(to_bullet(pose));
    }

    [[nodiscard]] btCollisionObject& object() { return object_; }

private:
    btTriangleIndexVertexArray arrays_;
    std::unique_ptr<btBvhTriangleMeshShape> shape_;
    btCollisionObject object_;
};

// Everything of one run; members are destroyed from the last to the first, as Bullet needs it.
class Walk {
public:
    explicit Walk(const Run& run) : run_(run), capsule_(shape_of(run.settings)) {
        pairs_.getOverlappingPairCache()->setInternalGhostPairCallback(&ghost_pairs_);
        world_.getDispatchInfo().m_allowedCcdPenetration =
            scalar(0.0001);  // Bullet's own is 0.04 m: it sinks in so far
        for (const LevelBody& body : run.level->bodies) {
            bodies_.push_back(std::make_unique<Body>(body.triangles, body.pose));
            world_.addCollisionObject(&bodies_.back()->object(), btBroadphaseProxy::StaticFilter,
                                      btBroadphaseProxy::CharacterFilter);
        }
        ghost_.setCollisionShape(&capsule_);
        ghost_.setCollisionFlags(btCollisionObject::CF_CHARACTER_OBJECT);
        world_.addCollisionObject(&ghost_, btBroadphaseProxy::CharacterFilter, btBroadphaseProxy::StaticFilter);
        const CharacterSettings& settings = run.settings;
        controller_ = std::make_unique<btKinematicCharacterController>(&ghost_, &capsule_, scalar(settings.step_up),
                                                                       btVector3(0, 1, 0));
        controller_->setGravity({0, scalar(-settings.gravity), 0});
        controller_->setFallSpeed(scalar(settings.terminal_speed));
        controller_->setJumpSpeed(scalar(std::sqrt(2 * settings.gravity * settings.jump_height)));
        controller_->setMaxSlope(scalar(radians(settings.slope_limit_deg)));
        // Last, because the controller turns the object when it learns which way is up.
        ghost_.setWorldTransform(btTransform(btQuaternion::getIdentity(), to_bullet(run.start)));
        world_.updateSingleAabb(&ghost_);
    }

    ~Walk() {
        world_.removeCollisionObject(&ghost_);
        for (const auto& body : bodies_) world_.removeCollisionObject(&body->object());
    }

    Walk(const Walk&) = delete;
    Walk& operator=(const Walk&) = delete;

    Answer tick(const Input& input, double dt, std::span<const Pose> poses) {
        for (std::size_t i = 0; i < bodies_.size(); ++i) {
            if (!run_.level->bodies[i].path) continue;
            bodies_[i]->object().setWorldTransform(to_bullet(poses[i]));
            world_.updateSingleAabb(&bodies_[i]->object());
        }
        if (input.jump && !jump_held_ && controller_->canJump()) controller_->jump();
        jump_held_ = input.jump;
        controller_->setWalkDirection(to_bullet(input.wish * dt));
        world_.performDiscreteCollisionDetection();
        controller_->updateAction(&world_, scalar(dt));
        const btVector3& at = ghost_.getWorldTransform().getOrigin();
        return {{static_cast<double>(at.x()), static_cast<double>(at.y()), static_cast<double>(at.z())},
                controller_->onGround()};
    }

private:
    static btCapsuleShape shape_of(const CharacterSettings& settings) {
        const Capsule capsule = capsule_of(settings);
        return {scalar(capsule.radius), scalar(2 * capsule.half_height)};
    }

    const Run& run_;
    btCapsuleShape capsule_;
    btGhostPairCallback ghost_pairs_;
    btDefaultCollisionConfiguration configuration_;
    btCollisionDispatcher dispatcher_{&configuration_};
    btDbvtBroadphase pairs_;
    btCollisionWorld world_{&dispatcher_, &pairs_, &configuration_};
    std::vector<std::unique_ptr<Body>> bodies_;
    btPairCachingGhostObject ghost_;
    std::unique_ptr<btKinematicCharacterController> controller_;
    bool jump_held_ = false;
};

class Bullet final : public Mover {
public:
    void load(const Run& run) override { walk_ = std::make_unique<Walk>(run); }
    Answer tick(const Input& input, double dt, std::span<const Pose> poses) override {
        return walk_->tick(input, dt, poses);
    }

private:
    std::unique_ptr<Walk> walk_;
};

}  // namespace

std::unique_ptr<Mover> make_bullet() {
    return std::make_unique<Bullet>();
}

std::string_view bullet_missing() {
    return {};
}

}  // namespace surefoot::course
