# Configures and builds the project SOURCE in the empty directory BUILD, with the package that is
# installed in PREFIX, and tests it where CTEST is given.
file(REMOVE_RECURSE "${BUILD}")
function (run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result)
  if (result)
    message(FATAL_ERROR "Failed (${result}): ${ARGN}")
  endif ()
endfunction ()

run("${CMAKE_COMMAND}" -S "${SOURCE}" -B "${BUILD}" -G "${GENERATOR}"
  "-DCMAKE_PREFIX_PATH=${PREFIX}" "-DCMAKE_BUILD_TYPE=${CONFIG}" "-DCMAKE_CXX_COMPILER=${CXX}"
  "-DWITH_FILTERS=${WITH_FILTERS}" "-DEACH_HEADER=${EACH_HEADER}" --no-warn-unused-cli)
run("${CMAKE_COMMAND}" --build "${BUILD}" --config "${CONFIG}")
if (CTEST)
  run("${CMAKE_COMMAND}" -E chdir "${BUILD}" "${CTEST}" -C "${CONFIG}" --output-on-failure
    --no-tests=error)
endif ()
