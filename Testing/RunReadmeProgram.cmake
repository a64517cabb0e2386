# Builds the C++ program for VTK as it stands on the PAGE for C++, with the package installed in PREFIX, and
# runs it on MESH.
include("${CMAKE_CURRENT_LIST_DIR}/ExtractReadme.cmake")
file(REMOVE_RECURSE "${BUILD}")
extract_blocks_below("${PAGE}" "With VTK" cmake "${BUILD}/CMakeLists.txt")
extract_blocks_below("${PAGE}" "With VTK" cpp "${BUILD}/app.cxx")
foreach (command IN ITEMS
    "${CMAKE_COMMAND};-S;${BUILD};-B;${BUILD}/build;-G;${GENERATOR};-DCMAKE_PREFIX_PATH=${PREFIX};\
-DCMAKE_BUILD_TYPE=${CONFIG};-DCMAKE_CXX_COMPILER=${CXX};-DVTK_DIR=${VTK_DIR}"
    "${CMAKE_COMMAND};--build;${BUILD}/build;--config;${CONFIG}")
  execute_process(COMMAND ${command} RESULT_VARIABLE result)
  if (result)
    message(FATAL_ERROR "Failed (${result}): ${command}")
  endif ()
endforeach ()
find_program(app NAMES app PATHS "${BUILD}/build" "${BUILD}/build/${CONFIG}"
  NO_DEFAULT_PATH REQUIRED)
execute_process(COMMAND "${app}" "${MESH}" RESULT_VARIABLE result OUTPUT_VARIABLE text)
message("${text}")
if (result OR NOT text MATCHES "^1839 points, 32 singularities\n$")
  message(FATAL_ERROR "The program failed (${result}).")
endif ()
