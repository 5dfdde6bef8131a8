/// Runs the program `surefoot` as a person would, and makes the small levels that it is asked about.
#pragma once

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

struct Outcome {
    int code = -1;
    std::string out;
    std::string err;
};

inline std::string read_text(const std::filesystem::path& file) {
    std::ifstream input(file, std::ios::binary);
    std::stringstream text;
    text << input.rdbuf();
    return text.str();
}

inline std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream input(text);
    for (std::string line; std::getline(input, line);) lines.push_back(line);
    return lines;
}

/// A folder of its own for each test, with a floor to stand on.
class Cli : public testing::Test {
protected:
    void SetUp() override {
        const auto* const test = testing::UnitTest::GetInstance()->current_test_info();
        folder_ =
            std::filesystem::temp_directory_path() / ("surefoot-cli-" + std::to_string(getpid()) + "-" + test->name());
        std::filesystem::create_directories(folder_);
        // A floor of 20 x 20 m at y = 0, and a wall at x = 5 that faces the middle.
        floor_ = write("floor.obj",
                       "v -10 0 -10\nv 10 0 -10\nv 10 0 10\nv -10 0 10\n"
                       "v 5 0 -10\nv 5 0 10\nv 5 4 10\nv 5 4 -10\n"
                       "usemtl stone\nf 1 4 3\nf 1 3 2\nusemtl brick\nf 5 6 7\nf 5 7 8\n");
    }

    void TearDown() override { std::filesystem::remove_all(folder_); }

    std::string write(const std::string& name, const std::string& text) const {
        const std::filesystem::path file = folder_ / name;
        std::ofstream(file, std::ios::binary) << text;
        return file.string();
    }

    /// `arguments` as a shell takes them, `input` on standard input.
    Outcome run(const std::string& arguments, const std::string& input = "") const {
        const std::string in = write("stdin", input);
        const std::string out = (folder_ / "stdout").string();
        const std::string err = (folder_ / "stderr").string();
        const std::string command = "XDG_CACHE_HOME='" + (folder_ / "cache").string() + "' '" SUREFOOT_PROGRAM "' " +
                                    arguments + " <'" + in + "' >'" + out + "' 2>'" + err + "'";
        const int status = std::system(command.c_str());
        return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read_text(out), read_text(err)};
    }

    std::filesystem::path folder_;
    std::string floor_;
};

#define EXPECT_TEXT(text, part) EXPECT_NE((text).find(part), std::string::npos) << "in: " << (text)
