# Included last by the main file: the files of packages beside programs and library, and Debian packages by
# CPack, one per install component that this build has (README.md). `cpack --preset package`
# makes them; app/packaging/test.sh tests them.
set(packaging "${CMAKE_CURRENT_LIST_DIR}")

# The date of the release stands in the heading of CHANGELOG.md; before it, that of the last commit counts.
file(STRINGS "${PROJECT_SOURCE_DIR}/CHANGELOG.md" heading REGEX "^## ${PROJECT_VERSION}, " LIMIT_COUNT 1)
if(NOT DEFINED ENV{SOURCE_DATE_EPOCH})
    execute_process(COMMAND git log -1 --format=%ct WORKING_DIRECTORY "${PROJECT_SOURCE_DIR}"
        OUTPUT_VARIABLE seconds OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
    if(seconds MATCHES "^[0-9]+$")
        set(ENV{SOURCE_DATE_EPOCH} "${seconds}")
    endif()
endif()
string(TIMESTAMP release_date "%Y-%m-%d" UTC)
string(TIMESTAMP debian_date "%a, %d %b %Y %H:%M:%S +0000" UTC)
set(release_type development)
set(distribution UNRELEASED)
if(heading MATCHES ", ([0-9][0-9][0-9][0-9]-[0-9][0-9]-[0-9][0-9])$")
    set(release_date "${CMAKE_MATCH_1}")
    set(release_type stable)
    set(distribution unstable)
endif()

# For the desktop: an entry, an icon, a description, and the types of the files that are ours.
if(SPIRALING_EDGE_BUILD_VIEWER)
    set(id org.spiraling_edge.viewer)
    configure_file("${packaging}/${id}.metainfo.xml.in" "${PROJECT_BINARY_DIR}/${id}.metainfo.xml" @ONLY)
    install(FILES "${PROJECT_BINARY_DIR}/${id}.metainfo.xml"
        DESTINATION ${CMAKE_INSTALL_DATADIR}/metainfo COMPONENT viewer)
    install(FILES "${packaging}/spiraling-edge-viewer.desktop"
        DESTINATION ${CMAKE_INSTALL_DATADIR}/applications COMPONENT viewer)
    install(FILES "${packaging}/spiraling-edge-viewer.svg"
        DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps COMPONENT viewer)
    install(FILES "${packaging}/spiraling-edge.xml"
        DESTINATION ${CMAKE_INSTALL_DATADIR}/mime/packages COMPONENT viewer)
endif()

# The pages of app/web/build.sh, where it has made them: the one that `spiraling-edge export --app` fills, and the site.
set(SPIRALING_EDGE_SITE "${PROJECT_SOURCE_DIR}/build-web" CACHE PATH
    "Folder with spiraling-edge.html and site/, for the package spiraling-edge-web")
if(EXISTS "${SPIRALING_EDGE_SITE}/spiraling-edge.html")
    install(FILES "${SPIRALING_EDGE_SITE}/spiraling-edge.html"
        DESTINATION ${CMAKE_INSTALL_DATADIR}/spiraling-edge COMPONENT web)
    install(DIRECTORY "${SPIRALING_EDGE_SITE}/site" DESTINATION ${CMAKE_INSTALL_DATADIR}/spiraling-edge COMPONENT web)
endif()

# Packages
set(SPIRALING_EDGE_MAINTAINER "The spiraling-edge authors <maintainers@spiraling-edge.invalid>" CACHE STRING
    "Maintainer of the packages: NAME <ADDRESS>")
get_cmake_property(components COMPONENTS)

# debian_package(COMPONENT NAME SECTION "SUMMARY\nDESCRIPTION" [DEPENDS...] [RECOMMENDS...] [SUGGESTS...] [ALL]):
# the package of a component, if this build has the component. ALL: for every architecture.
macro(debian_package component name section description)
    if("${component}" IN_LIST components)
        cmake_parse_arguments(arg "ALL" "DEPENDS;RECOMMENDS;SUGGESTS" "" ${ARGN})
        list(APPEND CPACK_COMPONENTS_ALL ${component})
        string(TOUPPER ${component} upper)
        set(CPACK_DEBIAN_${upper}_PACKAGE_NAME ${name})
        set(CPACK_DEBIAN_${upper}_PACKAGE_SECTION ${section})
        set(CPACK_DEBIAN_${upper}_DESCRIPTION "${description}")
        foreach(kind DEPENDS RECOMMENDS SUGGESTS)
            if(arg_${kind})
                set(CPACK_DEBIAN_${upper}_PACKAGE_${kind} "${arg_${kind}}")
            endif()
        endforeach()
        if(arg_ALL)
            set(CPACK_DEBIAN_${upper}_PACKAGE_ARCHITECTURE all)
            set(CPACK_DEBIAN_${upper}_PACKAGE_SHLIBDEPS OFF)
        endif()
        debian_documents(${component} ${name})
    endif()
endmacro()

# The copyright and the changelog that each package has; an installation without packages has the files at
# the root in their place.
function(debian_documents component name)
    set(folder "${PROJECT_BINARY_DIR}/packaging/${name}")
    configure_file("${packaging}/changelog.in" "${folder}/changelog" @ONLY)
    execute_process(COMMAND gzip -9nkf "${folder}/changelog")
    install(FILES "${packaging}/copyright" "${folder}/changelog.gz"
        DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${name} COMPONENT ${component} EXCLUDE_FROM_ALL)
endfunction()

set(CPACK_COMPONENTS_ALL)
set(method "The Spiraling Edge algorithm turns points with normals into a triangle
mesh: an edge ring spirals over the surface, point by point.")
debian_package(cli spiraling-edge science "surface reconstruction that explains its decisions
${method}
.
This is the command line. It triangulates scans, finds the faults of meshes
and the decisions that they come from, repairs inputs, compares runs, and
samples isosurfaces." SUGGESTS "spiraling-edge-viewer")
debian_package(viewer spiraling-edge-viewer science "viewer of the Spiraling Edge surface reconstruction
${method}
.
This program steps through every decision of a run, forward and back, and
explains each. It writes pictures, animations and pages without a display,
too." DEPENDS "libgl1" RECOMMENDS "fonts-inter, fonts-dejavu-core, spiraling-edge" SUGGESTS "spiraling-edge-web, ffmpeg")
debian_package(dev libspiraling-edge-dev libdevel "Spiraling Edge surface reconstruction, library
${method}
.
This package has the C++ headers and the library, static and shared, with
files for CMake and pkg-config. The interface may change with every minor
version." DEPENDS "libglm-dev, zlib1g-dev")
set(CPACK_DEBIAN_DEV_PACKAGE_CONTROL_EXTRA "${packaging}/dev/triggers")
if(python IN_LIST components)
    # A compiled module is for one version of Python. What Python compiles on its own is removed with the package.
    execute_process(COMMAND "${SPIRALING_EDGE_PYTHON_EXECUTABLE}" -c "import sys; print('python3 (>= 3.%d), python3 (<< 3.%d)' %
(sys.version_info[1], sys.version_info[1] + 1))" OUTPUT_VARIABLE python_version OUTPUT_STRIP_TRAILING_WHITESPACE)
    set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA "${packaging}/python/postinst;${packaging}/python/prerm")
endif()
debian_package(python python3-spiraling-edge python "Spiraling Edge surface reconstruction, Python module
${method}
.
This package has the module for Python 3." DEPENDS "${python_version}, python3-numpy")
debian_package(web spiraling-edge-web science "Spiraling Edge viewer as a page for browsers
${method}
.
This package has the viewer as a folder for any web server, and as one file,
which spiraling-edge export --app fills with a lesson or a scan." SUGGESTS "spiraling-edge-viewer" ALL)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME spiraling-edge)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")  # each package has its own
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_MAINTAINER "${SPIRALING_EDGE_MAINTAINER}")
set(CPACK_DEBIAN_PACKAGE_SOURCE spiraling-edge)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
include(CPack)
