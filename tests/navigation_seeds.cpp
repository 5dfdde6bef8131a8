// Writes the seeds of fuzz/fuzz_navigation: sections of small meshes behind the bytes that choose the questions.
#include <cstdio>
#include <fstream>
#include <string>

#include "navigation_scene.hpp"

namespace {

using namespace surefoot;
using namespace surefoot::tests;

void write(const std::string& path, const NavigationMesh& mesh) {
    const std::vector<std::byte> bytes = mesh.to_bytes();
    std::ofstream out(path, std::ios::binary);
    for (int i = 0; i < 32; ++i) out.put(static_cast<char>(37 * i));
    out.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
}

}  // namespace

int main(int count, char** arguments) {
    if (count != 2) {
        std::fputs("usage: navigation_seeds FOLDER\n", stderr);
        return 2;
    }
    const std::string folder = arguments[1];
    write(folder + "/floor", built(Scene().floor(0, 4, 0, 4).world()));
    write(folder + "/two_tiles", built(Scene().floor(0, 10, 0, 4).world()));
    write(folder + "/wall", built(Scene().floor(0, 6, 0, 6).block({2, 0, 2}, {4, 3, 4}).world()));
    write(folder + "/yard", built_yard());
    NavigationMesh drop = built(Scene().floor(0, 6, 0, 6).block({0, 0, 0}, {6, 2, 2.5}).world());
    const std::array<NavigationLink, 2> links{
        NavigationLink{.from = {3, 2, 2}, .to = {3, 0, 4}, .inputs = {{.wish = {0, 0, 3}, .ticks = 40}}},
        {.from = {1, 2, 2}, .to = {1, 0, 4}, .kind = NavigationLinkKind::jump, .inputs = {{.ticks = 9, .jump = 1}}}};
    if (drop.set_links(links).value_or(9) != 0) return 1;
    write(folder + "/drop", drop);
    NavigationOptions tilted = quick();
    tilted.up = {1, 0, 0};
    write(folder + "/up_x", built(Scene().quad({0, 0, 0}, {0, 4, 0}, {0, 4, 4}, {0, 0, 4}).world(), tilted));
    return 0;
}
