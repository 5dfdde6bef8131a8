/// OpenGL with owners: what is made here is deleted by itself. Everything stays within OpenGL ES 3.0.
#pragma once

#include <epoxy/gl.h>
#include <glm/ext/matrix_float4x4.hpp>
#include <glm/ext/vector_float2.hpp>
#include <glm/ext/vector_float3.hpp>
#include <glm/ext/vector_float4.hpp>
#include <glm/ext/vector_int2.hpp>
#include <string>
#include <string_view>
#include <utility>

namespace surefoot::view::gl {

using glm::ivec2;
using glm::mat4;
using glm::vec2;
using glm::vec3;
using glm::vec4;

/// The number of one object; `Traits` know how to make and to delete it. Zero is none.
template <typename Traits>
class Object {
public:
    Object() = default;
    Object(Object&& other) noexcept : id_(std::exchange(other.id_, 0)) {}
    Object& operator=(Object&& other) noexcept {
        std::swap(id_, other.id_);
        return *this;
    }
    ~Object() {
        if (id_ != 0) Traits::destroy(id_);
    }

    [[nodiscard]] static Object make() {
        Object object;
        object.id_ = Traits::create();
        return object;
    }

    [[nodiscard]] GLuint id() const { return id_; }
    [[nodiscard]] explicit operator bool() const { return id_ != 0; }

private:
    GLuint id_ = 0;
};

struct BufferTraits {
    static GLuint create();
    static void destroy(GLuint id);
};
struct VertexArrayTraits {
    static GLuint create();
    static void destroy(GLuint id);
};
struct TextureTraits {
    static GLuint create();
    static void destroy(GLuint id);
};
struct FramebufferTraits {
    static GLuint create();
    static void destroy(GLuint id);
};

using Buffer = Object<BufferTraits>;
using VertexArray = Object<VertexArrayTraits>;
using Texture = Object<TextureTraits>;
using Framebuffer = Object<FramebufferTraits>;

/// A linked program. A source that does not compile is a mistake in this library: it prints the driver's words and
/// aborts.
class Program {
public:
    Program() = default;
    /// Both sources get the header with the version; `defines` are lines of "#define ...".
    Program(std::string_view name, std::string_view vertex, std::string_view fragment, std::string_view defines = {});
    Program(Program&& other) noexcept : id_(std::exchange(other.id_, 0)) {}
    Program& operator=(Program&& other) noexcept {
        std::swap(id_, other.id_);
        return *this;
    }
    ~Program();

    void use() const;

    // The program has to be in use. A name that the compiler found to be of no use is no error.
    void set(const char* name, float value) const;
    void set(const char* name, int value) const;
    void set(const char* name, const vec2& value) const;
    void set(const char* name, const vec3& value) const;
    void set(const char* name, const vec4& value) const;
    void set(const char* name, const mat4& value) const;

private:
    GLuint id_ = 0;
};

/// A texture for drawing into: colour (RGBA8), or depth of 24 bits.
[[nodiscard]] Texture colour_texture(const ivec2& size);
[[nodiscard]] Texture depth_texture(const ivec2& size);

/// A depth texture that is compared when it is read, for shadows.
[[nodiscard]] Texture shadow_texture(int size);

/// A framebuffer over these; either may be none.
[[nodiscard]] Framebuffer framebuffer_of(const Texture* colour, const Texture* depth);

/// A place in a buffer, as the calls want it that once took a pointer.
[[nodiscard]] inline const void* offset(std::size_t bytes) {
    return reinterpret_cast<const void*>(bytes);
}

/// Replaces the content of a buffer, for what changes with every frame.
void stream(const Buffer& buffer, const void* bytes, std::size_t size);

/// The first error since the last call, as text; empty if there is none.
[[nodiscard]] std::string take_error();

}  // namespace surefoot::view::gl
