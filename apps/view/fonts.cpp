#include "view/fonts.hpp"

#include <filesystem>
#include <imgui.h>
#include <string>
#include <vector>

namespace surefoot::view {
namespace {

Fonts made;

/// Where distributions put the DejaVu fonts.
const char* const folders[] = {"/usr/share/fonts/truetype/dejavu", "/usr/share/fonts/dejavu-sans-fonts",
                               "/usr/share/fonts/TTF", "/usr/local/share/fonts"};

ImFont* add(const char* name, float height) {
    // Latin, Greek for the mathematics, arrows and the few signs that texts here use.
    static const ImWchar ranges[] = {0x20,   0xFF,   0x0391, 0x03C9, 0x2010, 0x2026, 0x2032,
                                     0x2033, 0x207B, 0x207F, 0x2070, 0x2089, 0x2190, 0x21FF,
                                     0x2202, 0x22C5, 0x2713, 0x2717, 0x25A0, 0x25FF, 0};
    ImGuiIO& io = ImGui::GetIO();
    for (const char* folder : folders) {
        const std::string path = std::string(folder) + "/" + name;
        std::error_code error;
        if (std::filesystem::exists(path, error))
            return io.Fonts->AddFontFromFileTTF(path.c_str(), height, nullptr, ranges);
    }
    ImFontConfig config;
    config.SizePixels = height;
    return io.Fonts->AddFontDefault(&config);
}

}  // namespace

void make_fonts(double height) {
    ImGui::GetIO().Fonts->Clear();
    const auto size = static_cast<float>(static_cast<int>(height + 0.5));
    made.plain = add("DejaVuSans.ttf", size);
    made.large = add("DejaVuSans-Bold.ttf", static_cast<float>(static_cast<int>(height * 1.75 + 0.5)));
    made.mono = add("DejaVuSansMono.ttf", size);
}

const Fonts& fonts() {
    return made;
}

}  // namespace surefoot::view
