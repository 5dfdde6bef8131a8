/// A workload: who is asked what, along which motions. To add one is to add a line to `all_workloads`.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <surefoot/mesh.hpp>

#include "motions.hpp"
#include "peers/peer.hpp"
#include "scenes/scene.hpp"

namespace surefoot::bench {

enum class Solver { surefoot, embree, bullet };
enum class Question {
    sweep,
    sweeps,  ///< as many at once as `swept_at_once`
    ray,
    overlap,  ///< all triangles that the body overlaps at the end of the motion
    gather,   ///< all triangles near the box around the whole motion of the body
    nearest,  ///< the nearest point of the scene within a metre of the end of the motion
};
inline constexpr std::size_t swept_at_once = 8;

enum class Order {
    random,  ///< as made: far apart, on cold memory
    sorted,  ///< neighbours in space one by one
};

struct Workload {
    Solver solver = Solver::surefoot;
    Question question = Question::sweep;
    Path path = Path::brief;
    Body body = Body::sphere;
    Order order = Order::random;
};

/// All there are, in the order in which they are told.
[[nodiscard]] std::vector<Workload> all_workloads();

/// "short sphere sweep", "long ray", "sphere overlap", "sphere gather", "nearest point".
[[nodiscard]] std::string name_of(const Workload& workload);
[[nodiscard]] std::string_view name_of(Solver solver);
[[nodiscard]] std::string_view name_of(Order order);

/// Is it ours, or a peer that was installed when this was built?
[[nodiscard]] bool is_built_in(Solver solver);

/// A scene, and everything that answers questions about it. Stays where it is: the peers point into the scene.
struct Stage {
    explicit Stage(Scene&& made);
    Stage(const Stage&) = delete;
    Stage& operator=(const Stage&) = delete;

    [[nodiscard]] const Peer* peer(Solver solver) const {
        return solver == Solver::embree ? embree.get() : solver == Solver::bullet ? bullet.get() : nullptr;
    }

    double build_seconds = 0;  ///< what one waits for Mesh::build [s]
    double embree_build_seconds = 0;
    double bullet_build_seconds = 0;
    Scene scene;
    Mesh mesh;
    std::unique_ptr<Peer> embree;
    std::unique_ptr<Peer> bullet;
};

/// Asks one question after the other. This is the loop that is timed.
[[nodiscard]] Tally ask(const Stage& stage, const Workload& workload, std::span<const Motion> motions);

/// The same questions again, to our own solver, counting its work: nodes opened and triangles tested.
[[nodiscard]] QueryWork count_work(const Stage& stage, const Workload& workload, std::span<const Motion> motions);

/// The box around a body all along its motion, and 5 cm more: what a character's step gathers.
[[nodiscard]] Bounds bounds_of(Body body, const Motion& motion);

constexpr double nearest_within = 1;  ///< [m]

}  // namespace surefoot::bench
