# Writes a C++ file that holds the given files as strings (run/embedded_files.h).
#   cmake -DOUT=embedded_files.cpp -DFILES=a.vert;b.txt -P embed.cmake
set(content "// Made by app/viewer/embed.cmake.\n#include \"run/embedded_files.h\"\n\n")
string(APPEND content "namespace se::view {\n\nstd::string_view embeddedFile(std::string_view name) {\n")
foreach(file IN LISTS FILES)
    get_filename_component(name "${file}" NAME)
    file(READ "${file}" text)
    string(APPEND content "    if (name == \"${name}\") return R\"file(${text})file\";\n")
endforeach()
string(APPEND content "    return {};\n}\n\n}  // namespace se::view\n")
file(WRITE "${OUT}" "${content}")
