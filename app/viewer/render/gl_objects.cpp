#include "gl_objects.h"

#include <glad/gl.h>
#include <algorithm>
#include <glm/gtc/type_ptr.hpp>
#include <utility>

#include "gl_dialect.h"
#include "run/embedded_files.h"
#include "run/strings.h"

namespace se::view {

namespace {

Result<std::string> sourceOf(const std::string& name, const std::filesystem::path& folder) {
    if (!folder.empty()) {
        std::optional<std::string> text = readText(folder / name);
        if (!text) return Error{"Cannot read the shader " + (folder / name).string() + "."};
        return std::move(*text);
    }
    const std::string_view text = embeddedFile(name);
    if (text.empty()) return Error{"There is no shader " + name + "."};
    return std::string(text);
}

Result<unsigned> compile(GLenum kind, const std::string& name, const std::filesystem::path& folder,
                         const std::string& defines) {
    const Result<std::string> source = sourceOf(name, folder);
    if (!source) return source.error();
    const std::string text = std::string(kShaderHeader) + defines + "#line 1\n" + source.value();
    const char* pointer = text.c_str();
    const GLuint shader = glCreateShader(kind);
    glShaderSource(shader, 1, &pointer, nullptr);
    glCompileShader(shader);
    GLint good = 0;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &good);
    if (good == GL_TRUE) return shader;
    std::string log(4096, '\0');
    GLsizei length = 0;
    glGetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), &length, log.data());
    log.resize(static_cast<std::size_t>(length));
    glDeleteShader(shader);
    return Error{name + ": " + log};
}

}  // namespace

Shader::~Shader() {
    if (program_ != 0) glDeleteProgram(program_);
}

Shader::Shader(Shader&& other) noexcept
    : program_(std::exchange(other.program_, 0)), locations_(std::move(other.locations_)) {}

Shader& Shader::operator=(Shader&& other) noexcept {
    std::swap(program_, other.program_);
    std::swap(locations_, other.locations_);
    return *this;
}

Result<Shader> Shader::load(const std::string& vertexName, const std::string& fragmentName,
                            const std::filesystem::path& folder, const std::string& defines) {
    const Result<unsigned> vertex = compile(GL_VERTEX_SHADER, vertexName, folder, defines);
    if (!vertex) return vertex.error();
    const Result<unsigned> fragment = compile(GL_FRAGMENT_SHADER, fragmentName, folder, defines);
    if (!fragment) {
        glDeleteShader(vertex.value());
        return fragment.error();
    }
    Shader shader;
    shader.program_ = glCreateProgram();
    glAttachShader(shader.program_, vertex.value());
    glAttachShader(shader.program_, fragment.value());
    glLinkProgram(shader.program_);
    glDeleteShader(vertex.value());
    glDeleteShader(fragment.value());
    GLint good = 0;
    glGetProgramiv(shader.program_, GL_LINK_STATUS, &good);
    if (good != GL_TRUE) return Error{vertexName + " and " + fragmentName + " do not fit."};
    return shader;
}

void Shader::use() const { glUseProgram(program_); }

int Shader::location(const char* name) {
    const auto [found, fresh] = locations_.try_emplace(name, -1);
    if (fresh) found->second = glGetUniformLocation(program_, name);
    return found->second;
}

void Shader::set(const char* name, const glm::mat4& value) {
    glUniformMatrix4fv(location(name), 1, GL_FALSE, glm::value_ptr(value));
}
void Shader::set(const char* name, const glm::vec2& value) {
    glUniform2fv(location(name), 1, glm::value_ptr(value));
}
void Shader::set(const char* name, const glm::vec3& value) {
    glUniform3fv(location(name), 1, glm::value_ptr(value));
}
void Shader::set(const char* name, const glm::vec4& value) {
    glUniform4fv(location(name), 1, glm::value_ptr(value));
}
void Shader::set(const char* name, float value) { glUniform1f(location(name), value); }
void Shader::set(const char* name, bool value) { glUniform1i(location(name), value ? 1 : 0); }
void Shader::set(const char* name, int value) { glUniform1i(location(name), value); }
void Shader::set(const char* name, std::span<const glm::vec4> values) {
    glUniform4fv(location(name), static_cast<GLsizei>(values.size()), glm::value_ptr(values[0]));
}
void Shader::set(const char* name, std::span<const glm::vec2> values) {
    glUniform2fv(location(name), static_cast<GLsizei>(values.size()), glm::value_ptr(values[0]));
}

