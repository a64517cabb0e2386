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
  add_custom_target("${library}Headers" ALL DEPENDS ${outputs})
  target_include_directories("${library}" INTERFACE
    "$<BUILD_INTERFACE:${PROJECT_BINARY_DIR}/include>"
    "$<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>")
endfunction ()
