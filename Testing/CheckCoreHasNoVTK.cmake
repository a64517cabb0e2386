# No file of the Core includes a header of VTK or ParaView.
file(GLOB files "${CMAKE_CURRENT_LIST_DIR}/../Filters/Core/*.h"
  "${CMAKE_CURRENT_LIST_DIR}/../Filters/Core/*.cxx")
list(LENGTH files count)
if (count LESS 5)
  message(FATAL_ERROR "Only ${count} files found")
endif ()
foreach (file IN LISTS files)
  file(STRINGS "${file}" includes REGEX "#[ \t]*include[ \t]*[<\"](vtk|pq|vtkm|paraview)")
  if (includes)
    message(SEND_ERROR "${file}: ${includes}")
  endif ()
endforeach ()
