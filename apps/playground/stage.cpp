#include <filesystem>

#include "playground/room.hpp"

namespace surefoot::playground {

void Stage::open_level(const std::string& path, const LevelLoader::Done& done) {
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
    browser.open("Open a level",
                 {".surefoot", ".obj", ".gltf", ".glb", ".ply", ".stl", ".ac", ".blend", ".bsp", ".pk3"},
                 [this, done](const std::string& path) { open_level(path, done); });
}

void Stage::forget_pending() {
    browser.close();
    levels.forget();
}

}  // namespace surefoot::playground
