/// What cooking found odd about a level, as a list to jump through and as marks in the world.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "playground/level_loader.hpp"
#include "view/renderer.hpp"

namespace surefoot::playground {

class Findings {
public:
    explicit Findings(const CookReport& report);

    void draw(view::Renderer& renderer, const tools::Level& level) const;

    /// The list; a place to go to if the user wants to see one.
    [[nodiscard]] std::optional<dvec3> ui();

    /// The next of all places, and again the first after the last; none if there are none.
    [[nodiscard]] std::optional<dvec3> next();

    bool shown = true;

private:
    struct Group {
        const char* name;
        const char* meaning;
        view::Colour colour;
        Finding finding;
        bool shown;
    };

    std::vector<Group> groups_;
    std::size_t chosen_group_ = 0;
    std::size_t chosen_ = 0;
    bool any_chosen_ = false;
};

}  // namespace surefoot::playground
