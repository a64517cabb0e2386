# CMakeLists.txt, the newest entry of CHANGELOG.md, CITATION.cff and the version that Testing/Consumer
# asks for agree.
set(root "${CMAKE_CURRENT_LIST_DIR}/..")

# read_version(VARIABLE FILE REGEX): what the group of the regular expression matches first.
function (read_version variable file regex)
  file(READ "${root}/${file}" text)
  if (NOT text MATCHES "${regex}")
    message(FATAL_ERROR "${file} has no version")
  endif ()
  set(${variable} "${CMAKE_MATCH_1}" PARENT_SCOPE)
endfunction ()

read_version(project CMakeLists.txt "project\\(DirectionFields VERSION ([0-9]+\\.[0-9]+\\.[0-9]+)")
# The entries follow each other from the newest to the oldest.
read_version(changelog CHANGELOG.md "\n## \\[([^]\n]*)\\]")
read_version(citation CITATION.cff "\nversion: ([^ \n]*)\n")
read_version(consumer Testing/Consumer/CMakeLists.txt "find_package\\(DirectionFields ([^ ]*) ")
foreach (version IN ITEMS changelog citation)
  if (NOT ${version} STREQUAL project)
    message(SEND_ERROR "CMakeLists.txt has version ${project}, the ${version} ${${version}}")
  endif ()
endforeach ()
string(REGEX MATCH "^[0-9]+\\.[0-9]+" minor "${project}")
if (NOT consumer STREQUAL minor)
  message(SEND_ERROR "Testing/Consumer asks for ${consumer}, not for ${minor}")
endif ()

# A released version has a date in both files, another one in none.
file(READ "${root}/CHANGELOG.md" changelogText)
file(READ "${root}/CITATION.cff" citationText)
string(REGEX MATCH "\n## \\[[^]\n]*\\] - ([^\n]*)" entry "${changelogText}")
set(released "${CMAKE_MATCH_1}")
set(cited "unreleased")
if (citationText MATCHES "\ndate-released: \"?([0-9-]+)")
  set(cited "${CMAKE_MATCH_1}")
endif ()
if (NOT released STREQUAL cited)
  message(SEND_ERROR "CHANGELOG.md says ${released}, CITATION.cff ${cited}")
endif ()
