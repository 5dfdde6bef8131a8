#include "view/display.hpp"

#include <string_view>

#include "view/gl.hpp"

namespace surefoot::view {
namespace {

std::string gl_text(GLenum name) {
    const GLubyte* const text = glGetString(name);
    return text == nullptr ? std::string() : std::string(reinterpret_cast<const char*>(text));
}

}  // namespace

Expected<std::unique_ptr<Display>> Display::open(const DisplayOptions& options) {
    auto display = options.headless ? open_headless(options) : open_window(options);
    if (!display) return display;
    const int version = epoxy_gl_version();
    const int needed = epoxy_is_desktop_gl() ? 33 : 30;
    if (version < needed) {
        return tl::unexpected(Error{ErrorCode::unsupported,
                                    "this OpenGL is too old (" + gl_description() +
                                        "): OpenGL 3.3 or OpenGL ES 3.0 is needed; a newer driver, or Mesa's software "
                                        "renderer (libgl1-mesa-dri, LIBGL_ALWAYS_SOFTWARE=1), will do",
                                    {},
                                    0});
    }
    return display;
}

std::string gl_description() {
    const std::string version = gl_text(GL_VERSION);
    // ES says "OpenGL ES 3.0 ..." itself.
    return (version.starts_with("OpenGL") ? version : "OpenGL " + version) + ", " + gl_text(GL_RENDERER);
}

bool gl_is_software() {
    const std::string renderer = gl_text(GL_RENDERER);
    return renderer.find("llvmpipe") != std::string::npos || renderer.find("softpipe") != std::string::npos ||
           renderer.find("SwiftShader") != std::string::npos;
}

}  // namespace surefoot::view
