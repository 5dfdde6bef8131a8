#include "playground/walk/walk.hpp"

#include "view/orbit_camera.hpp"
#include "view/widgets.hpp"

namespace surefoot::playground {
namespace {

class Walk final : public Room {
public:
    void enter(Stage& stage) override {
        stage_ = &stage;
        const std::string level = stage.level.empty() ? "levels/training-ground.glb" : stage.level;
        stage.open_level(level, [this](const LevelLoader::Loaded& loaded) { show(loaded); });
    }
    bool event(const view::InputEvent& event) override { return camera_.event(event, stage_->display.size()); }
    bool update(double dt) override { return camera_.update(dt); }
    [[nodiscard]] view::Camera camera() const override { return camera_.camera(); }
    void draw(view::Renderer& renderer) override {
        if (model_) renderer.model(model_, {.edges = {.width = 1}});
    }
    void ui() override {}

private:
    void show(const LevelLoader::Loaded& loaded) {
        level_ = loaded;
        const tools::Level& level = level_->level;
        model_ = view::Model::make(level.mesh, [&](const SourceTriangle& t) {
            return view::colour_of_surface(t.surface, tools::surface_name(level, t.surface));
        });
        camera_.frame(level.mesh.bounds());
        camera_.jump_to(camera_.goal());
    }

    Stage* stage_ = nullptr;
    LevelLoader::Loaded level_;
    std::shared_ptr<view::Model> model_;
    view::OrbitCamera camera_;
};

}  // namespace

std::unique_ptr<Room> make_walk() {
    return std::make_unique<Walk>();
}

}  // namespace surefoot::playground
