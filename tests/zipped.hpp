/// Writes zip files, such as a .pk3 is. For targets that link minizip.
#pragma once

#include <gtest/gtest.h>
#include <minizip/zip.h>
#include <string>
#include <utility>
#include <vector>

namespace surefoot::test {

using Files = std::vector<std::pair<std::string, std::string>>;

inline std::string zipped(const std::string& path, const Files& files) {
    const zipFile zip = zipOpen64(path.c_str(), APPEND_STATUS_CREATE);
    EXPECT_NE(zip, nullptr);
    for (std::size_t i = 0; i < files.size(); ++i) {
        const int method = i % 2 == 0 ? Z_DEFLATED : 0;  // packed, and merely stored
        EXPECT_EQ(
            zipOpenNewFileInZip64(zip, files[i].first.c_str(), nullptr, nullptr, 0, nullptr, 0, nullptr, method, 6, 0),
            ZIP_OK);
        EXPECT_EQ(zipWriteInFileInZip(zip, files[i].second.data(), static_cast<unsigned>(files[i].second.size())),
                  ZIP_OK);
        EXPECT_EQ(zipCloseFileInZip(zip), ZIP_OK);
    }
    EXPECT_EQ(zipClose(zip, nullptr), ZIP_OK);
    return path;
}

}  // namespace surefoot::test
