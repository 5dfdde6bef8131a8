#include "view/settings.hpp"

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>

namespace surefoot::view {
namespace {

namespace fs = std::filesystem;

class SettingsFile : public testing::Test {
protected:
    void SetUp() override {
        folder_ = fs::path(testing::TempDir()) /
                  ("surefoot-settings-" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
        fs::remove_all(folder_);
    }
    void TearDown() override { fs::remove_all(folder_); }
    [[nodiscard]] std::string path() const { return (folder_ / "below" / "playground.json").string(); }
    void put(const std::string& text) const {
        fs::create_directories(folder_ / "below");
        std::ofstream(path()) << text;
    }

private:
    fs::path folder_;
};

TEST_F(SettingsFile, comes_back_as_it_was_kept) {
    Settings settings;
    settings.width = 1600;
    settings.preset = "software";
    settings.field_of_view = 75;
    settings.remember_level("a.obj");
    settings.remember_level("b.obj");
    settings.remember_level("a.obj");
    ASSERT_TRUE(write_settings(settings, path()));
    EXPECT_EQ(read_settings(path()).value(), settings);
    EXPECT_EQ(settings.recent, (std::vector<std::string>{"a.obj", "b.obj"}));
}

TEST_F(SettingsFile, that_is_not_there_gives_the_defaults) {
    EXPECT_EQ(read_settings(path()).value(), Settings{});
}

TEST_F(SettingsFile, that_is_damaged_is_reported_and_then_replaced) {
    put("{\"width\": 16");
    const auto read = read_settings(path());
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error().code, ErrorCode::unreadable);
    EXPECT_NE(read.error().text.find(path()), std::string::npos);
    ASSERT_TRUE(write_settings({}, path()));
    EXPECT_TRUE(read_settings(path()));
}

TEST_F(SettingsFile, with_values_out_of_range_or_of_another_kind_gives_defaults_for_those) {
    put(R"({"width": -5, "height": "tall", "preset": "best", "field_of_view": 1e9, "recent": [1, "x.obj"]})");
    const Settings read = read_settings(path()).value();
    EXPECT_EQ(read.width, Settings{}.width);
    EXPECT_EQ(read.height, Settings{}.height);
    EXPECT_EQ(read.preset, "");
    EXPECT_EQ(read.field_of_view, Settings{}.field_of_view);
    EXPECT_EQ(read.recent, std::vector<std::string>{"x.obj"});
}

TEST_F(SettingsFile, leaves_nothing_else_in_its_folder) {
    ASSERT_TRUE(write_settings({}, path()));
    ASSERT_TRUE(write_settings({}, path()));
    const fs::directory_iterator files(fs::path(path()).parent_path());
    EXPECT_EQ(std::distance(begin(files), end(files)), 1);
}

TEST_F(SettingsFile, that_cannot_be_written_says_so) {
    put("{}");
    EXPECT_FALSE(write_settings({}, path() + "/inside/a/file.json"));
}

}  // namespace
}  // namespace surefoot::view
