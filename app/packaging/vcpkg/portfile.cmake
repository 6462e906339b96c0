# A port of the library for vcpkg. Untested: no vcpkg was at hand. It takes the checkout that this file is in:
#   vcpkg install spiraling-edge --overlay-ports=CHECKOUT/app/packaging/vcpkg
get_filename_component(SOURCE_PATH "${CMAKE_CURRENT_LIST_DIR}/../../.." ABSOLUTE)

vcpkg_check_features(OUT_FEATURE_OPTIONS options FEATURES sampling SPIRALING_EDGE_BUILD_SAMPLING)
vcpkg_cmake_configure(SOURCE_PATH "${SOURCE_PATH}" OPTIONS ${options}
    -DSPIRALING_EDGE_BUILD_CLI=OFF -DSPIRALING_EDGE_BUILD_VIEWER=OFF -DSPIRALING_EDGE_BUILD_TESTS=OFF
    -DSPIRALING_EDGE_PYTHON=OFF)
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(PACKAGE_NAME spiraling_edge CONFIG_PATH lib/cmake/spiraling_edge)
vcpkg_fixup_pkgconfig()
file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/debug/include" "${CURRENT_PACKAGES_DIR}/debug/share")
vcpkg_install_copyright(FILE_LIST "${SOURCE_PATH}/LICENSE")
