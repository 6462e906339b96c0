# spiraling_edge_add_shared(NAME PUBLIC... PRIVATE...): the shared library NAME_shared, from the objects
# of the static library NAME, which are compiled once for both, position-independent. Users get the
# options of NAME. Libraries: PUBLIC those that users link as well, PRIVATE those that they do not.
function(spiraling_edge_add_shared name)
    cmake_parse_arguments(arg "" "" "PUBLIC;PRIVATE" ${ARGN})
    set_target_properties(${name} PROPERTIES POSITION_INDEPENDENT_CODE ON)
    # Functions of the library call each other as in the static one.
    target_compile_options(${name} PRIVATE -fno-semantic-interposition)

    set(source "${CMAKE_CURRENT_BINARY_DIR}/${name}_shared.cpp")
    file(CONFIGURE OUTPUT "${source}" CONTENT "// All objects are those of the static library.\n")
    set(shared ${name}_shared)
    add_library(${shared} SHARED "${source}")
    add_dependencies(${shared} ${name})
    set_property(TARGET ${shared} APPEND PROPERTY LINK_DEPENDS "$<TARGET_FILE:${name}>")
    target_link_options(${shared} PRIVATE
        "LINKER:--whole-archive,$<TARGET_FILE:${name}>,--no-whole-archive" "LINKER:--no-undefined")
    target_link_libraries(${shared} PUBLIC ${arg_PUBLIC} PRIVATE ${arg_PRIVATE})
    target_include_directories(${shared} INTERFACE
        "$<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}>" "$<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>")
    foreach(property COMPILE_FEATURES COMPILE_OPTIONS COMPILE_DEFINITIONS LINK_OPTIONS)
        get_target_property(value ${name} INTERFACE_${property})
        if(value)
            set_property(TARGET ${shared} PROPERTY INTERFACE_${property} "${value}")
        endif()
    endforeach()
    get_target_property(export ${name} EXPORT_NAME)
    # Until 1.0 the minor number counts as the major one.
    set_target_properties(${shared} PROPERTIES OUTPUT_NAME ${name} EXPORT_NAME ${export}_shared
        VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
    add_library(spiraling_edge::${export}_shared ALIAS ${shared})
endfunction()
