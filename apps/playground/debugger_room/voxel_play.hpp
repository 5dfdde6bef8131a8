/// The voxel lesson as a story that is told one step at a time: the same move wrong and right, once or a few times in a
/// row, forwards and back.
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "debugger/voxel_lesson.hpp"

namespace surefoot::playground {

struct VoxelStory {
    const char* name;
    const char* about;  ///< one or two sentences
    debugger::VoxelScene scene;
    int moves = 1;  ///< in a row, each from where the last one ended
};

/// The corner, the wall, the step.
[[nodiscard]] std::span<const VoxelStory> voxel_stories();

/// All that one method does in a story.
struct VoxelTale {
    debugger::VoxelMethod method = debugger::VoxelMethod::each_from_the_last;
    std::vector<debugger::VoxelStep> steps;
    std::vector<int> move_of;  ///< to which move each step belongs, from 0
    std::string conclusion;    ///< what came of it
};

[[nodiscard]] VoxelTale tell(const VoxelStory& story, debugger::VoxelMethod method);

class VoxelPlay {
public:
    static constexpr double walk_time = 0.6;  ///< for which a step is on its way [s]
    static constexpr double rest_time = 1.1;  ///< and after which the next one follows when it plays [s]

    VoxelPlay() { choose(0); }

    void choose(std::size_t story);
    [[nodiscard]] std::size_t chosen() const { return chosen_; }
    [[nodiscard]] const VoxelStory& story() const { return voxel_stories()[chosen_]; }

    /// How many steps were taken, of how many. The last one may still be on its way.
    [[nodiscard]] int taken() const { return taken_; }
    [[nodiscard]] int count() const { return count_; }
    [[nodiscard]] bool plays() const { return plays_; }

    void next();  ///< at once, if a step is still on its way
    void back();
    void restart();
    void play();  ///< from the start, if it is at the end
    void pause() { plays_ = false; }

    /// True while something moves or will.
    bool update(double dt);

    [[nodiscard]] const VoxelTale& wrong() const { return wrong_; }
    [[nodiscard]] const VoxelTale& right() const { return right_; }

    /// The step of a tale that is being told; null before the first.
    [[nodiscard]] const debugger::VoxelStep* step(const VoxelTale& tale) const;

    /// Where the box is now.
    [[nodiscard]] dvec3 position(const VoxelTale& tale) const;

    /// Where the move that is being told began.
    [[nodiscard]] dvec3 move_start(const VoxelTale& tale) const;

    /// Has it all been told?
    [[nodiscard]] bool at_end() const { return taken_ == count_ && since_ >= walk_time; }

private:
    [[nodiscard]] double share() const;

    std::size_t chosen_ = 0;
    VoxelTale wrong_;
    VoxelTale right_;
    int taken_ = 0;
    int count_ = 0;
    double since_ = walk_time;  // the last step was taken [s]
    bool plays_ = false;
};

}  // namespace surefoot::playground
