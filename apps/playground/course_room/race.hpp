/// A run of the course, walked by our character and by another mover, to be watched; and what all runs of its scene
/// measure. It draws nothing.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "course/mover.hpp"
#include "course/runner.hpp"

namespace surefoot::playground {

/// Who walks beside ours: a mover of this build, or a program that speaks the line protocol
/// (docs/course-protocol.md), or nobody.
struct Rival {
    std::string mover{};
    std::string command{};  ///< of the program, for the shell; the mover does not count then

    [[nodiscard]] bool is_nobody() const { return mover.empty() && command.empty(); }

    /// Whoever it is; a program is called "the program". Throws `course::MoverFailure` if it cannot be had.
    [[nodiscard]] std::string name() const { return command.empty() ? mover : "the program"; }
    [[nodiscard]] std::unique_ptr<course::Mover> make() const;

    friend bool operator==(const Rival&, const Rival&) = default;
};

/// One who walks.
struct Racer {
    std::string name;
    course::Outing outing;

    /// Where the body is at a time, between two ticks. Requires: an outing with a spot.
    [[nodiscard]] dvec3 position_at(double time) const;

    /// The last spot at or before a time. Requires: as above.
    [[nodiscard]] const course::Spot& spot_at(double time) const;
};

class Race {
public:
    /// Lets ours walk and, if it is anybody, the other too. `run` outlives the race.
    Race(const course::Run& run, const Rival& other);

    [[nodiscard]] const course::Run& run() const { return *run_; }
    [[nodiscard]] const Racer& ours() const { return ours_; }
    [[nodiscard]] const std::optional<Racer>& other() const { return other_; }

    /// The script begins at 0; before that they come to stand [s].
    [[nodiscard]] double begin() const;
    [[nodiscard]] double end() const;

    /// How far they are apart [m]; 0 if there is no other.
    [[nodiscard]] double gap_at(double time) const;

private:
    const course::Run* run_;
    Racer ours_;
    std::optional<Racer> other_;
};

/// All runs of a scene, one after the other, so that a window stays alive meanwhile.
class Measuring {
public:
    Measuring(const course::Scene& scene, const Rival& who);

    /// Walks the next run; true while there are more.
    bool go_on();

    [[nodiscard]] bool is_done() const { return outings_.size() == scene_->runs.size() || !score_.failure.empty(); }
    [[nodiscard]] std::size_t runs_done() const { return outings_.size(); }
    [[nodiscard]] const std::string& mover() const { return name_; }

    /// Requires: it is done.
    [[nodiscard]] const course::Score& score() const { return score_; }

private:
    const course::Scene* scene_;
    std::string name_;
    std::unique_ptr<course::Mover> mover_;
    std::vector<course::Outing> outings_;
    course::Score score_;
};

}  // namespace surefoot::playground
