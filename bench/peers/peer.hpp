/// Other people's libraries, asked the same questions in the same run. Each is optional: where its package was missing
/// when this was built, there is no peer, and a sentence says how to get it.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string_view>

#include <surefoot/math.hpp>

#include "motions.hpp"

namespace surefoot::bench {

/// What came of a run of questions: enough to see that there was something to find.
struct Tally {
    std::uint64_t asked = 0;
    std::uint64_t hits = 0;   ///< questions that met something
    std::uint64_t found = 0;  ///< triangles handed back, for questions that ask for all of them
    double t_sum = 0;         ///< over the hits

    void add(const Tally& other) {
        asked += other.asked;
        hits += other.hits;
        found += other.found;
        t_sum += other.t_sum;
    }
};

/// Immutable once made; asked from one thread.
class Peer {
public:
    Peer() = default;
    Peer(const Peer&) = delete;
    Peer& operator=(const Peer&) = delete;
    virtual ~Peer() = default;

    [[nodiscard]] virtual Tally rays(std::span<const Motion> motions) const = 0;
    [[nodiscard]] virtual Tally sweeps(Body body, std::span<const Motion> motions) const = 0;
};

/// Embree 3's closest ray, single rays, a static scene of its default quality: E, the unit in which the rest is told.
/// Null where Embree is missing.
[[nodiscard]] std::unique_ptr<Peer> make_embree(const Scene& scene);

/// Bullet's convex sweep against a btBvhTriangleMeshShape, without the broad phase of a world. Null where Bullet is
/// missing.
[[nodiscard]] std::unique_ptr<Peer> make_bullet(const Scene& scene);

/// What is missing and how to get it, a line each; empty if nothing is.
[[nodiscard]] std::string_view embree_missing();
[[nodiscard]] std::string_view bullet_missing();

}  // namespace surefoot::bench
