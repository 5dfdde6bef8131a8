#include "workload.hpp"

#include <algorithm>
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

void count(Tally& tally, const std::optional<Hit>& hit) {
    if (!hit) return;
    ++tally.hits;
    tally.t_sum += hit->t;
}

constexpr std::size_t room_for_overlaps = 64;

}  // namespace

std::vector<Workload> all_workloads() {
    std::vector<Workload> all;
    for (const Order order : {Order::random, Order::sorted}) {
        all.push_back({Solver::embree, Question::ray, Path::distant, Body::sphere, order});
        all.push_back({Solver::surefoot, Question::ray, Path::distant, Body::sphere, order});
        for (const Path path : {Path::brief, Path::distant})
            for (const Body body : bodies) all.push_back({Solver::surefoot, Question::sweep, path, body, order});
        all.push_back({Solver::surefoot, Question::overlap, Path::brief, Body::sphere, order});
        all.push_back({Solver::surefoot, Question::overlap, Path::brief, Body::ellipsoid, order});
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
        case Question::overlap:
            return std::string(name_of(workload.body)) + " overlap";
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

Stage::Stage(Scene&& made)
    : scene(std::move(made)),
      mesh(timed(build_seconds, [&] { return build_or_throw(scene); })),
      embree(timed(embree_build_seconds, [&] { return make_embree(scene); })),
      bullet(timed(bullet_build_seconds, [&] { return make_bullet(scene); })) {}

Tally ask(const Stage& stage, const Workload& workload, std::span<const Motion> motions) {
    if (const Peer* const peer = stage.peer(workload.solver))
        return workload.question == Question::ray ? peer->rays(motions) : peer->sweeps(workload.body, motions);
    Tally tally{.asked = motions.size()};
    const Volume volume = volume_of(workload.body);
    switch (workload.question) {
        case Question::sweep:
            for (const Motion& motion : motions) count(tally, stage.mesh.sweep(volume, motion));
            break;
        case Question::ray:
            for (const Motion& motion : motions) count(tally, stage.mesh.ray(motion));
            break;
        case Question::overlap:
            for (const Motion& motion : motions) {
                Overlap found[room_for_overlaps];
                const std::size_t size = stage.mesh.overlap(volume, motion.to, found);
                tally.hits += size > 0 ? 1 : 0;
                tally.found += size;
            }
            break;
    }
    return tally;
}

double triangles_tested(const Stage& stage, const Workload& workload, std::span<const Motion> motions) {
    if (workload.solver != Solver::surefoot || workload.question != Question::sweep || motions.empty()) return -1;
    std::vector<TraceRecord> room(1 << 16);
    const Volume volume = volume_of(workload.body);
    std::ptrdiff_t tests = 0;
    for (const Motion& motion : motions) {
        Trace trace(room);
        static_cast<void>(stage.mesh.sweep(volume, motion, {.trace = &trace}));
        const auto decided = [](const TraceRecord& record) { return record.verdict == Verdict::decided; };
        tests += std::count_if(trace.records().begin(), trace.records().end(), decided);
    }
    return static_cast<double>(tests) / static_cast<double>(motions.size());
}

}  // namespace surefoot::bench
