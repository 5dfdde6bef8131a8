/// Takes a mover through a scene and measures it.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "course/mover.hpp"
#include "course/scene.hpp"

namespace surefoot::course {

/// One bar, measured.
struct Mark {
    const Bar* bar = nullptr;
    Worst worst;

    /// A number that is none does not pass.
    [[nodiscard]] bool passes() const { return worst.value <= bar->most; }
};

/// How a mover did in a scene.
struct Score {
    const Scene* scene = nullptr;
    std::vector<Mark> marks;
    std::string failure;  ///< why the mover gave up; empty if it did not

    /// Without marks, as where the scene was not walked, nothing is passed.
    [[nodiscard]] bool passes() const;
};

/// `progress` is told the share that is done [0 to 1].
[[nodiscard]] Score run_scene(const Scene& scene, Mover& mover, const std::function<void(double)>& progress = {});

/// Does a mover miss a bar of the scene, or give up? Each run is measured as soon as it is walked, and the first that
/// misses decides.
[[nodiscard]] bool fails_scene(const Scene& scene, Mover& mover);

/// One run, without measuring: for whoever wants to watch. What comes back refers to the run.
[[nodiscard]] Outing walk_run(const Run& run, Mover& mover);
Outing walk_run(Run&& run, Mover& mover) = delete;

}  // namespace surefoot::course
