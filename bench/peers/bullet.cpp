#include <BulletCollision/CollisionDispatch/btCollisionObject.h>
#include <BulletCollision/CollisionDispatch/btCollisionWorld.h>
#include <BulletCollision/CollisionShapes/btBoxShape.h>
#include <BulletCollision/CollisionShapes/btBvhTriangleMeshShape.h>
#include <BulletCollision/CollisionShapes/btCapsuleShape.h>
#include <BulletCollision/CollisionShapes/btCylinderShape.h>
#include <BulletCollision/CollisionShapes/btSphereShape.h>
#include <BulletCollision/CollisionShapes/btTriangleIndexVertexArray.h>

#include "peers/peer.hpp"

namespace surefoot::bench {
namespace {

btVector3 to_bullet(const dvec3& v) {
    return {static_cast<btScalar>(v.x), static_cast<btScalar>(v.y), static_cast<btScalar>(v.z)};
}

// Bullet only reads through these pointers, but its interface is older than that thought.
btIndexedMesh arrays_of(const Scene& scene) {
    btIndexedMesh mesh;
    mesh.m_numTriangles = static_cast<int>(scene.triangle_count());
    mesh.m_triangleIndexBase = reinterpret_cast<const unsigned char*>(scene.indices.data());
    mesh.m_triangleIndexStride = 3 * sizeof(std::uint32_t);
    mesh.m_numVertices = static_cast<int>(scene.vertices.size());
    mesh.m_vertexBase = reinterpret_cast<const unsigned char*>(scene.vertices.data());
    mesh.m_vertexStride = sizeof(vec3);
    mesh.m_vertexType = PHY_FLOAT;
    return mesh;
}

class Bullet final : public Peer {
public:
    explicit Bullet(const Scene& scene) {
        arrays_.addIndexedMesh(arrays_of(scene));
        constexpr bool quantised = true;  // Bullet's own default advice, and its faster tree
        mesh_ = std::make_unique<btBvhTriangleMeshShape>(&arrays_, quantised);
        object_.setCollisionShape(mesh_.get());
    }

    [[nodiscard]] Tally rays(std::span<const Motion> motions) const override {
        Tally tally{.asked = motions.size()};
        for (const Motion& motion : motions) {
            const btVector3 from = to_bullet(motion.from);
            const btVector3 to = to_bullet(motion.to);
            btCollisionWorld::ClosestRayResultCallback closest(from, to);
            btCollisionWorld::rayTestSingle(btTransform(btQuaternion::getIdentity(), from),
                                            btTransform(btQuaternion::getIdentity(), to), &object_, mesh_.get(),
                                            object_.getWorldTransform(), closest);
            count(tally, closest.hasHit(), closest.m_closestHitFraction);
        }
        return tally;
    }

    [[nodiscard]] Tally sweeps(Body body, std::span<const Motion> motions) const override {
        Tally tally{.asked = motions.size()};
        const btConvexShape& shape = shape_of(body);
        for (const Motion& motion : motions) {
            const btVector3 from = to_bullet(motion.from);
            const btVector3 to = to_bullet(motion.to);
            btCollisionWorld::ClosestConvexResultCallback closest(from, to);
            btCollisionWorld::objectQuerySingle(&shape, btTransform(btQuaternion::getIdentity(), from),
                                                btTransform(btQuaternion::getIdentity(), to), &object_, mesh_.get(),
                                                object_.getWorldTransform(), closest, 0);
            count(tally, closest.hasHit(), closest.m_closestHitFraction);
        }
        return tally;
    }

private:
    static void count(Tally& tally, bool hit, btScalar t) {
        if (!hit) return;
        ++tally.hits;
        tally.t_sum += static_cast<double>(t);
    }

    [[nodiscard]] const btConvexShape& shape_of(Body body) const {
        switch (body) {
            case Body::capsule:
                return capsule_;
            case Body::box:
                return box_;
            case Body::cylinder:
                return cylinder_;
            default:
                return sphere_;
        }
    }

    btSphereShape sphere_{0.4F};
    btCapsuleShape capsule_{0.4F, 1.0F};
    btBoxShape box_{btVector3(0.4F, 0.9F, 0.4F)};
    btCylinderShape cylinder_{btVector3(0.4F, 0.9F, 0.4F)};
    btTriangleIndexVertexArray arrays_;
    std::unique_ptr<btBvhTriangleMeshShape> mesh_;
    mutable btCollisionObject object_;  // its questions take a pointer to one that is not const
};

}  // namespace

std::unique_ptr<Peer> make_bullet(const Scene& scene) {
    return std::make_unique<Bullet>(scene);
}

std::string_view bullet_missing() {
    return {};
}

}  // namespace surefoot::bench
