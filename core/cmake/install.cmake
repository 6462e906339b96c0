# Installation: the library with its headers, and the package for find_package(spiraling_edge). The
# programs are installed where they are defined (app/).
include(CMakePackageConfigHelpers)

set(package_dir "${CMAKE_INSTALL_LIBDIR}/cmake/spiraling_edge")
install(TARGETS spiraling_edge EXPORT spiraling_edge_targets
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}
    FILE_SET HEADERS)
install(EXPORT spiraling_edge_targets NAMESPACE spiraling_edge:: DESTINATION ${package_dir})
if(SPIRALING_EDGE_BUILD_SAMPLING)
    install(TARGETS spiraling_edge_sampling EXPORT spiraling_edge_sampling_targets
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
        LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}
        FILE_SET HEADERS)
    install(EXPORT spiraling_edge_sampling_targets NAMESPACE spiraling_edge::
        DESTINATION ${package_dir})
endif()
configure_package_config_file(core/cmake/spiraling_edge-config.cmake.in
    "${PROJECT_BINARY_DIR}/spiraling_edge-config.cmake" INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file("${PROJECT_BINARY_DIR}/spiraling_edge-config-version.cmake"
    COMPATIBILITY SameMinorVersion)
install(FILES
    "${PROJECT_BINARY_DIR}/spiraling_edge-config.cmake"
    "${PROJECT_BINARY_DIR}/spiraling_edge-config-version.cmake"
    DESTINATION ${package_dir})
install(FILES LICENSE README.md CHANGELOG.md DESTINATION ${CMAKE_INSTALL_DOCDIR})