Batch::~Batch() {
    if (array_ == 0) return;
    glDeleteBuffers(2, buffers_);
    glDeleteVertexArrays(1, &array_);
}

void Batch::bind() {
    if (array_ == 0) {
        glGenVertexArrays(1, &array_);
        glGenBuffers(2, buffers_);
    }
    glBindVertexArray(array_);
}

void Batch::describe(int buffer, std::size_t stride, const std::vector<VertexAttribute>& attributes,
                     bool perInstance) {
    bind();
    glBindBuffer(GL_ARRAY_BUFFER, buffers_[buffer]);
    for (const VertexAttribute& each : attributes) {
        const void* offset = reinterpret_cast<const void*>(each.offset);
        const auto step = static_cast<GLsizei>(stride);
        glEnableVertexAttribArray(each.location);
        if (each.bytes) {
            glVertexAttribIPointer(each.location, each.components, GL_UNSIGNED_BYTE, step, offset);
        } else if (each.signs) {
            glVertexAttribPointer(each.location, each.components, GL_BYTE, GL_TRUE, step, offset);
        } else {
            glVertexAttribPointer(each.location, each.components, GL_FLOAT, GL_FALSE, step, offset);
        }
        glVertexAttribDivisor(each.location, perInstance ? 1 : 0);
    }
}

void Batch::upload(int buffer, const void* data, std::size_t bytes) {
    bind();
    glBindBuffer(GL_ARRAY_BUFFER, buffers_[buffer]);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(bytes), data, GL_DYNAMIC_DRAW);
    capacity_[buffer] = bytes;
}

void Batch::reserve(int buffer, std::size_t bytes) {
    bind();
    const std::size_t before = capacity_[buffer];
    if (bytes <= before) return;
    capacity_[buffer] = std::max(bytes, 2 * before);
    GLuint larger = 0;
    glGenBuffers(1, &larger);
    glBindBuffer(GL_COPY_WRITE_BUFFER, larger);
    glBufferData(GL_COPY_WRITE_BUFFER, static_cast<GLsizeiptr>(capacity_[buffer]), nullptr,
                 GL_STATIC_DRAW);
    if (before > 0) {
        glBindBuffer(GL_COPY_READ_BUFFER, buffers_[buffer]);
        glCopyBufferSubData(GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER, 0, 0,
                            static_cast<GLsizeiptr>(before));
    }
    glDeleteBuffers(1, &buffers_[buffer]);
    buffers_[buffer] = larger;
}

void Batch::append(int buffer, std::size_t offset, const void* data, std::size_t bytes) {
    reserve(buffer, offset + bytes);
    bind();
    glBindBuffer(GL_ARRAY_BUFFER, buffers_[buffer]);
    glBufferSubData(GL_ARRAY_BUFFER, static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(bytes),
                    data);
}

void beginNew(unsigned frame, const glm::vec4& color) {
    glBindFramebuffer(GL_FRAMEBUFFER, frame);
    glDisable(GL_SCISSOR_TEST);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDepthMask(GL_TRUE);
    glClearColor(color.r, color.g, color.b, color.a);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

int samplesOf(int wanted) {
    GLint most = 0;
    glGetIntegerv(GL_MAX_SAMPLES, &most);
    return std::min(most, wanted);
}

void allocateBuffer(unsigned buffer, int samples, unsigned format, glm::ivec2 size,
                    unsigned attachment) {
    glBindRenderbuffer(GL_RENDERBUFFER, buffer);
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, size.x, size.y);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, buffer);
}

