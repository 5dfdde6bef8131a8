// Writes the first inputs of fuzz/fuzz_quake3: quake3_seeds fuzz/seeds/fuzz_quake3
#include <cstdio>
#include <fstream>
#include <minizip/zip.h>
#include <string>

#include "quake3_map.hpp"

int main(int argc, char** argv) {
    if (argc != 2) return std::puts("usage: quake3_seeds FOLDER"), 2;
    const std::string folder = argv[1];
    const std::string sample = surefoot::test::sample_map().bytes();
    std::ofstream(folder + "/sample.bsp", std::ios::binary) << sample;
    surefoot::test::MapWriter box;
    box.box(box.texture("clip", 0, surefoot::test::player_clip), {0, 0, 0}, {32, 32, 32});
    std::ofstream(folder + "/box.bsp", std::ios::binary) << box.bytes();
    const std::string bytes = box.bytes();
    const zipFile zip = zipOpen64((folder + "/box.pk3").c_str(), APPEND_STATUS_CREATE);
    const zip_fileinfo no_date{};  // the same bytes every time
    for (const int method : {Z_DEFLATED, 0}) {
        const char* const name = method == 0 ? "maps/stored.bsp" : "maps/packed.bsp";
        zipOpenNewFileInZip64(zip, name, &no_date, nullptr, 0, nullptr, 0, nullptr, method, 9, 0);
        zipWriteInFileInZip(zip, bytes.data(), static_cast<unsigned>(bytes.size()));
        zipCloseFileInZip(zip);
    }
    return zipClose(zip, nullptr) == ZIP_OK ? 0 : 1;
}
