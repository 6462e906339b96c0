# Writes a C++ file that holds the given lessons (embedded_lessons.h).
#   cmake -DOUT=embedded_lessons.cpp "-DFILES=a.lesson.md;b.lesson.md" -P embed_lessons.cmake
set(content "// Made by app/teach/embed_lessons.cmake.\n#include \"embedded_lessons.h\"\n\n")
string(APPEND content "#include <algorithm>\n#include <array>\n\n")
string(APPEND content "namespace se::teach {\nnamespace {\n\nconstexpr std::array kEmbeddedLessons{\n")
foreach(file IN LISTS FILES)
    get_filename_component(name "${file}" NAME)
    string(REPLACE ".lesson.md" "" id "${name}")
    file(READ "${file}" text)
    string(APPEND content "    EmbeddedLesson{\"${id}\", R\"lesson(${text})lesson\"},\n")
endforeach()
string(APPEND content "};\n\n}  // namespace\n\n")
string(APPEND content "std::span<const EmbeddedLesson> embeddedLessons() { return kEmbeddedLessons; }\n\n")
string(APPEND content "const EmbeddedLesson* findEmbeddedLesson(std::string_view id) {\n"
    "    const auto found =\n        std::find_if(kEmbeddedLessons.begin(), kEmbeddedLessons.end(),\n"
    "                     [&](const EmbeddedLesson& each) { return each.id == id; });\n"
    "    return found == kEmbeddedLessons.end() ? nullptr : &*found;\n}\n\n}  // namespace se::teach\n")
file(WRITE "${OUT}" "${content}")
