#include "playground/start_screen.hpp"

#include <algorithm>
#include <array>
#include <cfloat>
#include <cmath>
#include <glm/geometric.hpp>
#include <imgui.h>

#include "view/fonts.hpp"
#include "view/orbit_camera.hpp"
#include "view/theme.hpp"
#include "view/widgets.hpp"

namespace surefoot::playground {
namespace {

using view::rgb;

/// Blocks of stone with tops and sides: a small stage with steps.
class Masonry {
public:
    void block(const vec3& low, const vec3& high) {
        const auto first = static_cast<std::uint32_t>(vertices_.size());
        for (int i = 0; i < 8; ++i)
            vertices_.emplace_back((i & 1) != 0 ? high.x : low.x, (i & 2) != 0 ? high.y : low.y,
                                   (i & 4) != 0 ? high.z : low.z);
        constexpr std::array<std::array<std::uint32_t, 4>, 6> sides{
            {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};
        for (const auto& s : sides)
            for (const std::uint32_t corner : {s[0], s[1], s[2], s[0], s[2], s[3]}) indices_.push_back(first + corner);
    }
    [[nodiscard]] Expected<Mesh> build() const { return Mesh::build({.vertices = vertices_, .indices = indices_}); }

private:
    std::vector<vec3> vertices_;
    std::vector<std::uint32_t> indices_;
};

class StartScreen final : public Room {
public:
    explicit StartScreen(std::function<void(std::string_view)> choose) : choose_(std::move(choose)) {}

    void enter(Stage& stage) override {
        stage_ = &stage;
        usual_sky_ = stage.renderer.sky;
        stage.renderer.sky.shadow_radius = 26;
        stage.renderer.sky.fog_distance = 120;
        stage.renderer.sky.towards_sun = {-0.55, 0.75, 0.45};
        Masonry masonry;
        masonry.block({-4000, -1, -4000}, {4000, 0, 4000});
        for (int i = 0; i < 6; ++i) {
            const auto x = static_cast<float>(i) * 2.2F - 5.5F;
            masonry.block({x - 0.95F, 0, -0.95F}, {x + 0.95F, 0.22F * static_cast<float>(i + 1), 0.95F});
        }
        if (const auto mesh = masonry.build())
            model_ = view::Model::make(
                *mesh, [](const SourceTriangle& t) { return t.id < 12 ? rgb(0xC9C3B8) : rgb(0xB8B0A2); });
        camera_.jump_to({.pivot = {0.3, 0.9, 0}, .yaw = 0.42, .pitch = 0.2, .distance = 12.8});
        camera_.field_of_view = 0.7;
    }

    void leave() override { stage_->renderer.sky = usual_sky_; }

    bool event(const view::InputEvent& event) override {
        if (const auto* const drop = std::get_if<view::FileDrop>(&event); drop != nullptr && !drop->files.empty()) {
            stage_->level = drop->files.front();
            choose_("walk");
            return true;
        }
        return false;
    }

    bool update(double dt) override {
        time_ += dt;
        auto stand = camera_.goal();
        stand.yaw = 0.42 + 0.10 * std::sin(time_ * 0.25);
        camera_.jump_to(stand);
        return true;
    }

    [[nodiscard]] view::Camera camera() const override {
        view::Camera camera = camera_.camera();
        // The shapes stand in the upper half; cards are below.
        camera.forward = glm::normalize(camera.forward - camera.above() * 0.05);
        return camera;
    }

    void draw(view::Renderer& renderer) override {
        view::ModelLook look{.edges = {.width = 1.5}};
        look.edges.kinds[static_cast<int>(EdgeKind::flat)] = view::with_opacity(view::paint::ink, 0);
        if (model_) renderer.model(model_, look);
        const std::array<Shape, 6> shapes{Sphere{0.62},          Ellipsoid{{0.5, 0.9, 0.5}}, Capsule{0.42, 0.5},
                                          Box{{0.5, 0.75, 0.5}}, Cylinder{0.5, 0.75},        Cone{0.55, 1.6}};
        constexpr std::array<view::Colour, 6> colours{rgb(0xE0483E), rgb(0xF2912B), rgb(0xE9C13B),
                                                      rgb(0x3FA65A), rgb(0x2FA3B5), rgb(0x5B78D0)};
        constexpr std::array<double, 6> heights{0.62, 0.9, 0.92, 0.75, 0.75, 0};
        for (std::size_t i = 0; i < 6; ++i) {
            const double phase = time_ * 0.9 + double(i) * 0.8;
            const double lift = 0.16 + 0.10 * std::sin(phase);
            const dvec3 at(double(i) * 2.2 - 5.5, 0.22 * double(i + 1) + heights[i] + lift, 0);
            renderer.shape(shapes[i], at, {.colour = colours[i], .opacity = 0.55});
        }
    }

