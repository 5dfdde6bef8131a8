// Writing a file over another one: a full disk, a kill at any moment and two writers at once leave a whole file there.
#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <gtest/gtest.h>
#include <set>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

#include <surefoot/whole_file.hpp>

#include "file_things.hpp"
#include "platform/atomic_file.hpp"
#include "platform/folders.hpp"

namespace surefoot::tests {
namespace {

using Writing = FileTest;

TEST_F(Writing, a_full_disk_leaves_the_old_file_whole) {
    const Mesh small = cooked(hills(2)).mesh;
    const Mesh large = cooked(hills(40)).mesh;
    ASSERT_TRUE(small.write(path("level.surefoot")).has_value());
    const Bytes old = read_bytes(path("level.surefoot"));
    // In a child, because a limit on the size of files is for the whole process.
    const pid_t child = fork();
    if (child == 0) {
        std::signal(SIGXFSZ, SIG_IGN);
        const rlimit limit{20000, 20000};
        setrlimit(RLIMIT_FSIZE, &limit);
        const auto written = large.write(path("level.surefoot"));
        _exit(!written && written.error().code == ErrorCode::write_failed &&
                      written.error().text.find("room") != std::string::npos
                  ? 0
                  : 1);
    }
    int status = 0;
    waitpid(child, &status, 0);
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
    EXPECT_EQ(read_bytes(path("level.surefoot")), old);
    EXPECT_EQ(file_count(), 1U) << "what was begun is removed again";
}

TEST_F(Writing, a_kill_at_any_moment_leaves_a_whole_file) {
    const Mesh one = cooked(hills(10)).mesh;
    const Mesh two = cooked(hills(30)).mesh;
    ASSERT_TRUE(one.write(path("level.surefoot")).has_value());
    SplitMix random(11);
    std::set<std::size_t> seen;
    int killed = 0;
    for (int i = 0; i < 60; ++i) {
        const pid_t child = fork();
        if (child == 0) {
            for (int k = 0;; ++k) static_cast<void>((k % 2 == 0 ? two : one).write(path("level.surefoot")));
        }
        usleep(static_cast<useconds_t>(200 + random.next() % 4000));
        kill(child, SIGKILL);
        int status = 0;
        waitpid(child, &status, 0);
        killed += WIFSIGNALED(status) ? 1 : 0;
        const auto opened = Mesh::open(path("level.surefoot"), Check::everything);
        ASSERT_TRUE(opened.has_value()) << opened.error().text;
        seen.insert(opened->triangle_count());
    }
    EXPECT_EQ(killed, 60);
    for (const std::size_t count : seen) EXPECT_TRUE(count == one.triangle_count() || count == two.triangle_count());
}

TEST_F(Writing, two_writers_at_once_leave_the_whole_file_of_one_of_them) {
    const Mesh one = cooked(hills(10)).mesh;
    const Mesh two = cooked(hills(20)).mesh;
    const auto write_often = [&](const Mesh& mesh) {
        for (int i = 0; i < 30; ++i) EXPECT_TRUE(mesh.write(path("level.surefoot")).has_value());
    };
    const pid_t child = fork();  // another process
    if (child == 0) {
        bool good = true;
        for (int i = 0; i < 30; ++i) good = two.write(path("level.surefoot")).has_value() && good;
        _exit(good ? 0 : 1);
    }
    std::thread other([&] { write_often(two); });  // and another thread
    write_often(one);
    other.join();
    int status = 0;
    waitpid(child, &status, 0);
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
    const auto opened = Mesh::open(path("level.surefoot"), Check::everything);
    ASSERT_TRUE(opened.has_value()) << opened.error().text;
    EXPECT_EQ(file_count(), 1U);
}

TEST_F(Writing, a_mapped_mesh_goes_on_answering_when_its_file_is_replaced) {
    ASSERT_TRUE(cooked(hills(10)).mesh.write(path("level.surefoot")).has_value());
    const auto before = Mesh::open(path("level.surefoot"));
    ASSERT_TRUE(before.has_value());
    const std::uint64_t answers = ask_everything(*before, 1, 50);
    ASSERT_TRUE(cooked(hills(3)).mesh.write(path("level.surefoot")).has_value());
    EXPECT_EQ(ask_everything(*before, 1, 50), answers);
    EXPECT_EQ(Mesh::open(path("level.surefoot"))->triangle_count(), 18U);
}

TEST_F(Writing, what_is_no_plain_file_is_not_replaced) {
    const Mesh mesh = cooked(hills(2)).mesh;
    ASSERT_EQ(mkfifo(path("pipe").c_str(), 0600), 0);
    for (const std::string& target : {path("pipe"), folder_.string(), path("nowhere/level.surefoot"), std::string()}) {
        const auto written = mesh.write(target);
        ASSERT_FALSE(written.has_value()) << target;
        EXPECT_EQ(written.error().code, ErrorCode::write_failed);
    }
    EXPECT_EQ(Mesh::open(path("pipe")).error().code, ErrorCode::unreadable);
    EXPECT_EQ(file_count(), 1U);
}

TEST_F(Writing, what_is_not_committed_never_was) {
    {
        auto file = internal::AtomicFile::create(path("draft"));
        ASSERT_TRUE(file.has_value());
        ASSERT_TRUE(file->write(std::as_bytes(std::span("text"))).has_value());
        EXPECT_EQ(file_count(), 1U);
    }
    EXPECT_EQ(file_count(), 0U);
}

std::span<const std::byte> text_of(std::string_view text) {
    return std::as_bytes(std::span(text));
}

TEST_F(Writing, a_whole_file_is_what_was_written_last) {
    ASSERT_TRUE(write_whole_file(path("own"), text_of("the old one, and longer")).has_value());
    ASSERT_TRUE(write_whole_file(path("own"), text_of("the new one")).has_value());
    const Bytes bytes = read_bytes(path("own"));
    EXPECT_EQ(std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size()), "the new one");
    ASSERT_TRUE(write_whole_file(path("own"), {}).has_value());
    EXPECT_TRUE(read_bytes(path("own")).empty());
    EXPECT_EQ(file_count(), 1U);
}

// In a child, because what a process may do is for the whole process. True if writing fails and says this.
template <typename Restrict>
bool fails_in_a_child(const std::string& path, std::string_view says, const Restrict& restrict_self) {
    const pid_t child = fork();
    if (child == 0) {
        restrict_self();
        const std::string large(100000, 'x');
        const auto written = write_whole_file(path, text_of(large));
        _exit(!written && written.error().code == ErrorCode::write_failed && written.error().file == path &&
                      written.error().text.find(says) != std::string::npos
                  ? 0
                  : 1);
    }
    int status = 0;
    waitpid(child, &status, 0);
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

TEST_F(Writing, without_room_the_old_whole_file_stays) {
    ASSERT_TRUE(write_whole_file(path("own"), text_of("the old one")).has_value());
    const Bytes old = read_bytes(path("own"));
    EXPECT_TRUE(fails_in_a_child(path("own"), "File too large", [] {
        std::signal(SIGXFSZ, SIG_IGN);
        const rlimit limit{20000, 20000};
        setrlimit(RLIMIT_FSIZE, &limit);
    }));
    EXPECT_EQ(read_bytes(path("own")), old);
    EXPECT_EQ(file_count(), 1U) << "what was begun is removed again";
}

TEST_F(Writing, without_permission_the_old_whole_file_stays) {
    ASSERT_TRUE(write_whole_file(path("own"), text_of("the old one")).has_value());
    const Bytes old = read_bytes(path("own"));
    ASSERT_EQ(chmod(folder_.c_str(), 0555), 0);
    // Whoever may do everything becomes nobody first.
    EXPECT_TRUE(fails_in_a_child(path("own"), "Permission denied", [] {
        constexpr uid_t nobody = 65534;
        if (geteuid() == 0 && setuid(nobody) != 0) _exit(2);
    }));
    ASSERT_EQ(chmod(folder_.c_str(), 0755), 0);
    EXPECT_EQ(read_bytes(path("own")), old);
    EXPECT_EQ(file_count(), 1U);
}

TEST_F(Writing, a_whole_file_needs_its_folder_and_replaces_plain_files_only) {
    EXPECT_EQ(write_whole_file(path("nowhere/own"), text_of("x")).error().code, ErrorCode::write_failed);
    EXPECT_EQ(write_whole_file(folder_.string(), text_of("x")).error().code, ErrorCode::write_failed);
    EXPECT_EQ(file_count(), 0U);
}

class Environment {
public:
    explicit Environment(const char* name) : name_(name), old_(std::getenv(name) ? std::getenv(name) : "") {}
    ~Environment() { setenv(name_, old_.c_str(), 1); }
    void set(const std::string& value) const { setenv(name_, value.c_str(), 1); }

private:
    const char* name_;
    std::string old_;
};

TEST_F(Writing, the_cache_is_where_the_environment_says) {
    const Environment cache("XDG_CACHE_HOME");
    const Environment home("HOME");
    cache.set("/c");
    EXPECT_EQ(internal::cache_folder(), "/c/surefoot");
    cache.set("relative");
    home.set("/h");
    EXPECT_EQ(internal::cache_folder(), "/h/.cache/surefoot");
    home.set("");
    EXPECT_EQ(internal::cache_folder(), "");
    EXPECT_FALSE(open_cached(5).has_value());
}

TEST_F(Writing, what_is_kept_in_the_cache_is_found_by_what_it_was_made_from) {
    const Environment cache("XDG_CACHE_HOME");
    cache.set(path("deep/cache"));
    const Mesh mesh = cooked(hills(3), {.made_from = 42}).mesh;
    EXPECT_FALSE(open_cached(42).has_value());
    const auto written = write_cached(mesh);
    ASSERT_TRUE(written.has_value()) << written.error().text;
    const auto found = open_cached(42);
    ASSERT_TRUE(found.has_value()) << found.error().text;
    EXPECT_EQ(found->triangle_count(), 18U);
    EXPECT_FALSE(open_cached(43).has_value());
    std::filesystem::copy_file(cache_path(42), cache_path(43));
    EXPECT_FALSE(open_cached(43).has_value());
}

}  // namespace
}  // namespace surefoot::tests
