// A display without a display: an EGL context without a surface, and a framebuffer object to draw into.
#include <epoxy/egl.h>

#include "view/display.hpp"
#include "view/gl.hpp"

namespace surefoot::view {
namespace {

tl::unexpected<Error> failed(const std::string& what) {
    return tl::unexpected(Error{ErrorCode::unsupported,
                                "no OpenGL without a display here (" + what +
                                    "): on Debian, install libegl1 and libgl1-mesa-dri, Mesa's software renderer",
                                {},
                                0});
}

class Headless final : public Display {
public:
    Headless(EGLDisplay display, EGLContext context) : display_(display), context_(context) {}

    ~Headless() override {
        colour_ = {};
        depth_ = {};
        target_ = {};
        eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        eglDestroyContext(display_, context_);
        // The EGL display belongs to the process: another context of it may live.
    }

    void poll(std::vector<InputEvent>& events, double /*seconds*/) override {
        events.insert(events.end(), pending_.begin(), pending_.end());
        pending_.clear();
    }
    void present() override { glFlush(); }
    void set_full_screen(bool full) override { full_screen_ = full; }
    void capture_pointer(bool captured) override { captured_ = captured; }
    [[nodiscard]] std::string clipboard() const override { return clipboard_; }
    void set_clipboard(const std::string& text) override { clipboard_ = text; }

    void resize(const ivec2& size) override {
        if (size == size_) return;
        make_framebuffer(size);
        pending_.emplace_back(Resize{size_, framebuffer_size_});
    }

    void make_framebuffer(const ivec2& size) {
        size_ = framebuffer_size_ = size;
        colour_ = gl::colour_texture(size);
        depth_ = gl::depth_texture(size);
        target_ = gl::framebuffer_of(&colour_, &depth_);
        framebuffer_ = target_.id();
    }

    void set_scale(double scale) { scale_ = scale; }

private:
    EGLDisplay display_;
    EGLContext context_;
    gl::Texture colour_;
    gl::Texture depth_;
    gl::Framebuffer target_;
    std::vector<InputEvent> pending_;
    std::string clipboard_;
};

EGLContext make_context(EGLDisplay display, GlApi api) {
    const bool es = api == GlApi::es;
    if (eglBindAPI(es ? EGL_OPENGL_ES_API : EGL_OPENGL_API) == EGL_FALSE) return EGL_NO_CONTEXT;
    const EGLint wanted[] = {EGL_SURFACE_TYPE, 0, EGL_RENDERABLE_TYPE, es ? EGL_OPENGL_ES3_BIT : EGL_OPENGL_BIT,
                             EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (eglChooseConfig(display, wanted, &config, 1, &count) == EGL_FALSE || count == 0) return EGL_NO_CONTEXT;
    const EGLint core[] = {
        EGL_CONTEXT_MAJOR_VERSION,           3,       EGL_CONTEXT_MINOR_VERSION, 3, EGL_CONTEXT_OPENGL_PROFILE_MASK,
        EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
    const EGLint embedded[] = {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 0, EGL_NONE};
    return eglCreateContext(display, config, EGL_NO_CONTEXT, es ? embedded : core);
}

}  // namespace

Expected<std::unique_ptr<Display>> open_headless(const DisplayOptions& options) {
    if (!epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless"))
        return failed("EGL knows no surfaceless platform");
    EGLDisplay display = eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (display == EGL_NO_DISPLAY || eglInitialize(display, nullptr, nullptr) == EGL_FALSE)
        return failed("EGL does not start");
    EGLContext context = EGL_NO_CONTEXT;
    for (const GlApi api : {GlApi::core, GlApi::es})
        if (context == EGL_NO_CONTEXT && (options.api == GlApi::any || options.api == api))
            context = make_context(display, api);
    if (context == EGL_NO_CONTEXT) return failed("neither OpenGL 3.3 nor OpenGL ES 3.0");
    if (eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context) == EGL_FALSE) {
        eglDestroyContext(display, context);
        return failed("the context cannot be used without a surface");
    }
    auto headless = std::make_unique<Headless>(display, context);
    headless->set_scale(options.scale);
    headless->make_framebuffer(options.size);
    return headless;
}

}  // namespace surefoot::view
