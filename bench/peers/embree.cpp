#include <cstring>
#include <embree3/rtcore.h>
#include <stdexcept>

#include "peers/peer.hpp"

namespace surefoot::bench {
namespace {

class Embree final : public Peer {
public:
    explicit Embree(const Scene& scene) : device_(rtcNewDevice(nullptr)), scene_(rtcNewScene(device_)) {
        const RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
        // Embree's own buffers: it pads them as it likes to read them.
        void* const vertices = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                                       sizeof(vec3), scene.vertices.size());
        void* const indices = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                                      3 * sizeof(std::uint32_t), scene.triangle_count());
        if (vertices == nullptr || indices == nullptr) throw std::runtime_error("Embree has no memory for the scene");
        std::memcpy(vertices, scene.vertices.data(), scene.vertices.size() * sizeof(vec3));
        std::memcpy(indices, scene.indices.data(), scene.triangle_count() * 3 * sizeof(std::uint32_t));
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene_, geometry);
        rtcReleaseGeometry(geometry);
        rtcCommitScene(scene_);
    }
    ~Embree() override {
        rtcReleaseScene(scene_);
        rtcReleaseDevice(device_);
    }

    [[nodiscard]] Tally rays(std::span<const Motion> motions) const override {
        Tally tally{.asked = motions.size()};
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        for (const Motion& motion : motions) {
            const vec3 from(motion.from);
            const vec3 along(motion.to - motion.from);
            RTCRayHit query{};
            query.ray.org_x = from.x;
            query.ray.org_y = from.y;
            query.ray.org_z = from.z;
            query.ray.dir_x = along.x;
            query.ray.dir_y = along.y;
            query.ray.dir_z = along.z;
            query.ray.tfar = 1;
            query.ray.mask = ~0U;
            query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
            query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
            rtcIntersect1(scene_, &context, &query);
            if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) continue;
            ++tally.hits;
            tally.t_sum += static_cast<double>(query.ray.tfar);
        }
        return tally;
    }

    [[nodiscard]] Tally sweeps(Body /*body*/, std::span<const Motion> /*motions*/) const override { return {}; }

private:
    RTCDevice device_;
    RTCScene scene_;
};

}  // namespace

std::unique_ptr<Peer> make_embree(const Scene& scene) {
    return std::make_unique<Embree>(scene);
}

std::string_view embree_missing() {
    return {};
}

}  // namespace surefoot::bench
