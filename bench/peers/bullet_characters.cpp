// Bullet's own character controller, as its demos use it: a capsule in a ghost object, swept by the ghost.
#include <BulletCollision/CollisionDispatch/btGhostObject.h>
#include <BulletDynamics/Character/btKinematicCharacterController.h>
#include <algorithm>
#include <btBulletCollisionCommon.h>
#include <cmath>
#include <memory>

#include "characters.hpp"
#include "clock.hpp"

namespace surefoot::bench {
namespace {

constexpr double dt = 1.0 / 60;

btVector3 to_bullet(const dvec3& v) {
    return {static_cast<btScalar>(v.x), static_cast<btScalar>(v.y), static_cast<btScalar>(v.z)};
}

dvec3 place_of(const btGhostObject& ghost) {
    const btVector3& at = ghost.getWorldTransform().getOrigin();
    return {static_cast<double>(at.x()), static_cast<double>(at.y()), static_cast<double>(at.z())};
}

class BulletWorld {
public:
    explicit BulletWorld(const Scene& scene) : dispatcher_(&configuration_) {
        btIndexedMesh part;
        part.m_numTriangles = static_cast<int>(scene.triangle_count());
        part.m_triangleIndexBase = reinterpret_cast<const unsigned char*>(scene.indices.data());
        part.m_triangleIndexStride = 3 * sizeof(std::uint32_t);
        part.m_numVertices = static_cast<int>(scene.vertices.size());
        part.m_vertexBase = reinterpret_cast<const unsigned char*>(scene.vertices.data());
        part.m_vertexStride = sizeof(vec3);
        part.m_vertexType = PHY_FLOAT;
        arrays_.addIndexedMesh(part);
        mesh_ = std::make_unique<btBvhTriangleMeshShape>(&arrays_, true);
        ground_.setCollisionShape(mesh_.get());
        broadphase_.getOverlappingPairCache()->setInternalGhostPairCallback(&ghosts_);
        world_ = std::make_unique<btCollisionWorld>(&dispatcher_, &broadphase_, &configuration_);
        world_->addCollisionObject(&ground_, btBroadphaseProxy::StaticFilter, btBroadphaseProxy::AllFilter);
    }
    btCollisionWorld* get() { return world_.get(); }

private:
    btDefaultCollisionConfiguration configuration_;
    btCollisionDispatcher dispatcher_;
    btDbvtBroadphase broadphase_;
    btGhostPairCallback ghosts_;
    btTriangleIndexVertexArray arrays_;
    std::unique_ptr<btBvhTriangleMeshShape> mesh_;
    btCollisionObject ground_;
    std::unique_ptr<btCollisionWorld> world_;
};

struct BulletCharacter {
    BulletCharacter(btCollisionWorld* world, const dvec3& place, std::size_t seed) : wanderer(seed) {
        ghost.setWorldTransform(btTransform(btQuaternion::getIdentity(), to_bullet(place)));
        ghost.setCollisionShape(&capsule);
        ghost.setCollisionFlags(btCollisionObject::CF_CHARACTER_OBJECT);
        controller = std::make_unique<btKinematicCharacterController>(&ghost, &capsule, 0.4F, btVector3(0, 1, 0));
        controller->setGravity(btVector3(0, -20, 0));
        controller->setMaxSlope(btRadians(50.0F));
        world->addCollisionObject(&ghost, btBroadphaseProxy::CharacterFilter, btBroadphaseProxy::StaticFilter);
    }
    btCapsuleShape capsule{0.4F, 1.0F};
    btPairCachingGhostObject ghost;
    std::unique_ptr<btKinematicCharacterController> controller;
    Wanderer wanderer;
};

double quantile(std::vector<double>& values, double share) {
    std::sort(values.begin(), values.end());
    return values.empty() ? 0 : values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1) + 0.5)];
}

}  // namespace

std::vector<CharacterRow> run_bullet_characters(const Stage& stage, const CharacterOptions& options,
                                                const std::vector<dvec3>& places) {
    BulletWorld world(stage.scene);
    std::vector<std::unique_ptr<BulletCharacter>> all;
    for (std::size_t i = 0; i < places.size(); ++i)
        all.push_back(std::make_unique<BulletCharacter>(world.get(), places[i], i + 1));
    const Bounds bounds = stage.mesh.bounds();
    const double half_width = 0.5 * std::min(bounds.max.x - bounds.min.x, bounds.max.z - bounds.min.z) - 4;
    std::vector<double> ticks, singles;
    CharacterRow row{.name = "Bullet's"};
    std::size_t updates = 0;
    for (std::size_t tick = 0; tick < options.settling + options.bullet_ticks; ++tick) {
        const bool timed = tick >= options.settling;
        std::vector<dvec3> before;
        for (const auto& each : all) {
            before.push_back(place_of(each->ghost));
            const dvec3 wish = each->wanderer.wish(before.back(), half_width, false);
            each->controller->setWalkDirection(to_bullet(wish * dt));
        }
        const double begin = thread_seconds();
        for (const auto& each : all) {
            const double one = thread_seconds();
            each->controller->updateAction(world.get(), static_cast<btScalar>(dt));
            if (timed) singles.push_back(1e9 * (thread_seconds() - one));
        }
        if (!timed) continue;
        ticks.push_back(1e9 * (thread_seconds() - begin) / static_cast<double>(all.size()));
        for (std::size_t i = 0; i < all.size(); ++i) {
            const dvec3 way = place_of(all[i]->ghost) - before[i];
            row.walked += std::hypot(way.x, way.z) / dt;
            row.grounded += all[i]->controller->onGround() ? 1 : 0;
            ++updates;
        }
    }
    for (const auto& each : all) world.get()->removeCollisionObject(&each->ghost);
    row.median = quantile(ticks, 0.5);
    row.p50 = quantile(singles, 0.5);
    row.p99 = quantile(singles, 0.99);
    row.p999 = quantile(singles, 0.999);
    row.worst = quantile(singles, 1);
    row.walked /= static_cast<double>(std::max<std::size_t>(updates, 1));
    row.grounded /= static_cast<double>(std::max<std::size_t>(updates, 1));
    return {row};
}

}  // namespace surefoot::bench
