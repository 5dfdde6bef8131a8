#include <filesystem>

#include <surefoot/import.hpp>

#include "playground/room.hpp"

namespace surefoot::playground {

void Stage::open_level(const std::string& path, const LevelLoader::Done& done) {
    // What cannot be listed is not read either: then loading says why.
    const auto maps = maps_in(path);
    if (maps && maps->size() > 1) {
        const std::string name = std::filesystem::path(path).filename().string();
        chooser.open("Maps in " + name, *maps, [this, path, done](const std::string& map) {
            level = path + ":" + map;
            open_level(level, done);
        });
        return;
    }
    levels.load(
        path,
        [this, path, done](const LevelLoader::Loaded& loaded) {
            std::error_code error;
            const std::filesystem::path whole = std::filesystem::absolute(path, error);
            settings.remember_level(error ? path : whole.lexically_normal().string());
            done(loaded);
        },
        [this](const std::string& why) { toasts.warn(why); });
}

void Stage::browse_for_level(const LevelLoader::Done& done) {
    chooser.close();
    browser.open("Open a level",
                 {".surefoot", ".obj", ".gltf", ".glb", ".ply", ".stl", ".ac", ".blend", ".bsp", ".pk3"},
                 [this, done](const std::string& path) { open_level(path, done); });
}

void Stage::close_dialogs() {
    browser.close();
    chooser.close();
}

void Stage::forget_pending() {
    close_dialogs();
    levels.forget();
}

}  // namespace surefoot::playground
