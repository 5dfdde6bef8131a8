/// The navigation overlay of every room that has ground: the mesh on which one walks there, ways over it and how they
/// are found, and characters that run to a target.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "playground/navigation/ground.hpp"
#include "playground/navigation/link_search.hpp"
#include "playground/navigation/runners.hpp"
#include "playground/navigation/scene.hpp"
#include "playground/navigation/target.hpp"
#include "playground/navigation/way.hpp"
#include "view/input.hpp"
#include "view/renderer.hpp"

namespace surefoot::playground {

/// What of it is drawn.
struct NavigationLook {
    bool mesh = true;
    bool portals = false;
    bool raw = false;
    bool pulled = true;
    bool links = true;
    bool search = false;
};

class NavigationOverlay {
public:
    using Eye = NavigationTarget::Eye;

    /// `at_once`: builds within a frame, and says nothing that differs from run to run.
    explicit NavigationOverlay(bool at_once) : at_once_(at_once), maker_(at_once) {}

    bool shown = false;
    NavigationLook look;

    /// Where the way begins and ends when the first mesh is there, instead of where it would by itself; feet.
    void begin_at(const std::optional<dvec3>& from, const std::optional<dvec3>& to) {
        wanted_from_ = from;
        wanted_to_ = to;
    }

    /// What the room stands on now; null if that is nothing.
    void set_ground(const NavigationGroundPointer& ground);

    /// Before the room: true for what is of use here alone.
    bool event(const view::InputEvent& event, const Eye& eye);

    /// Do clicks put something here, so that the room leaves them alone?
    [[nodiscard]] bool takes_clicks() const { return shown && here_ && clicks_; }

    /// A tick; true while something moves.
    bool update();
    void draw(view::Renderer& renderer, double waiting);

    /// The widgets, within a panel of the room.
    void ui();

    // For tests: null until there is one.
    [[nodiscard]] NavigationScene* scene() { return here_ ? here_->scene.get() : nullptr; }
    [[nodiscard]] const NavigationWay* way() const { return here_ ? &here_->way : nullptr; }
    [[nodiscard]] const NavigationTarget* target() const { return here_ ? &here_->target : nullptr; }
    [[nodiscard]] const NavigationRunners* runners() const { return here_ ? &here_->runners : nullptr; }
    [[nodiscard]] const dvec3& start() const { return start_; }
    [[nodiscard]] bool is_busy() const { return maker_.is_busy() || (here_ && here_->link_search.is_busy()); }
    [[nodiscard]] const std::string& failure() const { return failure_; }

private:
    /// All that belongs to one mesh.
    struct Here {
        explicit Here(std::unique_ptr<NavigationScene> made)
            : scene(std::move(made)), way(*scene), target(*scene), runners(*scene) {}

        std::unique_ptr<NavigationScene> scene;
        NavigationWay way;
        NavigationTarget target;
        NavigationRunners runners;
        LinkSearch link_search;  // the first to go: it looks at the scene
    };

    void settle_in(std::unique_ptr<NavigationScene> scene);
    void plan();
    void take_links();
    void put(const dvec3& place, const view::Modifiers& held);
    bool button(const view::ButtonPress& press, const Eye& eye);
    void look_ui();
    void link_ui();
    void search_ui();
    void area_ui();
    void runner_ui();

    bool at_once_;
    SceneMaker maker_;
    NavigationGroundPointer ground_;
    NavigationGroundPointer asked_;  // a scene of this is there, being made, or cannot be made
    std::unique_ptr<Here> here_;
    std::string failure_;
    dvec3 start_{0, 0, 0};
    std::optional<dvec3> wanted_from_;
    std::optional<dvec3> wanted_to_;
    std::optional<view::ButtonPress> pressed_;  // that may become a click
    bool is_hovered_ = false;
    bool clicks_ = true;
    double runners_wanted_ = 1;
    double round_ = 0;
    bool plays_ = false;
};

}  // namespace surefoot::playground
