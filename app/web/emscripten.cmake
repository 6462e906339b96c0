# Included by the main file when the compiler is Emscripten's: the libraries of the programs, from the
# headers and sources that parts.sh has fetched, under the names that find_package() would give them.
set(SPIRALING_EDGE_WEB_PARTS "${PROJECT_SOURCE_DIR}/build-web/parts" CACHE PATH "Folder that app/web/parts.sh has filled")
mark_as_advanced(SPIRALING_EDGE_WEB_PARTS)
set(web_include "${SPIRALING_EDGE_WEB_PARTS}/include")
set(web_sources "${SPIRALING_EDGE_WEB_PARTS}/sources")
if(NOT EXISTS "${web_include}")
    message(FATAL_ERROR "Fetch the libraries first: app/web/parts.sh ${SPIRALING_EDGE_WEB_PARTS}")
endif()
add_compile_options(-fwasm-exceptions)
add_link_options(-fwasm-exceptions)

# web_headers(TARGET): a library of headers alone.
function(web_headers target)
    add_library(${target} INTERFACE IMPORTED GLOBAL)
    target_include_directories(${target} SYSTEM INTERFACE "${web_include}")
endfunction()
# web_library(TARGET FOLDERS... SOURCES files...): a library of C or C++ sources, without our warnings.
function(web_library target)
    cmake_parse_arguments(arg "" "" "FOLDERS;SOURCES" ${ARGN})
    string(REPLACE "::" "_" plain "web_${target}")
    add_library(${plain} STATIC ${arg_SOURCES})
    target_include_directories(${plain} SYSTEM PUBLIC ${arg_FOLDERS})
    set_target_properties(${plain} PROPERTIES UNITY_BUILD OFF)
    add_library(${target} ALIAS ${plain})
endfunction()

foreach(target CLI11::CLI11 fmt::fmt glm::glm nlohmann_json::nlohmann_json)
    web_headers(${target})
endforeach()
target_compile_definitions(fmt::fmt INTERFACE FMT_HEADER_ONLY=1)
add_library(Threads::Threads INTERFACE IMPORTED GLOBAL)
set(SPIRALING_EDGE_TOML "${web_include}" CACHE PATH "" FORCE)

set(z "${web_sources}/zlib")
web_library(ZLIB::ZLIB FOLDERS "${z}" SOURCES ${z}/adler32.c ${z}/crc32.c ${z}/inflate.c
    ${z}/inffast.c ${z}/inftrees.c ${z}/zutil.c ${z}/compress.c ${z}/deflate.c ${z}/trees.c)

set(c "${web_sources}/cmark/src")
set(made "${CMAKE_BINARY_DIR}/cmark")
set(cmark_sources blocks buffer cmark cmark_ctype commonmark houdini_href_e houdini_html_e houdini_html_u html
    inlines iterator latex man node references render scanners utf8 xml)
list(TRANSFORM cmark_sources PREPEND "${c}/")
list(TRANSFORM cmark_sources APPEND ".c")
# What cmark's own build would make.
file(CONFIGURE OUTPUT "${made}/config.h" @ONLY CONTENT "#define HAVE_STDBOOL_H\n#include <stdbool.h>
#define HAVE___BUILTIN_EXPECT\n#define HAVE___ATTRIBUTE__\n#define CMARK_ATTRIBUTE(list) __attribute__ (list)
#define CMARK_INLINE inline\n")
file(CONFIGURE OUTPUT "${made}/cmark_export.h" CONTENT "#define CMARK_EXPORT\n#define CMARK_NO_EXPORT\n")
file(CONFIGURE OUTPUT "${made}/cmark_version.h" CONTENT "#define CMARK_VERSION 0\n#define CMARK_VERSION_STRING \"\"\n")
web_library(PkgConfig::CMARK FOLDERS ${c} ${made} SOURCES ${cmark_sources})

set(i "${web_sources}/imgui")
web_library(PkgConfig::IMGUI FOLDERS ${i} ${i}/misc/cpp ${web_include}/stb ${web_include} SOURCES
    ${i}/imgui.cpp ${i}/imgui_draw.cpp ${i}/imgui_tables.cpp ${i}/imgui_widgets.cpp ${i}/misc/cpp/imgui_stdlib.cpp
    ${i}/backends/imgui_impl_glfw.cpp ${i}/backends/imgui_impl_opengl3.cpp "${CMAKE_CURRENT_LIST_DIR}/platform/stb.c")
# Indices of 32 bits: WebGL cannot add an offset to those of 16.
target_compile_definitions(web_PkgConfig_IMGUI PUBLIC IMGUI_IMPL_OPENGL_ES3 ImDrawIdx=unsigned)
set_source_files_properties(${i}/backends/imgui_impl_opengl3.cpp PROPERTIES
    COMPILE_DEFINITIONS glGetIntegerv=pageGetIntegerv)  # platform/gl_state.cpp

# Linked, not loaded; the functions of GLFW that the window calls are in platform/glfw_canvas.cpp.
foreach(target spiraling_edge_glad OpenGL::EGL glfw)
    add_library(${target} INTERFACE IMPORTED GLOBAL)
endforeach()
target_include_directories(spiraling_edge_glad SYSTEM INTERFACE "${CMAKE_CURRENT_LIST_DIR}/platform")
target_include_directories(glfw SYSTEM INTERFACE "${web_include}")

# All of them are found.
set(modules "${CMAKE_BINARY_DIR}/modules")
foreach(package CLI11 fmt glfw3 glm nlohmann_json OpenGL PkgConfig Threads ZLIB)
    file(CONFIGURE OUTPUT "${modules}/Find${package}.cmake" CONTENT "set(${package}_FOUND TRUE)\n")
endforeach()
list(PREPEND CMAKE_MODULE_PATH "${modules}")
function(pkg_check_modules prefix)
    if(TARGET PkgConfig::${prefix})
        set(${prefix}_FOUND TRUE PARENT_SCOPE)
    endif()
endfunction()

foreach(font TEXT:Inter-Regular.otf STRONG:Inter-SemiBold.otf SYMBOL:DejaVuSans.ttf MONO:DejaVuSansMono.ttf)
    string(REPLACE ":" ";" font "${font}")
    list(GET font 0 use)
    list(GET font 1 file)
    set(SPIRALING_EDGE_FONT_${use} "/fonts/${file}" CACHE FILEPATH "" FORCE)
endforeach()
