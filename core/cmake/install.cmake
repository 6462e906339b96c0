# Installation of the library with its headers, for find_package(spiraling_edge) and for pkg-config.
# The programs are installed where they are defined (app/).
include(CMakePackageConfigHelpers)

set(package_dir "${CMAKE_INSTALL_LIBDIR}/cmake/spiraling_edge")
set(pkgconfig_dir "${CMAKE_INSTALL_LIBDIR}/pkgconfig")
file(RELATIVE_PATH prefix_from_here "/${pkgconfig_dir}" "/")

# install_library(NAME DESCRIPTION REQUIRES REQUIRES_PRIVATE): NAME, NAME_shared if there is one, and the
# files that find them.
function(install_library name description requires requires_private)
    set(targets ${name})
    if(TARGET ${name}_shared)
        list(APPEND targets ${name}_shared)
    endif()
    install(TARGETS ${targets} EXPORT ${name}_targets
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT dev
        LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT dev
        FILE_SET HEADERS COMPONENT dev)
    install(EXPORT ${name}_targets NAMESPACE spiraling_edge:: DESTINATION ${package_dir} COMPONENT dev)
    get_target_property(options ${name} INTERFACE_COMPILE_OPTIONS)
    get_target_property(definitions ${name} INTERFACE_COMPILE_DEFINITIONS)
    list(TRANSFORM definitions PREPEND "-D")
    set(options ${options} ${definitions})
    list(FILTER options EXCLUDE REGEX "NOTFOUND")
    list(JOIN options " " options)
    configure_file(core/cmake/spiraling_edge.pc.in "${PROJECT_BINARY_DIR}/${name}.pc" @ONLY)
    install(FILES "${PROJECT_BINARY_DIR}/${name}.pc" DESTINATION ${pkgconfig_dir} COMPONENT dev)
endfunction()

install_library(spiraling_edge "Spiraling Edge surface reconstruction" glm "")
if(SPIRALING_EDGE_BUILD_SAMPLING)
    install_library(spiraling_edge_sampling "Points from scalar fields and volumes" spiraling_edge zlib)
endif()
configure_package_config_file(core/cmake/spiraling_edge-config.cmake.in
    "${PROJECT_BINARY_DIR}/spiraling_edge-config.cmake" INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file("${PROJECT_BINARY_DIR}/spiraling_edge-config-version.cmake"
    COMPATIBILITY SameMinorVersion)
install(FILES
    "${PROJECT_BINARY_DIR}/spiraling_edge-config.cmake"
    "${PROJECT_BINARY_DIR}/spiraling_edge-config-version.cmake"
    DESTINATION ${package_dir} COMPONENT dev)
install(FILES LICENSE README.md CHANGELOG.md DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT documents)
