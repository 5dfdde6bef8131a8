#include "workload.hpp"

#include <algorithm>
#include <array>
#include <glm/common.hpp>
#include <stdexcept>

#include "clock.hpp"

namespace surefoot::bench {
namespace {

Mesh build_or_throw(const Scene& scene) {
    Expected<Mesh> mesh = Mesh::build(scene.mesh_input());
    if (!mesh) throw std::runtime_error(scene.name + ": " + mesh.error().text);
    return std::move(*mesh);
}

/// Calls `make`, and says how long that took.
template <typename Make>
auto timed(double& seconds, const Make& make) {
    const double begin = wall_seconds();
    auto made = make();
    seconds = wall_seconds() - begin;
    return made;
}

/// Builds four times: the first pays for fresh memory, of the others the one in the middle is told.
Mesh timed_build(double& seconds, const Scene& scene) {
    Mesh mesh = build_or_throw(scene);
    std::array<double, 3> times{};
    for (double& time : times) mesh = timed(time, [&] { return build_or_throw(scene); });
    std::sort(times.begin(), times.end());
    seconds = times[1];
    return mesh;
}

void count(Tally& tally, const std::optional<Hit>& hit) {
    if (!hit) return;
    ++tally.hits;
    tally.t_sum += hit->t;
}

void count(Tally& tally, std::size_t found) {
    tally.hits += found > 0 ? 1 : 0;
    tally.found += found;
}

// More than any of the scenes ever fills.
constexpr std::size_t room = 512;

Tally ask_mesh(const Mesh& mesh, const Workload& workload, std::span<const Motion> motions,
               const QueryOptions& options) {
    Tally tally{.asked = motions.size()};
    const Volume volume = volume_of(workload.body);
    std::array<Overlap, room> overlaps;
    std::array<SourceTriangle, room> triangles;
    switch (workload.question) {
        case Question::sweep:
            for (const Motion& motion : motions) count(tally, mesh.sweep(volume, motion, options));
            break;
        case Question::sweeps:
            for (std::size_t i = 0; i < motions.size(); i += swept_at_once) {
                const std::span some = motions.subspan(i, std::min(swept_at_once, motions.size() - i));
                std::array<std::optional<Hit>, swept_at_once> hits;
                mesh.sweep_many(volume, some, hits, options);
                for (std::size_t k = 0; k < some.size(); ++k) count(tally, hits[k]);
            }
            break;
        case Question::ray:
            for (const Motion& motion : motions) count(tally, mesh.ray(motion, options));
            break;
        case Question::overlap:
            for (const Motion& motion : motions) count(tally, mesh.overlap(volume, motion.to, overlaps, options));
            break;
        case Question::gather:
            for (const Motion& motion : motions)
                count(tally, mesh.gather(bounds_of(workload.body, motion), triangles, options));
            break;
        case Question::nearest:
            for (const Motion& motion : motions)
                count(tally, std::size_t{mesh.nearest(motion.to, nearest_within, options) ? 1U : 0U});
            break;
    }
    return tally;
}

}  // namespace

std::vector<Workload> all_workloads() {
    std::vector<Workload> all;
    for (const Order order : {Order::random, Order::sorted}) {
        all.push_back({Solver::embree, Question::ray, Path::distant, Body::sphere, order});
        all.push_back({Solver::surefoot, Question::ray, Path::distant, Body::sphere, order});
        for (const Path path : {Path::brief, Path::distant})
            for (const Body body : bodies) all.push_back({Solver::surefoot, Question::sweep, path, body, order});
        for (const Body body : {Body::sphere, Body::ellipsoid})
            all.push_back({Solver::surefoot, Question::sweeps, Path::brief, body, order});
        all.push_back({Solver::surefoot, Question::overlap, Path::brief, Body::sphere, order});
        all.push_back({Solver::surefoot, Question::overlap, Path::brief, Body::ellipsoid, order});
        all.push_back({Solver::surefoot, Question::gather, Path::brief, Body::sphere, order});
        all.push_back({Solver::surefoot, Question::gather, Path::brief, Body::ellipsoid, order});
        all.push_back({Solver::surefoot, Question::nearest, Path::brief, Body::sphere, order});
    }
    all.push_back({Solver::bullet, Question::ray, Path::distant, Body::sphere, Order::random});
    for (const Path path : {Path::brief, Path::distant})
        for (const Body body : {Body::sphere, Body::capsule, Body::box})
            all.push_back({Solver::bullet, Question::sweep, path, body, Order::random});
    return all;
}

std::string name_of(const Workload& workload) {
    const std::string path = workload.path == Path::brief ? "short " : "long ";
    switch (workload.question) {
        case Question::ray:
            return path + "ray";
        case Question::sweeps:
            return path + std::string(name_of(workload.body)) + " sweeps, 8 at once";
        case Question::overlap:
            return std::string(name_of(workload.body)) + " overlap";
        case Question::gather:
            return std::string(name_of(workload.body)) + " gather";
        case Question::nearest:
            return "nearest point";
        case Question::sweep:
            break;
    }
    return path + std::string(name_of(workload.body)) + " sweep";
}

std::string_view name_of(Solver solver) {
    return solver == Solver::surefoot ? "Surefoot" : solver == Solver::embree ? "Embree" : "Bullet";
}

std::string_view name_of(Order order) {
    return order == Order::random ? "random" : "sorted";
}

bool is_built_in(Solver solver) {
    if (solver == Solver::embree) return embree_missing().empty();
    return solver == Solver::surefoot || bullet_missing().empty();
}

Stage::Stage(Scene&& made)
    : scene(std::move(made)),
      mesh(timed_build(build_seconds, scene)),
      embree(timed(embree_build_seconds, [&] { return make_embree(scene); })),
      bullet(timed(bullet_build_seconds, [&] { return make_bullet(scene); })) {}

Tally ask(const Stage& stage, const Workload& workload, std::span<const Motion> motions) {
    if (const Peer* const peer = stage.peer(workload.solver))
        return workload.question == Question::ray ? peer->rays(motions) : peer->sweeps(workload.body, motions);
    return ask_mesh(stage.mesh, workload, motions, {});
}

QueryWork count_work(const Stage& stage, const Workload& workload, std::span<const Motion> motions) {
    QueryWork work;
    static_cast<void>(ask_mesh(stage.mesh, workload, motions, {.work = &work}));
    return work;
}

Bounds bounds_of(Body body, const Motion& motion) {
    // A cone stands on its reference point; the other bodies have theirs in the middle.
    constexpr double skin = 0.05;
    const dvec3 half = (body == Body::sphere ? dvec3(0.4) : dvec3(0.4, 0.9, 0.4)) + skin;
    const dvec3 middle = body == Body::cone ? dvec3(0, 0.9, 0) : dvec3(0, 0, 0);
    return {glm::min(motion.from, motion.to) + middle - half, glm::max(motion.from, motion.to) + middle + half};
}

}  // namespace surefoot::bench
