#include "view/imgui_adapter.hpp"

#include <backends/imgui_impl_opengl3.h>
#include <cmath>
#include <imgui.h>

#include "view/fonts.hpp"
#include "view/gl.hpp"
#include "view/theme.hpp"
#include "view/widgets.hpp"

namespace surefoot::view {
namespace {

constexpr double letter_height = 15.5;  // in window units, of a system that wants its usual letters

const char* get_clipboard(void* display) {
    static std::string text;
    text = static_cast<Display*>(display)->clipboard();
    return text.c_str();
}

void set_clipboard(void* display, const char* text) {
    static_cast<Display*>(display)->set_clipboard(text);
}

void map_keys(ImGuiIO& io) {
    const auto map = [&](ImGuiKey theirs, Key ours) { io.KeyMap[theirs] = static_cast<int>(ours); };
    map(ImGuiKey_Tab, Key::tab);
    map(ImGuiKey_LeftArrow, Key::left);
    map(ImGuiKey_RightArrow, Key::right);
    map(ImGuiKey_UpArrow, Key::up);
    map(ImGuiKey_DownArrow, Key::down);
    map(ImGuiKey_PageUp, Key::page_up);
    map(ImGuiKey_PageDown, Key::page_down);
    map(ImGuiKey_Home, Key::home);
    map(ImGuiKey_End, Key::end);
    map(ImGuiKey_Insert, Key::insert);
    map(ImGuiKey_Delete, Key::del);
    map(ImGuiKey_Backspace, Key::backspace);
    map(ImGuiKey_Space, Key::space);
    map(ImGuiKey_Enter, Key::enter);
    map(ImGuiKey_Escape, Key::escape);
    map(ImGuiKey_A, Key::a);
    map(ImGuiKey_C, Key::c);
    map(ImGuiKey_V, Key::v);
    map(ImGuiKey_X, Key::x);
    map(ImGuiKey_Y, Key::y);
    map(ImGuiKey_Z, Key::z);
}

}  // namespace

ImGuiAdapter::ImGuiAdapter(Display& display) : display_(display) {
    IMGUI_CHECKVERSION();
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;  // panels stand where the program puts them
    io.LogFilename = nullptr;
    io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
    io.GetClipboardTextFn = get_clipboard;
    io.SetClipboardTextFn = set_clipboard;
    io.ClipboardUserData = &display_;
    io.MousePos = ImVec2(-1e6F, -1e6F);
    map_keys(io);
    ImGui_ImplOpenGL3_Init(epoxy_is_desktop_gl() ? "#version 330 core" : "#version 300 es");
}

ImGuiAdapter::~ImGuiAdapter() {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui::DestroyContext();
    // Whoever comes next finds no widgets where these were: those of this frame, and of the one before.
    ui::forget_items();
    ui::forget_items();
}

void ImGuiAdapter::load_fonts(double scale) {
    const ivec2 size = display_.size();
    const double ratio =
        size.y > 0 && display_.framebuffer_size().y > 0 ? double(display_.framebuffer_size().y) / size.y : 1;
    if (scale == font_scale_ && ratio == pixel_ratio_) return;
    const bool again = font_scale_ > 0;
    font_scale_ = scale;
    pixel_ratio_ = ratio;
    // Letters are made at the size in pixels that they are shown at, so they are crisp.
    make_fonts(letter_height * scale * ratio);
    ImGui::GetIO().FontGlobalScale = static_cast<float>(1 / ratio);
    apply_theme(scale);
    if (again) {
        ImGui_ImplOpenGL3_DestroyFontsTexture();
        ImGui_ImplOpenGL3_CreateFontsTexture();
    }
}

bool ImGuiAdapter::wants_text() const {
    return ImGui::GetIO().WantTextInput;
}

bool ImGuiAdapter::wants_pointer() const {
    return ImGui::GetIO().WantCaptureMouse;
}

bool ImGuiAdapter::event(const InputEvent& event) {
    ImGuiIO& io = ImGui::GetIO();
    const auto hold = [&](const Modifiers& held) {
        io.KeyShift = held.shift;
        io.KeyCtrl = held.control;
        io.KeyAlt = held.alt;
    };
    // A pointer that nobody sees is over no widget.
    const bool captured = display_.is_pointer_captured();
    if (captured) io.MousePos = ImVec2(-1e6F, -1e6F);
    if (captured && (std::holds_alternative<PointerMove>(event) || std::holds_alternative<ButtonPress>(event) ||
                     std::holds_alternative<WheelTurn>(event)))
        return false;
    if (const auto* const move = std::get_if<PointerMove>(&event)) {
        hold(move->held);
        io.MousePos = ImVec2(static_cast<float>(move->at.x), static_cast<float>(move->at.y));
        const bool world = worlds_[0] || worlds_[1] || worlds_[2];
        return io.WantCaptureMouse && !world;
    }
    if (const auto* const press = std::get_if<ButtonPress>(&event)) {
        hold(press->held);
        const auto i = static_cast<std::size_t>(press->button);
        const bool theirs = press->down ? io.WantCaptureMouse : !worlds_[i];
        worlds_[i] = press->down && !theirs;
        // A drag in the world goes on over panels, which must not see it.
        if (theirs) {
            down_[i] = press->down;
            if (press->down) pressed_now_[i] = true;
        } else {
            down_[i] = false;
            if (press->down) ImGui::SetWindowFocus(nullptr);
        }
        return theirs;
    }
    if (const auto* const wheel = std::get_if<WheelTurn>(&event)) {
        if (!io.WantCaptureMouse) return false;
        io.MouseWheel += static_cast<float>(wheel->by.y);
        io.MouseWheelH += static_cast<float>(wheel->by.x);
        return true;
    }
    if (const auto* const press = std::get_if<KeyPress>(&event)) {
        hold(press->held);
        const bool theirs = press->down && io.WantTextInput;
        io.KeysDown[static_cast<std::size_t>(press->key)] = theirs;
        return theirs;
    }
    if (const auto* const text = std::get_if<TextInput>(&event)) {
        if (!io.WantTextInput) return false;
        io.AddInputCharactersUTF8(text->text.c_str());
        return true;
    }
    if (const auto* const focus = std::get_if<FocusChange>(&event)) {
        io.AddFocusEvent(focus->focused);
        if (!focus->focused) {
            down_ = {};
            worlds_ = {};
        }
    }
    return false;
}

void ImGuiAdapter::begin_frame(double dt) {
    load_fonts(display_.scale());
    ImGuiIO& io = ImGui::GetIO();
    const ivec2 size = display_.size();
    io.DisplaySize = ImVec2(static_cast<float>(size.x), static_cast<float>(size.y));
    io.DisplayFramebufferScale = ImVec2(static_cast<float>(pixel_ratio_), static_cast<float>(pixel_ratio_));
    io.DeltaTime = static_cast<float>(dt > 1e-5 ? dt : 1e-5);
    for (std::size_t i = 0; i < 3; ++i) {
        io.MouseDown[i] = down_[i] || pressed_now_[i];
        pressed_now_[i] = false;
    }
    ImGui_ImplOpenGL3_NewFrame();
    ImGui::NewFrame();
    ui::forget_items();
}

void ImGuiAdapter::end_frame() {
    ImGui::Render();
}

void ImGuiAdapter::paint() {
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

}  // namespace surefoot::view
