// What moves, crumbles and opens by itself.
#include <algorithm>
#include <array>

#include "game/game.hpp"
#include "game/minds.hpp"
#include "game/route.hpp"

namespace surefoot::game {
namespace {

constexpr double door_opens_from = 3;  // m from its box

// How far a place is from a box.
double distance(const Bounds& box, const dvec3& place) {
    double sum = 0;
    for (int i = 0; i < 3; ++i) {
        const double beyond = std::max({box.min[i] - place[i], place[i] - box.max[i], 0.0});
        sum += beyond * beyond;
    }
    return std::sqrt(sum);
}

// Is the body of the hero where this mesh would be?
bool is_in_the_way(const Mesh& mesh, const dvec3& origin, const Volume& volume, const dvec3& position) {
    std::array<Overlap, 1> found;
    return mesh.overlap(volume, position - origin, found) > 0;
}

}  // namespace

void Game::move_bodies() {
    world_.begin_tick();
    for (MovingBody& body : bodies_) {
        const BodyPlan& plan = level_->bodies[body.plan];
        body.before = body.now;
        switch (plan.kind) {
            case BodyKind::platform:
            case BodyKind::turntable:
            case BodyKind::hazard:
                if (body.runs) body.clock += tick_seconds;
                body.now.position = plan.origin + place_on(plan.route, body.clock);
                if (plan.route.deg_per_s != 0)
                    body.now.orientation = turned(body.now.orientation, plan.route.deg_per_s * tick_seconds);
                break;
            case BodyKind::crumble:
                if (body.phase == MovingBody::Phase::rest) break;
                body.since += tick_seconds;
                if (body.phase == MovingBody::Phase::shakes && body.since >= plan.delay) {
                    body.phase = MovingBody::Phase::gone;
                    body.since = 0;
                    body.is_there = false;
                    world_.set_layers(body.handle, 0);
                    say(Happening::crumbled, body.now.position);
                } else if (body.phase == MovingBody::Phase::gone && body.since >= plan.back &&
                           !is_in_the_way(plan.mesh, plan.origin, settings_.volume, hero_.body.position)) {
                    body.phase = MovingBody::Phase::rest;
                    body.since = 0;
                    body.is_there = true;
                    world_.set_layers(body.handle, moving_layer);
                    say(Happening::crumble_back, body.now.position);
                }
                break;
            case BodyKind::door:
                if (body.phase == MovingBody::Phase::opens) {
                    body.since += tick_seconds;
                    if (body.since >= 1) body.phase = MovingBody::Phase::open;
                }
                break;
            case BodyKind::bounce:
                break;
        }
        if (body.now.position != body.before.position || body.now.orientation != body.before.orientation)
            (void)world_.move(body.handle, body.now);
    }
}

void Game::touch_bodies() {
    if (hero_.body.footing != Footing::ground) return;
    for (MovingBody& body : bodies_) {
        if (body.body != hero_.body.ground_body || !body.is_there) continue;
        const BodyPlan& plan = level_->bodies[body.plan];
        body.runs = true;
        if (plan.kind == BodyKind::crumble && body.phase == MovingBody::Phase::rest) {
            body.phase = MovingBody::Phase::shakes;
            body.since = 0;
            say(Happening::crumbling, body.now.position);
        }
        if (plan.kind == BodyKind::bounce) {
            hero_.bounce = plan.bounce;
            say(Happening::bounced, feet(), plan.bounce);
        }
    }
}

void Game::open_doors() {
    for (MovingBody& body : bodies_) {
        const BodyPlan& plan = level_->bodies[body.plan];
        if (plan.kind != BodyKind::door || body.phase != MovingBody::Phase::rest) continue;
        const bool may = plan.door.empty() ? coins_ >= plan.coins : std::ranges::find(keys_, plan.door) != keys_.end();
        if (!may) continue;
        const Bounds box = plan.mesh.bounds();
        if (distance({box.min + plan.origin, box.max + plan.origin}, hero_.body.position) > door_opens_from) continue;
        // It is out of the way at once, and drawn sliding: nobody is caught in it.
        body.phase = MovingBody::Phase::opens;
        body.since = 0;
        body.is_there = false;
        world_.set_layers(body.handle, 0);
        say(Happening::door_opened, plan.origin);
    }
}

}  // namespace surefoot::game
