/// The motions of a stage, made when they are first asked for, once for all workloads that share them.
#pragma once

#include <cstddef>
#include <map>
#include <tuple>
#include <vector>

#include "workload.hpp"

namespace surefoot::bench {

using Motions = std::vector<Motion>;

class MotionShelf {
public:
    /// Requires: the stage outlives the shelf.
    MotionShelf(const Stage& stage, std::size_t count) : stage_(stage), count_(count) {}

    /// Stays where it is as long as the shelf lives.
    const Motions& of(const Workload& workload) {
        // Distant motions are the same for all bodies.
        const Body body = workload.path == Path::distant ? Body::sphere : workload.body;
        const auto [place, is_new] = made_.try_emplace({workload.path, body, workload.order});
        if (!is_new) return place->second;
        if (workload.order == Order::sorted) {
            Workload as_made = workload;
            as_made.order = Order::random;
            return place->second = sorted_in_space(of(as_made));
        }
        return place->second = make_motions(stage_.scene, stage_.mesh, body, workload.path, count_);
    }

private:
    const Stage& stage_;
    std::size_t count_;
    std::map<std::tuple<Path, Body, Order>, Motions> made_;
};

}  // namespace surefoot::bench
