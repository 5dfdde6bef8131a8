// Draws the pictures of the docs into a folder, always the same to the last byte.
//
//   make_pictures FOLDER          writes every picture
//   make_pictures --check FOLDER  writes nothing; fails if a picture in FOLDER is missing or not what would be written
#include <cstdio>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>

#include "canvas.hpp"
#include "sheets.hpp"

int main(int count, char** words) {
    const bool only_check = count == 3 && std::string_view(words[1]) == "--check";
    if (count != 2 && !only_check) {
        std::fputs("usage: make_pictures [--check] FOLDER\n", stderr);
        return 2;
    }
    const std::string folder = words[count - 1];
    int wrong = 0;
    for (const auto& sheet : {pictures::memory_pictures(), pictures::navigation_pictures(),
                              pictures::question_pictures(), pictures::method_pictures(), pictures::shape_pictures()}) {
        for (const pictures::Picture& picture : sheet) {
            const std::string path = folder + "/" + std::string(picture.name) + ".svg";
            const std::string drawn = picture.draw();
            if (only_check) {
                std::ifstream file(path, std::ios::binary);
                const std::string there{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
                if (there == drawn) continue;
                std::fprintf(stderr, "%s is not what the program draws: run make_pictures %s and look at it\n",
                             path.c_str(), folder.c_str());
                ++wrong;
            } else {
                std::ofstream file(path, std::ios::binary);
                if (file << drawn << std::flush) continue;
                std::fprintf(stderr, "%s cannot be written\n", path.c_str());
                ++wrong;
            }
        }
    }
    return wrong == 0 ? 0 : 1;
}
