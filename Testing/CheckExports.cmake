# The library LIBRARY exports the filters, and no function of what they are made of, by what NM lists; but for the run on
# several processes, which public templates hold.
execute_process(COMMAND "${NM}" -DC --defined-only "${LIBRARY}"
  OUTPUT_VARIABLE symbols RESULT_VARIABLE result)
if (result)
  message(FATAL_ERROR "${NM} failed: ${result}")
endif ()
if (NOT symbols MATCHES " T ${CLASS}::New\\(\\)")
  message(FATAL_ERROR "${LIBRARY} does not export ${CLASS}.")
endif ()
string(REGEX MATCHALL "[^\n]* [TBDVW] DirectionFields::[^\n]*" inner "${symbols}")
list(FILTER inner EXCLUDE REGEX " DirectionFields::Parallel::GatheringRun::")
if (inner)
  list(LENGTH inner count)
  list(GET inner 0 first)
  message(FATAL_ERROR "${LIBRARY} exports ${count} inner functions, among them:${first}")
endif ()