void allocateTexture(unsigned texture, unsigned format, glm::ivec2 size, unsigned filter) {
    const bool depth = format == GL_DEPTH_COMPONENT24;
    const GLenum channels = depth ? GL_DEPTH_COMPONENT : format == GL_R8 ? GL_RED : GL_RGBA;
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(format), size.x, size.y, 0, channels,
                 depth ? GL_UNSIGNED_INT : GL_UNSIGNED_BYTE, nullptr);
    for (const GLenum way : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
        glTexParameteri(GL_TEXTURE_2D, way, static_cast<GLint>(filter));
    for (const GLenum side : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
        glTexParameteri(GL_TEXTURE_2D, side, GL_CLAMP_TO_EDGE);
}

void aimAt(unsigned frame, glm::ivec2 size, const PixelRect& rect) {
    glBindFramebuffer(GL_FRAMEBUFFER, frame);
    glViewport(0, 0, size.x, size.y);
    glEnable(GL_SCISSOR_TEST);
    glScissor(rect.min.x, rect.min.y, rect.max.x - rect.min.x, rect.max.y - rect.min.y);
}

Target::~Target() { release(); }

void Target::release() {
    glDeleteFramebuffers(1, &drawn_);
    glDeleteFramebuffers(1, &resolved_);
    glDeleteRenderbuffers(1, &color_);
    glDeleteRenderbuffers(1, &depth_);
    glDeleteTextures(1, &texture_);
    drawn_ = resolved_ = color_ = depth_ = texture_ = 0;
}

void Target::allocate(glm::ivec2 size) {
    release();
    size_ = size;
    const int samples = samplesOf(samples_);
    glGenFramebuffers(1, &drawn_);
    glBindFramebuffer(GL_FRAMEBUFFER, drawn_);
    glGenRenderbuffers(1, &color_);
    allocateBuffer(color_, samples, GL_RGBA8, size, GL_COLOR_ATTACHMENT0);
    glGenRenderbuffers(1, &depth_);
    allocateBuffer(depth_, samples, GL_DEPTH_COMPONENT24, size, GL_DEPTH_ATTACHMENT);

    glGenFramebuffers(1, &resolved_);
    glBindFramebuffer(GL_FRAMEBUFFER, resolved_);
    glGenTextures(1, &texture_);
    allocateTexture(texture_, GL_RGBA8, size, GL_NEAREST);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture_, 0);
    for (const unsigned frame : {resolved_, drawn_}) beginNew(frame, {0.0F, 0.0F, 0.0F, 1.0F});
}

void Target::begin(glm::ivec2 size) {
    glGetIntegerv(GL_FRAMEBUFFER_BINDING, &previous_);
    size = glm::ivec2(std::max(size.x, 1), std::max(size.y, 1));
    if (size != size_) allocate(size);
    glBindFramebuffer(GL_FRAMEBUFFER, drawn_);
    glViewport(0, 0, size.x, size.y);
}

void Target::end() {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, drawn_);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, resolved_);
    glBlitFramebuffer(0, 0, size_.x, size_.y, 0, 0, size_.x, size_.y, GL_COLOR_BUFFER_BIT,
                      GL_NEAREST);
    glBindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(previous_));
}

namespace {

/// A row of the table of shaders.
struct ShaderRow {
    Shader Shaders::*shader;
    const char* vertex;
    const char* fragment;
    const char* defines = "";
};

constexpr ShaderRow kShaderRows[] = {
    {&Shaders::mesh, "mesh.vert", "mesh.frag"},
    {&Shaders::shape, "cloud.vert", "point.frag"},
    {&Shaders::dot, "cloud.vert", "point.frag", "#define SOLID\n"},
    {&Shaders::line, "line.vert", "line.frag"},
    {&Shaders::shell, "shell.vert", "shell.frag"},
    {&Shaders::sprite, "sprite.vert", "point.frag", "#define HALO\n"},
    {&Shaders::occlusion, "screen.vert", "occlusion.frag"},
    {&Shaders::relief, "screen.vert", "relief.frag"},
    {&Shaders::outline, "screen.vert", "relief.frag", "#define QUICK\n"},
};

}  // namespace

Result<std::shared_ptr<Shaders>> Shaders::load(const std::filesystem::path& folder) {
    auto shaders = std::make_shared<Shaders>();
    for (const ShaderRow& row : kShaderRows) {
        Result<Shader> loaded = Shader::load(row.vertex, row.fragment, folder, row.defines);
        if (!loaded) return loaded.error();
        (*shaders).*row.shader = std::move(loaded.value());
    }
    return shaders;
}

}  // namespace se::view
