// A tour: a table of contacts and pictures, on a level that nobody prepared.
#include <array>
#include <set>

#include "cli_program.hpp"

#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wsign-conversion"
#endif
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#include <stb/stb_image.h>
#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif

namespace {

struct Picture {
    int width = 0;
    int height = 0;
    std::size_t colours = 0;  ///< how many different ones
};

Picture read_picture(const std::filesystem::path& file) {
    Picture picture;
    int channels = 0;
    unsigned char* const bytes = stbi_load(file.c_str(), &picture.width, &picture.height, &channels, 3);
    if (bytes == nullptr) return picture;
    std::set<std::array<unsigned char, 3>> colours;
    for (int i = 0; i < picture.width * picture.height; ++i)
        colours.insert({bytes[3 * i], bytes[3 * i + 1], bytes[3 * i + 2]});
    stbi_image_free(bytes);
    picture.colours = colours.size();
    return picture;
}

}  // namespace

TEST_F(Cli, a_tour_prints_its_contacts_and_leaves_two_pictures) {
    const std::string out = (folder_ / "pictures").string();
    const Outcome tour = run("tour " + floor_ + " --out " + out + " --size 160x100 --legs 12");
    ASSERT_EQ(tour.code, 0) << tour.err;
    EXPECT_TEXT(tour.out, "drop");
    EXPECT_TEXT(tour.out, "face");
    EXPECT_TEXT(tour.out, "contacts");
    for (const std::string name : {"tour.png", "contact.png"}) {
        const Picture picture = read_picture(std::filesystem::path(out) / name);
        EXPECT_EQ(picture.width, 160);
        EXPECT_EQ(picture.height, 100);
        EXPECT_GT(picture.colours, 500U) << name;
    }
}

TEST_F(Cli, a_tour_is_the_same_every_time) {
    const auto walk = [&] {
        std::string table;
        for (const std::string& line : lines_of(run("tour " + floor_ + " --no-pictures --legs 20").out))
            if (line.rfind("  ", 0) == 0)
                table += line.substr(0, line.find_last_of(' ')) + "\n";  // without the time taken
        return table;
    };
    const std::string first = walk();
    EXPECT_GT(lines_of(first).size(), 10U);
    EXPECT_EQ(first, walk());
}

TEST_F(Cli, a_tour_without_a_place_to_stand_says_so) {
    const std::string wall = write("wall.obj", "v 0 0 0\nv 0 4 0\nv 0 0 4\nf 1 2 3\n");
    const Outcome tour = run("tour " + wall + " --no-pictures");
    EXPECT_EQ(tour.code, 1);
    EXPECT_TEXT(tour.err, "no place where");
}
