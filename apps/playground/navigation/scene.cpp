#include "playground/navigation/scene.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <new>

#include <surefoot/character.hpp>
#include <surefoot/navigation_links.hpp>

namespace surefoot::playground {
namespace {

constexpr double slippery_grip = 0.2;  // ground with less than this
constexpr double slippery_cost = 2;

}  // namespace

void NavigationScene::read_outlines() {
    outlines.resize(mesh.outlines({}));
    mesh.outlines(outlines);
    draped.clear();
    places.clear();
    for (const NavigationOutline& outline : outlines) {
        places.emplace(outline.polygon.id, draped.size());
        draped.push_back(drape(world, mesh, outline));
    }
}

const DrapedPolygon* NavigationScene::draped_of(NavigationPolygon polygon) const {
    const auto found = places.find(polygon.id);
    return found == places.end() ? nullptr : &draped[found->second];
}

const NavigationOutline* NavigationScene::outline_at(const dvec3& place) const {
    const NavigationOutline* best = nullptr;
    double least = mesh.agent().height;
    for (const NavigationOutline& outline : outlines) {
        bool is_inside = outline.corners > 0;
        for (std::uint32_t i = 0; i < outline.corners && is_inside; ++i) {
            const dvec3 side = outline.corner[(i + 1) % outline.corners] - outline.corner[i];
            is_inside = glm::dot(glm::cross(side, place - outline.corner[i]), up()) >= 0;
        }
        if (!is_inside) continue;
        const double off = std::abs(glm::dot(outline.corner[0] - place, up()));
        if (off >= least) continue;
        least = off;
        best = &outline;
    }
    return best;
}

LinkArc arc_of(const World& world, const CharacterSettings& settings, const NavigationMesh& mesh,
               const NavigationLink& link) {
    constexpr std::size_t most = 60 * 30;  // places; no link takes so long
    const dvec3 feet = mesh.up() * mesh.agent().feet;
    CharacterState state = stand_at(world, settings, link.from, mesh.up(), link.tick);
    CharacterInput input{.up = mesh.up()};
    LinkArc arc{link.kind, {state.position - feet}};
    for (const NavigationInput& told : link.inputs) {
        input.wish = told.wish;
        input.jump = told.jump != 0;
        input.crouch = told.crouch != 0;
        for (std::uint32_t i = 0; i < told.ticks && arc.places.size() < most; ++i) {
            state = step(world, settings, input, link.tick, state).state;
            arc.places.push_back(state.position - feet);
        }
    }
    return arc;
}

Expected<std::unique_ptr<NavigationScene>> make_scene(const NavigationGroundPointer& ground,
                                                      const NavigationProgress& progress) {
    try {
        World world;
        for (const NavigationGround::Piece& piece : ground->pieces) {
            const auto added = world.add(piece.mesh, {.pose = piece.pose});
            if (!added) return tl::unexpected(added.error());
        }
        CharacterSettings settings = ground->settings;
        settings.surfaces = SurfaceRules(ground->rules);
        std::vector<std::uint32_t> surface_areas;
        for (const SurfaceRule& rule : ground->rules)
            surface_areas.push_back(rule.grip < slippery_grip ? slippery_area : 0);
        const NavigationArea areas[] = {{.name = "ground"}, {.name = "slippery", .cost = slippery_cost}};
        auto mesh = NavigationMesh::build(world, settings,
                                          {.areas = areas, .surface_areas = surface_areas, .progress = progress});
        if (!mesh) return tl::unexpected(mesh.error());
        auto scene = std::unique_ptr<NavigationScene>(
            new NavigationScene{ground, std::move(world), settings, std::move(*mesh), {}, {}, {}, {}});
        scene->read_outlines();
        for (const NavigationLink& link : scene->mesh.links())
            scene->arcs.push_back(arc_of(scene->world, settings, scene->mesh, link));
        return scene;
    } catch (const std::bad_alloc&) {
        return tl::unexpected(Error{
            ErrorCode::out_of_memory, "The level is too large for a navigation mesh in this machine's memory.", {}, 0});
    }
}

void SceneMaker::want(const NavigationGroundPointer& ground) {
    wanted_ = ground;
    if (!result_.valid()) begin();
}

void SceneMaker::begin() {
    if (!wanted_) return;
    made_of_ = wanted_;
    progress_ = std::make_shared<Progress>();
    result_ =
        std::async(at_once_ ? std::launch::deferred : std::launch::async, [ground = made_of_, progress = progress_]() {
            const auto tell = [&](std::size_t done, std::size_t all) {
                progress->all = all;
                progress->done = done;
            };
            return make_scene(ground, tell);
        });
}

std::optional<Expected<std::unique_ptr<NavigationScene>>> SceneMaker::take() {
    if (!result_.valid() || result_.wait_for(std::chrono::seconds(0)) == std::future_status::timeout)
        return std::nullopt;
    auto made = result_.get();
    if (made_of_ == wanted_) {
        wanted_.reset();
        return made;
    }
    begin();
    return std::nullopt;
}

double SceneMaker::share() const {
    const std::size_t all = progress_ ? progress_->all.load() : 0;
    return all == 0 ? 0 : static_cast<double>(progress_->done.load()) / static_cast<double>(all);
}

}  // namespace surefoot::playground
