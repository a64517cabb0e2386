# Makes headers of the library in this directory public: they are included as
# <DirectionFields/Folder/Name.h>, from the build tree as well as from an installation. Nothing else
# of the library lies on its users' include path, least of all names that others may have, such as
# Options.h.
function (directionfields_public_headers library)
  set(script "${PROJECT_SOURCE_DIR}/cmake/RewriteIncludes.cmake")
  set(root "${PROJECT_BINARY_DIR}/include/DirectionFields")
  set(outputs)
  foreach (header IN LISTS ARGN)
    set(input "${CMAKE_CURRENT_SOURCE_DIR}/${header}")
    set(output "${root}/${header}")
    add_custom_command(OUTPUT "${output}"
      COMMAND "${CMAKE_COMMAND}" "-DINPUT=${input}" "-DOUTPUT=${output}" -P "${script}"
      DEPENDS "${input}" "${script}"
      VERBATIM)
    list(APPEND outputs "${output}")
    get_filename_component(folder "${header}" DIRECTORY)
    install(FILES "${output}" COMPONENT development
      DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/DirectionFields/${folder}")
  endforeach ()
  # They are made before anything that is linked with the library is compiled.
  add_custom_target("${library}Headers" ALL DEPENDS ${outputs})
  add_dependencies("${library}" "${library}Headers")
  target_include_directories("${library}" INTERFACE
    "$<BUILD_INTERFACE:${PROJECT_BINARY_DIR}/include>"
    "$<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>")
endfunction ()

# directionfields_moved_header(OLD NEW): includes of a public header by its place in the version before go on to work, with
# a note of the compiler.
function (directionfields_moved_header old new)
  set(output "${PROJECT_BINARY_DIR}/include/DirectionFields/${old}")
  get_filename_component(folder "${old}" DIRECTORY)
  file(GENERATE OUTPUT "${output}" CONTENT
"// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma message(\"<DirectionFields/${old}> is <DirectionFields/${new}> now\")
#include <DirectionFields/${new}>
")
  install(FILES "${output}" COMPONENT development
    DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/DirectionFields/${folder}")
endfunction ()
