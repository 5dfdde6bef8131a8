#include "playground/navigation/overlay.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "playground/navigation/paint.hpp"

namespace surefoot::playground {

using view::Key;

void NavigationOverlay::set_ground(const NavigationGroundPointer& ground) {
    ground_ = ground;
    if (here_ && here_->scene->ground != ground) {
        // Another level: nothing of this one is good for it. Other settings: it is shown until the new one is there.
        const NavigationGroundPointer old = here_->scene->ground;
        const bool same_place = ground && ground->start == old->start && ground->pieces.size() == old->pieces.size();
        if (!same_place) here_.reset();
    }
    if (!shown || !ground || ground == asked_) return;
    asked_ = ground;
    failure_.clear();
    maker_.want(ground);
}

/// Without a wish, the way is a long one, so that there is something to see.
void NavigationOverlay::settle_in(std::unique_ptr<NavigationScene> scene) {
    here_ = std::make_unique<Here>(std::move(scene));
    const NavigationQuery& query = here_->way.query();
    start_ = wanted_from_.value_or(here_->scene->ground->start);
    if (!wanted_from_ && !here_->way.place_near(start_))
        if (const auto any = query.random(1)) start_ = any->position;
    const auto from = here_->way.place_near(start_);
    if (from && !wanted_from_) start_ = from->position;
    dvec3 goal = wanted_to_.value_or(start_);
    constexpr std::uint64_t tries = 12;
    double longest = 0;
    for (std::uint64_t i = 0; i < tries && from && !wanted_to_; ++i) {
        const auto place = query.random_reachable(*from, i);
        const auto path = place ? query.path(*from, *place) : std::nullopt;
        if (!path || path->partial || path->length <= longest) continue;
        longest = path->length;
        goal = place->position;
    }
    wanted_from_.reset();
    wanted_to_.reset();
    here_->target.put(goal);
    plan();
}

void NavigationOverlay::plan() {
    here_->way.plan(start_, here_->target.feet());
    if (look.search) round_ = std::min(round_, static_cast<double>(here_->way.rounds()));
}

/// A click: the target; with Shift the start; with Control a polygon is taken out, or put back.
void NavigationOverlay::put(const dvec3& place, const view::Modifiers& held) {
    const auto on_mesh = here_->way.place_near(place);
    if (held.control) {
        NavigationScene& scene = *here_->scene;
        const NavigationOutline* const there = scene.outline_at(place);
        if (there == nullptr || here_->link_search.is_busy()) return;
        const NavigationPolygon polygon = there->polygon;
        scene.mesh.take_out({&polygon, 1}, !there->taken_out);
        scene.read_outlines();
        here_->runners.look_again();
    } else if (held.shift) {
        start_ = on_mesh ? on_mesh->position : place;
    } else {
        here_->target.put(on_mesh ? on_mesh->position : place);
    }
    plan();
}

bool NavigationOverlay::button(const view::ButtonPress& press, const Eye& eye) {
    if (press.button != view::MouseButton::left) return false;
    if (press.down) {
        pressed_ = press;
        return here_->target.grab(press.at, eye);
    }
    if (here_->target.is_held()) {
        here_->target.let_go();
        pressed_.reset();
        return true;
    }
    // What hardly moved between press and release was a click, the rest a drag of the camera, which has to end too.
    constexpr double hardly = 4;
    if (clicks_ && pressed_ && glm::length(press.at - pressed_->at) <= hardly)
        if (const auto place = here_->target.place_under(press.at, eye)) put(*place, pressed_->held);
    pressed_.reset();
    return false;
}

bool NavigationOverlay::event(const view::InputEvent& event, const Eye& eye) {
    if (view::is_press(event, Key::f2)) {
        shown = !shown;
        return true;
    }
    if (!shown || !here_) return false;
    if (const auto* const press = std::get_if<view::ButtonPress>(&event)) return button(*press, eye);
    if (const auto* const focus = std::get_if<view::FocusChange>(&event); focus != nullptr && !focus->focused)
        here_->target.let_go();
    const auto* const move = std::get_if<view::PointerMove>(&event);
    if (move == nullptr) return false;
    if (!here_->target.is_held()) {
        is_hovered_ = here_->target.is_under(move->at, eye);
        return false;
    }
    if (here_->target.drag(move->at, eye)) {
        if (const auto on_mesh = here_->way.place_near(here_->target.feet())) here_->target.put(on_mesh->position);
        plan();
    }
    return true;
}

void NavigationOverlay::take_links() {
    auto found = here_->link_search.take();
    if (!found) return;
    const auto put = put_links(*here_->scene, std::move(*found));
    if (!put) failure_ = put.error().text;
    here_->runners.look_again();
    plan();
}

bool NavigationOverlay::update() {
    if (!shown) return false;
    if (auto made = maker_.take()) {
        if (here_) {
            wanted_from_ = start_;
            wanted_to_ = here_->target.feet();
        }
        if (!*made) {
            failure_ = made->error().text;
            here_.reset();
        } else if ((**made)->ground == ground_) {
            settle_in(std::move(**made));
        }
    }
    if (!here_) return maker_.is_busy();
    take_links();
    const auto wanted = static_cast<std::size_t>(std::lround(runners_wanted_));
    if (here_->runners.size() != wanted) here_->runners.be(wanted, start_);
    const bool runs = here_->runners.run(here_->target.feet());
    if (plays_) {
        const auto last = static_cast<double>(here_->way.rounds());
        // Ten seconds for the longest, and never slower than a polygon in a few ticks.
        round_ = std::min(round_ + std::max(last / 600, 0.25), last);
        plays_ = round_ < last;
    }
    return runs || plays_ || is_busy();
}

void NavigationOverlay::draw(view::Renderer& renderer, double waiting) {
    if (!shown || !here_) return;
    namespace paint = navigation_paint;
    const NavigationScene& scene = *here_->scene;
    const NavigationPath* const path = here_->way.path();
    if (look.mesh) paint::mesh(renderer, scene);
    if (look.links) paint::links(renderer, scene);
    if (look.search) {
        const auto& nodes = here_->way.nodes_after(static_cast<std::size_t>(round_));
        paint::search(renderer, scene, nodes, here_->way.looked_at());
    }
    // The path is what a search ends with.
    const bool is_found = !look.search || round_ >= static_cast<double>(here_->way.rounds());
    if (path != nullptr && is_found) {
        if (look.portals) paint::portals(renderer, scene, *path);
        if (look.raw) paint::raw_path(renderer, scene, here_->way);
        if (look.pulled) paint::pulled_path(renderer, scene, here_->way);
    }
    paint::start(renderer, scene, start_);
    paint::runners(renderer, scene, here_->runners, waiting);
    paint::target(renderer, here_->target, is_hovered_ || here_->target.is_held(),
                  here_->way.place_near(here_->target.feet()).has_value());
}

}  // namespace surefoot::playground
