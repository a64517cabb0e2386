# Results are the same with one thread and with several, and one changed digest is found.
cmake_policy(VERSION 3.18)
set(script "${CMAKE_CURRENT_LIST_DIR}/checksums.py")

function (make_checksums file)
  execute_process(
    COMMAND "${PYTHON}" "${script}" --package "${PACKAGE}" --only "^touching-edge$" "${file}"
    RESULT_VARIABLE result)
  if (result)
    message(FATAL_ERROR "${script} ends with ${result}.")
  endif ()
endfunction ()

set(one "${DIRECTORY}/OneThread.txt")
set(several "${DIRECTORY}/SeveralThreads.txt")
set(changed "${DIRECTORY}/Changed.txt")
set(ENV{OMP_NUM_THREADS} 1)
make_checksums("${one}")
unset(ENV{OMP_NUM_THREADS})
make_checksums("${several}")

execute_process(COMMAND "${PYTHON}" "${script}" --compare "${one}" "${several}"
  RESULT_VARIABLE result OUTPUT_VARIABLE output)
if (result OR NOT output MATCHES "All [0-9][0-9][0-9]+ cases are the same")
  message(FATAL_ERROR "Results depend on the number of threads:\n${output}")
endif ()

file(READ "${one}" text)
string(FIND "${text}" "0.point.Direction0=" place)
string(SUBSTRING "${text}" 0 ${place} begin)
string(SUBSTRING "${text}" ${place} -1 end)
string(REGEX REPLACE "^(0.point.Direction0=)[0-9a-f]+" "\\10123456789abcdef" end "${end}")
file(WRITE "${changed}" "${begin}${end}")
execute_process(COMMAND "${PYTHON}" "${script}" --compare "${one}" "${changed}"
  RESULT_VARIABLE result OUTPUT_VARIABLE output)
if (NOT result EQUAL 1 OR NOT output MATCHES "point.Direction0.*\n1 of [0-9]+ cases differ")
  message(FATAL_ERROR "A changed digest is not found:\n${output}")
endif ()
