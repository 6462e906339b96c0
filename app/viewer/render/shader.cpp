#include "shader.h"

#include <glad/gl.h>

#include <glm/gtc/type_ptr.hpp>
#include <utility>

#include "run/embedded_files.h"
#include "run/strings.h"

namespace se::view {

namespace {

constexpr std::string_view kVersion = "#version 330 core\n";

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
    const std::string text = std::string(kVersion) + defines + "#line 1\n" + source.value();
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
void Shader::set(const char* name, std::span<const glm::vec4> values) {
    glUniform4fv(location(name), static_cast<GLsizei>(values.size()), glm::value_ptr(values[0]));
}
void Shader::set(const char* name, std::span<const glm::vec2> values) {
    glUniform2fv(location(name), static_cast<GLsizei>(values.size()), glm::value_ptr(values[0]));
}

}  // namespace se::view
