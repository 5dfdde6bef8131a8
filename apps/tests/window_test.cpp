// A real window: under Xvfb, moved by a hand that XTEST leads.
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <string>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <vector>

// clang-format off
// Last, as it makes macros of common words.
#include <X11/Xlib.h>
#include <X11/extensions/XTest.h>
#include <X11/keysym.h>
// clang-format on

namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

pid_t start(std::vector<std::string> words, const std::string& display) {
    const pid_t child = fork();
    if (child != 0) return child;
    if (!display.empty()) setenv("DISPLAY", display.c_str(), 1);
    setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    execvp(arguments[0], arguments.data());
    _exit(127);
}

/// Xvfb on a number of its own, or none if it is not installed.
struct Screen {
    pid_t server = 0;
    std::string name;

    Screen() {
        int ends[2];
        if (pipe(ends) != 0) return;
        server = start(
            {"Xvfb", "-displayfd", std::to_string(ends[1]), "-screen", "0", "1024x768x24", "-nolisten", "tcp"}, {});
        close(ends[1]);
        std::string number;
        char c = 0;
        while (read(ends[0], &c, 1) == 1 && c != '\n') number += c;
        close(ends[0]);
        if (!number.empty()) name = ":" + number;
    }
    ~Screen() {
        if (server <= 0) return;
        kill(server, SIGTERM);
        waitpid(server, nullptr, 0);
    }
};

bool contains_window(Display* display, Window window, const std::string& title) {
    char* name = nullptr;
    if (XFetchName(display, window, &name) != 0 && name != nullptr) {
        const bool same = title == name;
        XFree(name);
        if (same) return true;
    }
    Window root = 0;
    Window parent = 0;
    Window* children = nullptr;
    unsigned count = 0;
    if (XQueryTree(display, window, &root, &parent, &children, &count) == 0) return false;
    bool found = false;
    for (unsigned i = 0; i < count && !found; ++i) found = contains_window(display, children[i], title);
    if (children != nullptr) XFree(children);
    return found;
}

void strike(Display* display, KeySym key) {
    const KeyCode code = XKeysymToKeycode(display, key);
    XTestFakeKeyEvent(display, code, True, 0);
    XFlush(display);
    std::this_thread::sleep_for(300ms);
    XTestFakeKeyEvent(display, code, False, 0);
    XFlush(display);
    std::this_thread::sleep_for(300ms);
}

TEST(Window, a_click_on_the_card_enters_walk_and_its_setting_is_kept) {
    const Screen screen;
    if (screen.name.empty()) GTEST_SKIP() << "Xvfb is not installed";
    const fs::path folder = fs::path(testing::TempDir()) / ("surefoot-window-" + std::to_string(getpid()));
    fs::create_directories(folder);
    const std::string settings = (folder / "settings.json").string();
    const std::string picture = (folder / "last.png").string();
    const pid_t program =
        start({SUREFOOT_PLAYGROUND, "--settings", settings, "--preset", "software", "--size", "800x600", "--level",
               SUREFOOT_LEVELS_DIR "/training-ground.glb", "--screenshot", picture},
              screen.name);
    Display* const display = XOpenDisplay(screen.name.c_str());
    ASSERT_NE(display, nullptr);
    bool there = false;
    for (int i = 0; i < 300 && !there; ++i) {
        std::this_thread::sleep_for(100ms);
        there = contains_window(display, DefaultRootWindow(display), "Surefoot playground");
    }
    EXPECT_TRUE(there);
    std::this_thread::sleep_for(2s);
    // Without a window manager the window lies at the upper left of the screen, and the card of Walk at its lower edge,
    // to the right.
    XTestFakeMotionEvent(display, -1, 576, 500, 0);
    XFlush(display);
    std::this_thread::sleep_for(500ms);
    XTestFakeButtonEvent(display, 1, True, 0);
    XFlush(display);
    std::this_thread::sleep_for(300ms);
    XTestFakeButtonEvent(display, 1, False, 0);
    XFlush(display);
    // The level is remembered once the room has it.
    std::this_thread::sleep_for(6s);
    XSetInputFocus(display, PointerRoot, RevertToPointerRoot, CurrentTime);
    strike(display, XK_F1);
    strike(display, XK_F1);
    kill(program, SIGTERM);
    int status = 0;
    waitpid(program, &status, 0);
    XCloseDisplay(display);
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
    std::ifstream kept(settings);
    const std::string text{std::istreambuf_iterator<char>(kept), std::istreambuf_iterator<char>()};
    EXPECT_NE(text.find("training-ground.glb"), std::string::npos) << text;
    EXPECT_TRUE(fs::exists(picture));
    fs::remove_all(folder);
}

}  // namespace
