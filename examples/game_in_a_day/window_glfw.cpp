// A window by GLFW and the oldest OpenGL there is, which needs neither shaders nor buffers.
#include <GLFW/glfw3.h>
#include <glm/gtc/type_ptr.hpp>

#include "window.hpp"

namespace day {
namespace {

// [glfw]
class GlfwWindow final : public Window {
public:
    explicit GlfwWindow(GLFWwindow* window) : window_(window) {
        glfwMakeContextCurrent(window);
        glfwSwapInterval(1);
        glfwSetInputMode(window, GLFW_STICKY_KEYS, GLFW_TRUE);  // a short press is not missed by a slow frame
        glEnable(GL_DEPTH_TEST);
        glClearColor(0.62F, 0.78F, 0.92F, 1);
    }
    ~GlfwWindow() override { glfwTerminate(); }

    bool poll(Keys& keys) override {
        glfwPollEvents();
        keys.north = held(GLFW_KEY_W, GLFW_KEY_UP) - held(GLFW_KEY_S, GLFW_KEY_DOWN);
        keys.east = held(GLFW_KEY_D, GLFW_KEY_RIGHT) - held(GLFW_KEY_A, GLFW_KEY_LEFT);
        keys.turn = held(GLFW_KEY_Q) - held(GLFW_KEY_E);
        keys.tilt = held(GLFW_KEY_R) - held(GLFW_KEY_F);
        keys.jump = held(GLFW_KEY_SPACE) > 0;
        keys.save = held(GLFW_KEY_C) > 0;
        keys.restart = held(GLFW_KEY_ENTER) > 0;
        return glfwWindowShouldClose(window_) == 0 && held(GLFW_KEY_ESCAPE) == 0;
    }

    [[nodiscard]] double width_by_height() const override {
        int width = 0, height = 0;
        glfwGetFramebufferSize(window_, &width, &height);
        return height > 0 ? double(width) / height : 1;
    }

    void show(const Scene& scene, const std::string& title) override {
        int width = 0, height = 0;
        glfwGetFramebufferSize(window_, &width, &height);
        glViewport(0, 0, width, height);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        glLoadMatrixd(glm::value_ptr(scene.view_and_projection));
        glBegin(GL_TRIANGLES);
        for (const Drawn& triangle : scene.triangles) {
            glColor3d(triangle.colour.r, triangle.colour.g, triangle.colour.b);
            for (const dvec3& corner : triangle.corners) glVertex3dv(glm::value_ptr(corner));
        }
        glEnd();
        glfwSetWindowTitle(window_, title.c_str());
        glfwSwapBuffers(window_);
    }

private:
    template <typename... Key>
    [[nodiscard]] double held(Key... key) const {
        return ((glfwGetKey(window_, key) == GLFW_PRESS) || ...) ? 1 : 0;
    }

    GLFWwindow* window_;
};
// [/glfw]

}  // namespace

std::unique_ptr<Window> Window::open() {
    if (glfwInit() == 0) return nullptr;
    glfwWindowHint(GLFW_SAMPLES, 4);
    GLFWwindow* const window = glfwCreateWindow(1280, 720, "A game in a day", nullptr, nullptr);
    if (window == nullptr) return glfwTerminate(), nullptr;
    return std::make_unique<GlfwWindow>(window);
}

}  // namespace day
