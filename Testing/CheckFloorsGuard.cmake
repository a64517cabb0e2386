# The test Core.Floors sees an include that runs up, one that is not written from Core's root, a folder
# that the table does not know, and a circle: each is put into a copy of Core, which must be refused.
cmake_minimum_required(VERSION 3.18)
set(core "${CMAKE_CURRENT_LIST_DIR}/../Filters/Core")

# Copies Core, appends a line to a file of the copy, and checks the copy. Sets `output`.
function (check_with file line)
  file(REMOVE_RECURSE "${COPY}")
  file(COPY "${core}/" DESTINATION "${COPY}")
  if (file)
    file(APPEND "${COPY}/${file}" "${line}\n")
  endif ()
  execute_process(
    COMMAND "${CMAKE_COMMAND}" "-DCORE=${COPY}" -P "${CMAKE_CURRENT_LIST_DIR}/CheckFloors.cmake"
    OUTPUT_VARIABLE output ERROR_VARIABLE output RESULT_VARIABLE result)
  string(REGEX REPLACE "[ \n]+" " " output "${output}")
  set(output "${output}" PARENT_SCOPE)
  set(result "${result}" PARENT_SCOPE)
endfunction ()

function (require_refusal file line reason)
  check_with("${file}" "${line}")
  string(FIND "${output}" "${reason}" place)
  if (result EQUAL 0 OR place LESS 0)
    message(SEND_ERROR "${file} with ${line} is not refused for \"${reason}\": ${result} ${output}")
  endif ()
endfunction ()

check_with("" "")
if (NOT result EQUAL 0)
  message(FATAL_ERROR "Core as it is is refused: ${output}")
endif ()
require_refusal(Support/Threads.h "#include \"Mesh/TriangleMesh.h\""
  "Support/Threads.h includes \"Mesh/TriangleMesh.h\"")
require_refusal(Solvers/Multigrid/Cycle.cxx "#include \"Solvers/Eigenpairs/Lanczos.h\""
  "Solvers/Multigrid may include")
require_refusal(Mesh/TriangleMesh.cxx "#include \"Options.h\"" "includes \"Options.h\"")
require_refusal(Mesh/TriangleMesh.cxx "#include \"MergePoints.h\"" "not a path from Filters/Core")
require_refusal(Attic/Old.cxx "" "its folder is not in Floors.txt")
require_refusal(Mesh/TriangleMesh.h "#include \"Mesh/OwnedParts.h\"" "in a circle")
file(REMOVE_RECURSE "${COPY}")
