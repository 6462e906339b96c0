#include "shaders.h"

#include <utility>

namespace se::view {

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
