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
    std::string other;  ///< a mover; empty for none

    friend bool operator==(const CourseChoice&, const CourseChoice&) = default;
};

class ScenePanel {
public:
    /// The widgets: true if something else was chosen.
    bool ui(const course::Scenes& scenes, CourseChoice& choice);

    /// Walks another run of what is being measured; true while there are more.
    bool update();

    void forget_measures() { measured_.clear(); }

private:
    void bars(const course::Scene& scene, const CourseChoice& choice);

    std::vector<Measuring> measured_;
};

}  // namespace surefoot::playground