    void ui() override {
        const ImVec2 size = ImGui::GetIO().DisplaySize;
        const float letter = ImGui::GetFontSize();
        ImGui::SetNextWindowPos({size.x / 2, size.y - letter * 1.8F}, ImGuiCond_Always, {0.5F, 1});
        ImGui::Begin("start", nullptr,
                     ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize |
                         ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBackground |
                         ImGuiWindowFlags_NoFocusOnAppearing);
        const auto width_of = [&](std::size_t in_a_row) {
            const auto cards = static_cast<float>(in_a_row);
            return std::min(letter * 21, (size.x - letter * (3 + cards)) / cards);
        };
        // In two rows where one would be too narrow to read.
        std::size_t in_a_row = std::max<std::size_t>(rooms().size(), 1);
        if (width_of(in_a_row) < letter * 15) in_a_row = (in_a_row + 1) / 2;
        std::size_t count = 0;
        for (const RoomCard& card : rooms()) {
            if (count++ % in_a_row != 0) ImGui::SameLine(0, letter);
            if (draw_card(card, width_of(in_a_row))) choose_(card.id);
        }
        const float top = ImGui::GetWindowPos().y;
        ImGui::End();
        if (top > letter * 7.8F) draw_title(letter);  // else there is no room for it
    }

private:
    static bool draw_card(const RoomCard& card, float wide) {
        const float letter = ImGui::GetFontSize();
        const ImVec2 low = ImGui::GetCursorScreenPos();
        const ImVec2 size(wide, letter * 7.2F);
        const bool pressed = ImGui::InvisibleButton(card.id.data(), size);
        view::ui::item(std::string(card.name).c_str());
        const bool hot = ImGui::IsItemHovered();
        ImDrawList& list = *ImGui::GetWindowDrawList();
        const ImVec2 high(low.x + size.x, low.y + size.y);
        list.AddRectFilled(low, high, view::packed(hot ? rgb(0x27343F, 0.97) : rgb(0x1B242D, 0.93)), letter * 0.7F);
        list.AddRectFilled({low.x + letter, low.y + letter * 1.1F}, {low.x + letter * 2.6F, low.y + letter * 1.3F},
                           view::packed(view::paint::accent), letter * 0.1F);
        const float scale = ImGui::GetIO().FontGlobalScale;
        const float page = wide - 2 * letter;
        // A name is one line, as large as that goes; a sentence has several.
        ImFont* const large = view::fonts().large;
        const char* const end = card.name.data() + card.name.size();
        const float width = large->CalcTextSizeA(large->FontSize * scale, FLT_MAX, 0, card.name.data(), end).x;
        list.AddText(large, large->FontSize * scale * std::min(1.0F, page / std::max(width, 1.0F)),
                     {low.x + letter, low.y + letter * 1.7F}, view::packed(rgb(0xF2F5F7)), card.name.data(), end);
        list.PushClipRect(low, high, true);
        ImFont* const plain = view::fonts().plain;
        list.AddText(plain, plain->FontSize * scale, {low.x + letter, low.y + letter * 4.1F},
                     view::packed(rgb(0xA9B7C2)), card.blurb.data(), card.blurb.data() + card.blurb.size(), page);
        list.PopClipRect();
        return pressed;
    }

    static void draw_title(float letter) {
        ImDrawList& list = *ImGui::GetBackgroundDrawList();
        const float scale = ImGui::GetIO().FontGlobalScale;
        ImFont* const large = view::fonts().large;
        list.AddText(large, large->FontSize * scale * 1.45F, {letter * 2, letter * 1.6F}, view::packed(rgb(0x1C2A36)),
                     "Surefoot");
        list.AddText(nullptr, 0, {letter * 2.1F, letter * 4.7F}, view::packed(rgb(0x2C3E4C)),
                     "Do I hit something moving from A to B, and where?");
        list.AddText(nullptr, 0, {letter * 2.1F, letter * 6.1F}, view::packed(rgb(0x2C3E4C, 0.75)),
                     "F1 shows the keys. A level that is dropped here opens.");
    }

    std::function<void(std::string_view)> choose_;
    Stage* stage_ = nullptr;
    view::Sky usual_sky_;
    std::shared_ptr<view::Model> model_;
    view::OrbitCamera camera_;
    double time_ = 0;
};

}  // namespace

std::unique_ptr<Room> make_start_screen(std::function<void(std::string_view id)> choose) {
    return std::make_unique<StartScreen>(std::move(choose));
}

}  // namespace surefoot::playground
