/// Which scene, which run and which ghost; the scene's bars, and what was measured against them.
#pragma once

#include <string>
#include <vector>

#include "course/catalogue.hpp"
#include "playground/course_room/race.hpp"

namespace surefoot::playground {

struct CourseChoice {
    std::size_t scene = 0;
    std::size_t run = 0;
    Rival other{};

    friend bool operator==(const CourseChoice&, const CourseChoice&) = default;
};

class ScenePanel {
public:
    /// As if this had been typed.
    void type_command(const std::string& command) { command_ = command; }

    /// What is wrong with the ghost, to be told; empty if nothing is.
    void tell_failure(const std::string& failure) { failure_ = failure; }

    /// The widgets: true if something else was chosen.
    bool ui(const course::Scenes& scenes, CourseChoice& choice);

    /// Walks another run of what is being measured; true while there are more.
    bool update();

    void forget_measures() { measured_.clear(); }

private:
    void ghost(CourseChoice& choice);
    void bars(const course::Scene& scene, const CourseChoice& choice);

    std::vector<Measuring> measured_;
    std::string failure_;
    std::string command_;  // that was typed, but not yet taken
};

}  // namespace surefoot::playground
