# How every folder of the tree becomes a library, and what is generated on the way.
include(GNUInstallDirs)

add_library(alcove_warnings INTERFACE)
target_compile_options(alcove_warnings INTERFACE
  -Wall -Wextra -Wshadow -Wconversion -Wold-style-cast -Wnon-virtual-dtor -Werror)

# alcove_library(NAME SOURCES ... LINKS ... PRIVATE_LINKS ...)
# One static library a folder. LINKS are what its headers need, PRIVATE_LINKS what its .cpp files need.
function(alcove_library name)
  cmake_parse_arguments(A "" "" "SOURCES;LINKS;PRIVATE_LINKS" ${ARGN})
  add_library(${name} STATIC ${A_SOURCES})
  target_include_directories(${name} PUBLIC ${CMAKE_SOURCE_DIR})
  target_link_libraries(${name} PUBLIC alcove_glm ${A_LINKS} PRIVATE alcove_warnings ${A_PRIVATE_LINKS})
endfunction()

# alcove_embed_files(TARGET FUNCTION FILES...)
# Writes a .cpp with `std::span<const EmbeddedFile> FUNCTION()` that holds the files' text under their path in the
# tree, and adds it to TARGET. Rewritten at build time whenever one of the files changes.
function(alcove_embed_files target function)
  set(output ${CMAKE_CURRENT_BINARY_DIR}/${function}.cpp)
  add_custom_command(OUTPUT ${output}
    COMMAND ${CMAKE_COMMAND} -DROOT=${CMAKE_SOURCE_DIR} -DOUTPUT=${output} -DFUNCTION=${function} "-DFILES=${ARGN}"
            -P ${CMAKE_SOURCE_DIR}/cmake/embed_files.cmake
    DEPENDS ${ARGN} ${CMAKE_SOURCE_DIR}/cmake/embed_files.cmake
    VERBATIM)
  target_sources(${target} PRIVATE ${output})
endfunction()

# alcove_registry(ROOM UNIT_TYPE HEADER UNITS...)
# Writes the room's registry.cpp from its one list: each folder NAME offers NAME/NAME.hpp with `UNIT_TYPE NAME_unit()`.
# Every unit carries the hash of its folder, the room's common/ and, for methods, core/frame and core/gl.
function(alcove_registry target room unit_type header)
  set(output ${CMAKE_CURRENT_BINARY_DIR}/registry.cpp)
  set(common ${room}/common)
  if(room STREQUAL "methods")
    list(APPEND common core/frame core/gl)
  endif()
  set(inputs "")
  foreach(unit IN LISTS ARGN)
    file(GLOB files CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/${room}/${unit}/*)
    list(APPEND inputs ${files})
  endforeach()
  foreach(folder IN LISTS common)
    file(GLOB files CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/${folder}/*)
    list(APPEND inputs ${files})
  endforeach()
  add_custom_command(OUTPUT ${output}
    COMMAND ${CMAKE_COMMAND} -DROOT=${CMAKE_SOURCE_DIR} -DOUTPUT=${output} -DROOM=${room} -DUNIT_TYPE=${unit_type}
            -DHEADER=${header} "-DUNITS=${ARGN}" "-DCOMMON=${common}"
            -P ${CMAKE_SOURCE_DIR}/cmake/registry.cmake
    DEPENDS ${inputs} ${CMAKE_SOURCE_DIR}/cmake/registry.cmake
    VERBATIM)
  target_sources(${target} PRIVATE ${output})
endfunction()
