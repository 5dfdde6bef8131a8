#include "playground/walk/keeping.hpp"

#include <filesystem>
#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include "view/widgets.hpp"

namespace surefoot::playground {

std::string Keeping::file_for(const char* kind, view::Toasts& toasts) {
    if (!file_.empty()) return file_;
    if (folder_.empty()) {
        toasts.warn("Say first which file it is to be saved in.");
        return {};
    }
    std::error_code error;
    std::filesystem::create_directories(folder_, error);  // writing says what is wrong with it
    for (int i = 1;; ++i) {
        const std::filesystem::path path = std::filesystem::path(folder_) / fmt::format("{}-{}.json", kind, i);
        if (!std::filesystem::exists(path, error)) return path.string();
    }
}

void Keeping::tell(const Expected<void>& written, const std::string& file, const std::string& how,
                   view::Toasts& toasts) {
    if (!written) {
        toasts.warn(written.error().text);
        return;
    }
    std::error_code error;
    const auto whole = std::filesystem::absolute(file, error);
    toasts.say(fmt::format("Saved: {}\n{}", error ? file : whole.lexically_normal().string(), how));
    file_.clear();  // the next one is another
}

void Keeping::save_moment(const Walker& walker, view::Toasts& toasts) {
    const auto moment = walker.moment();
    if (!moment) {
        toasts.warn("No step was made yet.");
        return;
    }
    const std::string file = file_for("step", toasts);
    if (!file.empty()) tell(write_capture(*moment, file), file, "`surefoot replay` makes this step again.", toasts);
}

void Keeping::save_session(const Walker& walker, const std::string& level, view::Toasts& toasts) {
    if (walker.ticks() == 0) {
        toasts.warn("No step was made yet.");
        return;
    }
    const std::string file = file_for("session", toasts);
    if (file.empty()) return;
    const std::string name = std::filesystem::path(level).filename().string();
    tell(write_session(walker.session(), file), file,
         fmt::format("{} steps; `surefoot replay FILE --level {}` makes them again.", walker.ticks(), name), toasts);
}

void Keeping::ui(const Walker& walker, const std::string& level, view::Toasts& toasts) {
    namespace ui = view::ui;
    ImGui::SetNextItemWidth(-1);
    ImGui::InputTextWithHint("##file", folder_.empty() ? "file.json" : "file.json, or beside the settings", &file_);
    ui::item("File");
    if (ui::button("Save this moment (M)")) save_moment(walker, toasts);
    ui::hint("The step that led here, its triangles, its settings and its story in one small file.");
    if (ui::button("Save the session")) save_session(walker, level, toasts);
    ui::hint("All inputs of the last 20 seconds, with a hash a tick: any build can make the same steps.");
}

}  // namespace surefoot::playground
