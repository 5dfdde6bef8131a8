#include "view/file_browser.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include "view/widgets.hpp"

namespace surefoot::view {
namespace {

namespace fs = std::filesystem;

std::string size_text(std::uintmax_t bytes) {
    if (bytes < 1000) return fmt::format("{} B", bytes);
    if (bytes < 1000000) return fmt::format("{:.0f} kB", double(bytes) / 1e3);
    return fmt::format("{:.1f} MB", double(bytes) / 1e6);
}

bool ends_so(std::string name, const std::vector<std::string>& endings) {
    std::transform(name.begin(), name.end(), name.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return std::any_of(endings.begin(), endings.end(),
                       [&](const std::string& ending) { return name.ends_with(ending); });
}

}  // namespace

std::vector<FileBrowser::Entry> FileBrowser::list(const std::string& folder, const std::vector<std::string>& endings) {
    std::vector<Entry> entries;
    std::error_code error;
    for (fs::directory_iterator at(folder, fs::directory_options::skip_permission_denied, error), end;
         !error && at != end; at.increment(error)) {
        Entry entry{at->path().filename().string(), false, 0};
        std::error_code ignored;
        if (entry.name.starts_with('.')) continue;
        entry.is_folder = at->is_directory(ignored);
        if (!entry.is_folder) {
            if (!ends_so(entry.name, endings)) continue;
            entry.size = at->file_size(ignored);
        }
        entries.push_back(std::move(entry));
    }
    std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
        return a.is_folder != b.is_folder ? a.is_folder : a.name < b.name;
    });
    return entries;
}

void FileBrowser::open(std::string title, std::vector<std::string> endings, Chosen chosen, const std::string& folder) {
    title_ = std::move(title);
    endings_ = std::move(endings);
    chosen_ = std::move(chosen);
    is_open_ = true;
    std::error_code error;
    go_to(!folder.empty() ? folder : !folder_.empty() ? folder_ : fs::current_path(error).string());
}

void FileBrowser::go_to(const std::string& folder) {
    std::error_code error;
    const fs::path whole = fs::weakly_canonical(folder, error);
    folder_ = error ? folder : whole.string();
    typed_ = folder_;
    entries_ = list(folder_, endings_);
}

void FileBrowser::draw() {
    if (!is_open_) return;
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    const float letter = ImGui::GetFontSize();
    ImGui::SetNextWindowPos({size.x / 2, size.y / 2}, ImGuiCond_Always, {0.5F, 0.5F});
    ImGui::SetNextWindowSize({std::min(letter * 42, size.x - 40), std::min(letter * 30, size.y - 40)});
    bool stays = true;
    ImGui::Begin(title_.c_str(), &stays,
                 ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoResize |
                     ImGuiWindowFlags_NoMove);
    std::string go;
    std::string take;
    if (ui::button("Up")) go = fs::path(folder_).parent_path().string();
    ImGui::SameLine();
    ImGui::SetNextItemWidth(-1);
    if (ImGui::InputText("##path", &typed_, ImGuiInputTextFlags_EnterReturnsTrue)) {
        std::error_code error;
        (fs::is_directory(typed_, error) ? go : take) = typed_;
    }
    ui::item("Path");
    ImGui::BeginChild("entries", {0, -ImGui::GetFrameHeightWithSpacing() - 4}, false);
    for (const Entry& entry : entries_) {
        const std::string shown = entry.is_folder ? entry.name + "/" : entry.name;
        if (ui::row(shown.c_str(), false)) {
            const std::string path = (fs::path(folder_) / entry.name).string();
            (entry.is_folder ? go : take) = path;
        }
        if (entry.is_folder) continue;
        ui::at_right(size_text(entry.size));
    }
    if (entries_.empty()) ui::note("Nothing in this folder can be opened.");
    ImGui::EndChild();
    if (ui::button("Cancel")) stays = false;
    ImGui::SameLine();
    std::string kinds;
    for (const std::string& ending : endings_) kinds += (kinds.empty() ? "" : " ") + ending;
    ImGui::AlignTextToFramePadding();
    ui::note(kinds);
    ImGui::End();
    if (!stays) close();
    if (!go.empty()) go_to(go);
    if (take.empty()) return;
    const Chosen chosen = std::move(chosen_);
    close();
    if (chosen) chosen(take);
}

}  // namespace surefoot::view
