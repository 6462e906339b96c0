# spiraling_edge_add_pages(PROGRAM COMPONENT): the man pages and completions of a program, made from its own
# lists of options once it is linked (pages.py), and their installation.
set(SPIRALING_EDGE_PAGES "${CMAKE_CURRENT_LIST_DIR}/pages.py")
find_package(Python3 COMPONENTS Interpreter)

function(spiraling_edge_add_pages program component)
    if(NOT Python3_Interpreter_FOUND OR CMAKE_CROSSCOMPILING OR EMSCRIPTEN)
        message(STATUS "No man pages and completions of ${program}: they are made by Python, from the program")
        return()
    endif()
    set(pages "${CMAKE_CURRENT_BINARY_DIR}/pages")
    add_custom_command(TARGET ${program} POST_BUILD VERBATIM
        COMMAND "${Python3_EXECUTABLE}" "${SPIRALING_EDGE_PAGES}" $<TARGET_FILE:${program}> "${pages}")
    set_property(TARGET ${program} APPEND PROPERTY LINK_DEPENDS "${SPIRALING_EDGE_PAGES}")
    # Debian keeps the folders of its packages apart from those of a local installation.
    set(zsh site-functions)
    if(CMAKE_INSTALL_PREFIX STREQUAL "/usr")
        set(zsh vendor-completions)
    endif()
    install(DIRECTORY "${pages}/man1/" DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT ${component})
    install(DIRECTORY "${pages}/bash/" DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions
        COMPONENT ${component})
    install(DIRECTORY "${pages}/zsh/" DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/${zsh} COMPONENT ${component})
    install(DIRECTORY "${pages}/fish/" DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d
        COMPONENT ${component})
endfunction()
