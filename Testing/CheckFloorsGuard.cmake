# The test Libraries.Floors sees an include that runs up, between libraries or inside one, one that is not written from
# a library's root, a folder that no table knows, a full folder and a circle: each is put into a copy of the
# sources, which must be refused.
cmake_minimum_required(VERSION 3.18)
set(filters "${CMAKE_CURRENT_LIST_DIR}/../Filters")

# Copies the sources, appends a line to files of the copy, and checks the copy. Sets `output`.
function (check_with line)
  file(REMOVE_RECURSE "${COPY}")
  file(COPY "${filters}/" DESTINATION "${COPY}")
  foreach (file IN LISTS ARGN)
    file(APPEND "${COPY}/${file}" "${line}\n")
  endforeach ()
  execute_process(
    COMMAND "${CMAKE_COMMAND}" "-DFILTERS=${COPY}" -P "${CMAKE_CURRENT_LIST_DIR}/CheckFloors.cmake"
    OUTPUT_VARIABLE output ERROR_VARIABLE output RESULT_VARIABLE result)
  string(REGEX REPLACE "[ \n]+" " " output "${output}")
  set(output "${output}" PARENT_SCOPE)
  set(result "${result}" PARENT_SCOPE)
endfunction ()

function (require_refusal reason line)
  check_with("${line}" ${ARGN})
  string(FIND "${output}" "${reason}" place)
  if (result EQUAL 0 OR place LESS 0)
    message(SEND_ERROR "${ARGN} with ${line} is not refused for \"${reason}\": ${result} ${output}")
  endif ()
endfunction ()

check_with("")
if (NOT result EQUAL 0)
  message(FATAL_ERROR "The sources as they are are refused: ${output}")
endif ()
require_refusal("which no folder of Foundation has"
  "#include \"Mesh/TriangleMesh.h\"" Foundation/Support/Threads.h)
require_refusal("which no folder of LinearAlgebra, Foundation has"
  "#include \"Mesh/TriangleMesh.h\"" LinearAlgebra/Matrices/SparseProducts.cxx)
require_refusal("Multigrid may include"
  "#include \"Eigenpairs/Lanczos.h\"" LinearAlgebra/Multigrid/Cycle.cxx)
require_refusal("Sections may include" "#include \"Options.h\"" Fields/Sections/Assembly.cxx)
require_refusal("includes \"MergePoints.h\", which no folder"
  "#include \"MergePoints.h\"" Surfaces/Mesh/TriangleMesh.cxx)
require_refusal("its folder is not in Surfaces/Floors.txt" "" Surfaces/Attic/Old.cxx)
require_refusal("which no folder of Pieces, Foundation has" "#include \"Options.h\"" Pieces/SurfacePiece.h)
require_refusal("which no folder of VTK has" "#include \"Support/MortonCurve.h\"" VTK/Support/DefaultThreads.cxx)
require_refusal("which no folder of Parallel, "
  "#include \"Options.h\"" Parallel/Gathering/Scattering.cxx)
require_refusal("Support may include" "#include \"vtkDirectionField.h\"" VTK/Support/DefaultThreads.cxx)
require_refusal("Mesh may include" "#include \"Solver/PetscObjects.h\"" Cluster/Mesh/SharedPoints.h)
require_refusal("Gathering may include"
  "#include \"vtkPDirectionField.h\"" Parallel/Gathering/Scattering.cxx)
require_refusal("in a circle" "#include \"Mesh/OwnedParts.h\"" Surfaces/Mesh/TriangleMesh.h)
set(crowd)
foreach (number RANGE 1 12)
  list(APPEND crowd "Drawing/Streamlines/Room${number}.h")
endforeach ()
require_refusal("Drawing/Streamlines has" "" ${crowd})
file(REMOVE_RECURSE "${COPY}")
