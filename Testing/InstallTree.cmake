# Installs the build tree BUILD into the empty directory PREFIX.
file(REMOVE_RECURSE "${PREFIX}")
execute_process(COMMAND "${CMAKE_COMMAND}" --install "${BUILD}" --prefix "${PREFIX}"
    --config "${CONFIG}"
  RESULT_VARIABLE result)
if (result)
  message(FATAL_ERROR "The installation failed: ${result}")
endif ()
