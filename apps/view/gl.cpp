#include "view/gl.hpp"

#include <cstdio>
#include <cstdlib>
#include <glm/gtc/type_ptr.hpp>

namespace surefoot::view::gl {
namespace {

std::string header() {
    if (epoxy_is_desktop_gl()) return "#version 330 core\n";
    return "#version 300 es\nprecision highp float;\nprecision highp int;\nprecision highp sampler2DShadow;\n";
}

[[noreturn]] void give_up(std::string_view name, const char* what, const char* words) {
    std::fprintf(stderr, "surefoot: the shader '%.*s' does not %s here:\n%s\n", static_cast<int>(name.size()),
                 name.data(), what, words);
    std::abort();
}

GLuint compile(std::string_view name, GLenum stage, const std::string& source) {
    const GLuint shader = glCreateShader(stage);
    const char* const text = source.c_str();
    glShaderSource(shader, 1, &text, nullptr);
    glCompileShader(shader);
    GLint good = 0;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &good);
    if (good == 0) {
        char words[4096] = "";
        glGetShaderInfoLog(shader, sizeof words, nullptr, words);
        give_up(name, stage == GL_VERTEX_SHADER ? "compile (vertices)" : "compile (fragments)", words);
    }
    return shader;
}

}  // namespace

GLuint BufferTraits::create() {
    GLuint id = 0;
    glGenBuffers(1, &id);
    return id;
}
void BufferTraits::destroy(GLuint id) {
    glDeleteBuffers(1, &id);
}
GLuint VertexArrayTraits::create() {
    GLuint id = 0;
    glGenVertexArrays(1, &id);
    return id;
}
void VertexArrayTraits::destroy(GLuint id) {
    glDeleteVertexArrays(1, &id);
}
GLuint TextureTraits::create() {
    GLuint id = 0;
    glGenTextures(1, &id);
    return id;
}
void TextureTraits::destroy(GLuint id) {
    glDeleteTextures(1, &id);
}
GLuint FramebufferTraits::create() {
    GLuint id = 0;
    glGenFramebuffers(1, &id);
    return id;
}
void FramebufferTraits::destroy(GLuint id) {
    glDeleteFramebuffers(1, &id);
}

Program::Program(std::string_view name, std::string_view vertex, std::string_view fragment, std::string_view defines)
    : id_(glCreateProgram()) {
    const std::string begin = header() + std::string(defines);
    const GLuint vertices = compile(name, GL_VERTEX_SHADER, begin + std::string(vertex));
    const GLuint fragments = compile(name, GL_FRAGMENT_SHADER, begin + std::string(fragment));
    glAttachShader(id_, vertices);
    glAttachShader(id_, fragments);
    glLinkProgram(id_);
    glDeleteShader(vertices);
    glDeleteShader(fragments);
    GLint good = 0;
    glGetProgramiv(id_, GL_LINK_STATUS, &good);
    if (good == 0) {
        char words[4096] = "";
        glGetProgramInfoLog(id_, sizeof words, nullptr, words);
        give_up(name, "link", words);
    }
}

Program::~Program() {
    if (id_ != 0) glDeleteProgram(id_);
}

void Program::use() const {
    glUseProgram(id_);
}
void Program::set(const char* name, float value) const {
    glUniform1f(glGetUniformLocation(id_, name), value);
}
void Program::set(const char* name, int value) const {
    glUniform1i(glGetUniformLocation(id_, name), value);
}
void Program::set(const char* name, const vec2& value) const {
    glUniform2fv(glGetUniformLocation(id_, name), 1, glm::value_ptr(value));
}
void Program::set(const char* name, const vec3& value) const {
    glUniform3fv(glGetUniformLocation(id_, name), 1, glm::value_ptr(value));
}
void Program::set(const char* name, const vec4& value) const {
    glUniform4fv(glGetUniformLocation(id_, name), 1, glm::value_ptr(value));
}
void Program::set(const char* name, const mat4& value) const {
    glUniformMatrix4fv(glGetUniformLocation(id_, name), 1, GL_FALSE, glm::value_ptr(value));
}

namespace {

Texture texture(const ivec2& size, GLint kind, GLenum format, GLenum type, GLint filter) {
    Texture made = Texture::make();
    glBindTexture(GL_TEXTURE_2D, made.id());
    glTexImage2D(GL_TEXTURE_2D, 0, kind, size.x, size.y, 0, format, type, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    return made;
}

}  // namespace

Texture colour_texture(const ivec2& size) {
    return texture(size, GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, GL_LINEAR);
}

Texture depth_texture(const ivec2& size) {
    return texture(size, GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, GL_NEAREST);
}

Texture shadow_texture(int size) {
    Texture made = texture({size, size}, GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
    return made;
}

Framebuffer framebuffer_of(const Texture* colour, const Texture* depth) {
    Framebuffer made = Framebuffer::make();
    glBindFramebuffer(GL_FRAMEBUFFER, made.id());
    if (colour != nullptr) glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, colour->id(), 0);
    if (depth != nullptr) glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth->id(), 0);
    const GLenum target = colour != nullptr ? GL_COLOR_ATTACHMENT0 : GL_NONE;
    glDrawBuffers(1, &target);
    if (colour == nullptr) glReadBuffer(GL_NONE);
    return made;
}

void stream(const Buffer& buffer, const void* bytes, std::size_t size) {
    glBindBuffer(GL_ARRAY_BUFFER, buffer.id());
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(size), bytes, GL_STREAM_DRAW);
}

std::string take_error() {
    std::string text;
    for (int i = 0; i < 16; ++i) {  // a lost context would never come to an end
        const GLenum error = glGetError();
        if (error == GL_NO_ERROR) break;
        if (!text.empty()) continue;
        text = error == GL_INVALID_ENUM        ? "GL_INVALID_ENUM"
               : error == GL_INVALID_VALUE     ? "GL_INVALID_VALUE"
               : error == GL_INVALID_OPERATION ? "GL_INVALID_OPERATION"
               : error == GL_OUT_OF_MEMORY     ? "GL_OUT_OF_MEMORY"
                                               : "GL error " + std::to_string(error);
    }
    return text;
}

}  // namespace surefoot::view::gl
