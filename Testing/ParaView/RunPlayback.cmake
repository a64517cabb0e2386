# Plays PLAYBACK back in the ParaView window with MESH open and the plugin PLUGIN, if any, loaded. A
# macro that the playback runs writes its verdict into the file NAME.txt in OUTPUT.
set(verdict "${OUTPUT}/${NAME}.txt")
file(REMOVE "${verdict}" "${OUTPUT}/${NAME}.png")
set(plugins)
if (PLUGIN)
  get_filename_component(directory "${PLUGIN}" DIRECTORY)
  set(plugins "--plugin-search-paths=${directory}" --plugins=DirectionFields)
endif ()
# With --dr, newer versions of ParaView leave out the macros of their user.
execute_process(
  COMMAND "${CMAKE_COMMAND}" -E env "HOME=${HOME}" "XDG_CONFIG_HOME=${HOME}/.config"
    "PV_MACRO_PATH=${HOME}/.config/ParaView/Macros"
    "DIRECTIONFIELDS_TEST_NAME=${NAME}" "DIRECTIONFIELDS_TEST_OUTPUT=${OUTPUT}"
    "PARAVIEW_LOG_EXECUTION_VERBOSITY=OFF"
    "${PARAVIEW}" --dr ${plugins}
    "--test-directory=${OUTPUT}" "--data=${MESH}" "--test-script=${PLAYBACK}" --exit
  TIMEOUT 300
  RESULT_VARIABLE result
  OUTPUT_VARIABLE text
  ERROR_VARIABLE text)
message("${text}")
if (result)
  message(FATAL_ERROR "The playback failed: ${result}")
endif ()
if (NOT EXISTS "${verdict}")
  message(FATAL_ERROR "The macro did not run.")
endif ()
file(READ "${verdict}" found)
message("${found}")
if (NOT found STREQUAL "passed\n")
  message(FATAL_ERROR "The pipeline is not as expected.")
endif ()
