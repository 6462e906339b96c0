/// A linked pair of shaders.
#pragma once

#include <filesystem>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <string>
#include <unordered_map>

#include "spiraling_edge/base/result.h"

namespace se::view {

class Shader {
  public:
    Shader() = default;
    ~Shader();
    Shader(Shader&& other) noexcept;
    Shader& operator=(Shader&& other) noexcept;

    /// Compiles `vertexName` and `fragmentName`. They are read from `folder` unless it is empty,
    /// otherwise from the embedded ones. `defines` is inserted after the version line.
    static Result<Shader> load(const std::string& vertexName, const std::string& fragmentName,
                               const std::filesystem::path& folder = {},
                               const std::string& defines = {});

    void use() const;
    void set(const char* name, const glm::mat4& value);
    void set(const char* name, const glm::vec2& value);
    void set(const char* name, const glm::vec3& value);
    void set(const char* name, const glm::vec4& value);
    void set(const char* name, float value);
    void set(const char* name, bool value);
    void set(const char* name, std::span<const glm::vec4> values);
    void set(const char* name, std::span<const glm::vec2> values);

  private:
    int location(const char* name);

    unsigned program_ = 0;
    std::unordered_map<std::string, int> locations_;
};

}  // namespace se::view
