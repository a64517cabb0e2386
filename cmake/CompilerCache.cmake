# Where ccache is installed, a source that was compiled before is not compiled again, whichever folder the build was in:
# a clean clone beside an older one, or the builds of Utilities/test after a change elsewhere. With
# -DCMAKE_CXX_COMPILER_LAUNCHER= (empty) it is not used.
find_program(DIRECTIONFIELDS_CCACHE ccache)
mark_as_advanced(DIRECTIONFIELDS_CCACHE)
if (DIRECTIONFIELDS_CCACHE AND NOT DEFINED CMAKE_CXX_COMPILER_LAUNCHER AND
    CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # Paths below the sources and the build are made relative, so that they do not tell two folders apart. Precompiled
  # headers change only with what they include, whatever their times are.
  set(CMAKE_CXX_COMPILER_LAUNCHER "${CMAKE_COMMAND}" -E env
    "CCACHE_BASEDIR=${PROJECT_SOURCE_DIR}" CCACHE_NOHASHDIR=1
    "CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime"
    "${DIRECTIONFIELDS_CCACHE}")
  add_compile_options("$<$<COMPILE_LANGUAGE:CXX>:-fpch-preprocess>")
endif ()
