# Runs the Python of the README as it stands there, in a directory that looks like the
# project's.
include("${CMAKE_CURRENT_LIST_DIR}/ExtractReadme.cmake")
file(REMOVE_RECURSE "${DIRECTORY}")
file(MAKE_DIRECTORY "${DIRECTORY}")
file(CREATE_LINK "${SOURCE}/Data" "${DIRECTORY}/Data" SYMBOLIC)
file(CREATE_LINK "${BUILD}" "${DIRECTORY}/build" SYMBOLIC)
extract_blocks("${SOURCE}/README.md" python "${DIRECTORY}/script.py")
execute_process(COMMAND "${PVPYTHON}" script.py WORKING_DIRECTORY "${DIRECTORY}"
  RESULT_VARIABLE result OUTPUT_VARIABLE text ERROR_VARIABLE error)
message("${text}${error}")
if (result OR error MATCHES "ERR\\||WARN\\||Traceback" OR NOT text MATCHES "index sum 8")
  message(FATAL_ERROR "The script failed (${result}).")
endif ()
foreach (file IN ITEMS field.vtp singularities.vtp field.png)
  if (NOT EXISTS "${DIRECTORY}/${file}")
    message(FATAL_ERROR "The script wrote no ${file}.")
  endif ()
endforeach ()
