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
#include <X11/Xatom.h>
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

/// The window with this title, or 0.
Window find_window(Display* display, Window window, const std::string& title) {
    char* name = nullptr;
    if (XFetchName(display, window, &name) != 0 && name != nullptr) {
        const bool same = title == name;
        XFree(name);
        if (same) return window;
    }
    Window root = 0;
    Window parent = 0;
    Window* children = nullptr;
    unsigned count = 0;
    if (XQueryTree(display, window, &root, &parent, &children, &count) == 0) return 0;
    Window found = 0;
    for (unsigned i = 0; i < count && found == 0; ++i) found = find_window(display, children[i], title);
    if (children != nullptr) XFree(children);
    return found;
}

Window wait_for_window(Display* display) {
    Window found = 0;
    for (int i = 0; i < 300 && found == 0; ++i) {
        std::this_thread::sleep_for(100ms);
        found = find_window(display, DefaultRootWindow(display), "Surefoot playground");
    }
    std::this_thread::sleep_for(2s);
    return found;
}

std::string size_of(Display* display, Window window) {
    XWindowAttributes attributes{};
    if (window == 0 || XGetWindowAttributes(display, window, &attributes) == 0) return "no window";
    return std::to_string(attributes.width) + "x" + std::to_string(attributes.height);
}

/// Waits until the window is that large.
std::string size_that_comes(Display* display, Window window, const std::string& wanted) {
    for (int i = 0; i < 100 && size_of(display, window) != wanted; ++i) std::this_thread::sleep_for(100ms);
    return size_of(display, window);
}

bool ends_well(pid_t program) {
    kill(program, SIGTERM);
    int status = 0;
    waitpid(program, &status, 0);
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

std::string text_of(const std::string& path) {
    std::ifstream file(path);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

fs::path fresh_folder(const std::string& name) {
    fs::path folder = fs::path(testing::TempDir()) / ("surefoot-" + name + "-" + std::to_string(getpid()));
    fs::create_directories(folder);
    return folder;
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
    const fs::path folder = fresh_folder("window");
    const std::string settings = (folder / "settings.json").string();
    const std::string picture = (folder / "last.png").string();
    const pid_t program =
        start({SUREFOOT_PLAYGROUND, "--settings", settings, "--preset", "software", "--size", "800x600", "--level",
               SUREFOOT_LEVELS_DIR "/training-ground.glb", "--screenshot", picture},
              screen.name);
    Display* const display = XOpenDisplay(screen.name.c_str());
    ASSERT_NE(display, nullptr);
    EXPECT_NE(wait_for_window(display), 0U);
    // Without a window manager the window lies at the upper left of the screen, and the card of Walk in its lower row
    // of two, at the left.
    XTestFakeMotionEvent(display, -1, 224, 500, 0);
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
    EXPECT_TRUE(ends_well(program));
    XCloseDisplay(display);
    const std::string text = text_of(settings);
    EXPECT_NE(text.find("training-ground.glb"), std::string::npos) << text;
    EXPECT_TRUE(fs::exists(picture));
    fs::remove_all(folder);
}

TEST(Window, f11_fills_the_screen_and_goes_back_and_is_remembered) {
    const Screen screen;
    if (screen.name.empty()) GTEST_SKIP() << "Xvfb is not installed";
    const fs::path folder = fresh_folder("full-screen");
    const std::string settings = (folder / "settings.json").string();
    const auto open = [&] { return start({SUREFOOT_PLAYGROUND, "--settings", settings}, screen.name); };
    std::ofstream(settings) << R"({"width": 640, "height": 480, "preset": "software"})";
    Display* const display = XOpenDisplay(screen.name.c_str());
    ASSERT_NE(display, nullptr);
    pid_t program = open();
    Window window = wait_for_window(display);
    EXPECT_EQ(size_of(display, window), "640x480");
    XSetInputFocus(display, window, RevertToPointerRoot, CurrentTime);
    strike(display, XK_F11);
    EXPECT_EQ(size_that_comes(display, window, "1024x768"), "1024x768");
    strike(display, XK_F11);
    EXPECT_EQ(size_that_comes(display, window, "640x480"), "640x480");
    strike(display, XK_F11);
    EXPECT_EQ(size_that_comes(display, window, "1024x768"), "1024x768");
    EXPECT_TRUE(ends_well(program));
    const std::string text = text_of(settings);
    EXPECT_NE(text.find("\"full_screen\": true"), std::string::npos) << text;
    EXPECT_NE(text.find("640"), std::string::npos) << "how large the window was is kept: " << text;
    program = open();
    window = wait_for_window(display);
    EXPECT_EQ(size_that_comes(display, window, "1024x768"), "1024x768");
    XSetInputFocus(display, window, RevertToPointerRoot, CurrentTime);
    strike(display, XK_F11);
    EXPECT_EQ(size_that_comes(display, window, "640x480"), "640x480");
    EXPECT_TRUE(ends_well(program));
    XCloseDisplay(display);
    fs::remove_all(folder);
}

TEST(Window, on_a_screen_of_twice_the_scale_it_is_twice_as_large_and_stays_so) {
    const Screen screen;
    if (screen.name.empty()) GTEST_SKIP() << "Xvfb is not installed";
    const fs::path folder = fresh_folder("scale");
    const std::string settings = (folder / "settings.json").string();
    const std::string picture = (folder / "last.png").string();
    std::ofstream(settings) << R"({"width": 400, "height": 300, "preset": "software"})";
    Display* const display = XOpenDisplay(screen.name.c_str());
    ASSERT_NE(display, nullptr);
    // Where desktops write the resolution that they want letters to have: 96 is once.
    const std::string resources = "Xft.dpi:\t192\n";
    XChangeProperty(display, DefaultRootWindow(display), XA_RESOURCE_MANAGER, XA_STRING, 8, PropModeReplace,
                    reinterpret_cast<const unsigned char*>(resources.data()), static_cast<int>(resources.size()));
    XSync(display, False);
    for (int opened = 0; opened < 2; ++opened) {
        const pid_t program =
            start({SUREFOOT_PLAYGROUND, "--settings", settings, "--screenshot", picture}, screen.name);
        const Window window = wait_for_window(display);
        EXPECT_EQ(size_of(display, window), "800x600") << opened;
        EXPECT_TRUE(ends_well(program));
        EXPECT_TRUE(fs::exists(picture));
        const std::string text = text_of(settings);
        EXPECT_NE(text.find("\"width\": 400"), std::string::npos) << text;
        EXPECT_NE(text.find("\"height\": 300"), std::string::npos) << text;
    }
    XCloseDisplay(display);
    fs::remove_all(folder);
}

}  // namespace
