# Configures, builds and tests the project SOURCE in the empty directory BUILD, with the package
# that is installed in PREFIX.
file(REMOVE_RECURSE "${BUILD}")
foreach (command IN ITEMS
    "${CMAKE_COMMAND};-S;${SOURCE};-B;${BUILD};-G;${GENERATOR};-DCMAKE_PREFIX_PATH=${PREFIX};\
-DCMAKE_BUILD_TYPE=${CONFIG};-DCMAKE_CXX_COMPILER=${CXX};-DWITH_FILTERS=${WITH_FILTERS};\
-DEACH_HEADER=${EACH_HEADER}"
    "${CMAKE_COMMAND};--build;${BUILD};--config;${CONFIG}"
    "${CMAKE_COMMAND};-E;chdir;${BUILD};${CTEST};-C;${CONFIG};--output-on-failure;--no-tests=error")
  execute_process(COMMAND ${command} RESULT_VARIABLE result)
  if (result)
    message(FATAL_ERROR "Failed (${result}): ${command}")
  endif ()
endforeach ()
