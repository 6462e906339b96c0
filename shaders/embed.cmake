# Writes a C++ file that holds the given shader files as strings.
#   cmake -DOUT=shaders.cpp -DFILES=a.vert;b.frag -P embed.cmake
set(content "// Made by shaders/embed.cmake.\n#include \"render/shader_sources.h\"\n\n")
string(APPEND content "namespace se::view {\n\nnamespace {\n\nconstexpr ShaderSource kSources[] = {\n")
foreach(file IN LISTS FILES)
    get_filename_component(name "${file}" NAME)
    file(READ "${file}" text)
    string(APPEND content "    {\"${name}\", R\"glsl(${text})glsl\"},\n")
endforeach()
string(APPEND content "};\n\n}  // namespace\n\n")
string(APPEND content "std::span<const ShaderSource> embeddedShaders() { return kSources; }\n\n}  // namespace se::view\n")
file(WRITE "${OUT}" "${content}")
