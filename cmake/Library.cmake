# directionfields_library(NAME
#   [VTK]                       the library stands upon VTK: the module Parallel is made of it
#   [LINKS LIBRARY...]          the libraries below, whose headers this one may include
#   SOURCES FILE...
#   PUBLIC_HEADERS FILE...      installed as <DirectionFields/Folder/Name.h>
#   [SHORT_ROWS FILE...]        sources with loops over rows of sparse matrices, too short to be vectorized
#   [FAST_MATH FILE...])        sources whose loops call the C library's functions for vectors of numbers
#
# A static library DirectionFields::NAME. Sources include from the folder of the library ("Mesh/TriangleMesh.h"), and
# find the folders of the libraries in LINKS, and of those that these link, no others: an include that runs up does not
# compile. The test Libraries.Floors reads LINKS, too.
include(CheckCXXCompilerFlag)
include(PublicHeaders)

# Complex products without the C99 rules for infinities: the factorizations run 2.8 times faster.
check_cxx_compiler_flag("-Werror -fcx-limited-range" DIRECTIONFIELDS_HAVE_CX_LIMITED_RANGE)
# No notes on changes of the ABI of C long ago.
check_cxx_compiler_flag("-Werror -Wno-psabi" DIRECTIONFIELDS_HAVE_NO_PSABI)
check_cxx_compiler_flag("-Werror -fno-tree-loop-vectorize" DIRECTIONFIELDS_HAVE_NO_LOOP_VECTORIZE)

function (directionfields_library name)
  cmake_parse_arguments(PARSE_ARGV 1 library "VTK" ""
    "LINKS;SOURCES;PUBLIC_HEADERS;SHORT_ROWS;FAST_MATH")
  set(target "DirectionFields${name}")
  if (library_VTK)
    # The flags of numerical code and precompiled headers of Eigen are not for these.
    add_library(${target} STATIC ${library_SOURCES})
    target_compile_options(${target} PRIVATE -Wall -Wextra)
  elseif (DIRECTIONFIELDS_LIBRARIES_OF)
    directionfields_take_library(${target} "${DIRECTIONFIELDS_LIBRARIES_OF}/Filters/${name}")
  else ()
    add_library(${target} STATIC ${library_SOURCES} ${library_SHORT_ROWS} ${library_FAST_MATH})
    directionfields_compile_options(${target} "${library_SHORT_ROWS}" "${library_FAST_MATH}")
  endif ()
  add_library(DirectionFields::${name} ALIAS ${target})
  set_target_properties(${target} PROPERTIES
    EXPORT_NAME "${name}"
    CXX_VISIBILITY_PRESET hidden
    VISIBILITY_INLINES_HIDDEN ON)
  target_compile_features(${target} PUBLIC cxx_std_17)
  directionfields_public_headers(${target} ${library_PUBLIC_HEADERS})
  add_dependencies(${target} ${target}Headers)

  set(roots "${CMAKE_CURRENT_SOURCE_DIR}")
  foreach (below IN LISTS library_LINKS)
    get_target_property(more DirectionFields${below} DIRECTIONFIELDS_ROOTS)
    list(APPEND roots ${more})
    target_link_libraries(${target} PUBLIC DirectionFields${below})
  endforeach ()
  list(REMOVE_DUPLICATES roots)
  set_target_properties(${target} PROPERTIES DIRECTIONFIELDS_ROOTS "${roots}")
  target_include_directories(${target} PRIVATE ${roots})

  set(export DirectionFieldsCore)
  if (library_VTK)
    if (BUILD_SHARED_LIBS)
      # The module has swallowed it.
      return ()
    endif ()
    set(export DirectionFieldsParallel)
  endif ()
  install(TARGETS ${target}
    EXPORT ${export}
    ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT development)
endfunction ()

function (directionfields_compile_options target shortRows fastMath)
  target_compile_options(${target} PRIVATE -Wall -Wextra)
  if (DIRECTIONFIELDS_HAVE_CX_LIMITED_RANGE)
    target_compile_options(${target} PRIVATE -fcx-limited-range)
  endif ()
  if (DIRECTIONFIELDS_HAVE_NO_PSABI)
    target_compile_options(${target} PRIVATE -Wno-psabi)
  endif ()
  if (fastMath)
    set_source_files_properties(${fastMath} PROPERTIES
      COMPILE_OPTIONS "-ffast-math" SKIP_PRECOMPILE_HEADERS ON)
  endif ()
  if (shortRows AND DIRECTIONFIELDS_HAVE_NO_LOOP_VECTORIZE)
    set_source_files_properties(${shortRows} PROPERTIES
      COMPILE_OPTIONS "-fno-tree-loop-vectorize" SKIP_PRECOMPILE_HEADERS ON)
  endif ()
  # To read Eigen takes a quarter of the compiler's time. Sources with flags of their own cannot share
  # that.
  if (target STREQUAL "DirectionFieldsFoundation")
    target_precompile_headers(${target} PRIVATE
      <Eigen/Dense> <Eigen/Sparse> <algorithm> <array> <complex> <functional> <vector>)
  else ()
    target_precompile_headers(${target} REUSE_FROM DirectionFieldsFoundation)
  endif ()
endfunction ()

# An empty library is made, and replaced by the one of another build of these sources.
function (directionfields_take_library target directory)
  set(archive "${directory}/${CMAKE_STATIC_LIBRARY_PREFIX}${target}${CMAKE_STATIC_LIBRARY_SUFFIX}")
  set(empty "${CMAKE_CURRENT_BINARY_DIR}/Empty.cxx")
  file(TOUCH "${empty}")
  set_source_files_properties("${empty}" PROPERTIES OBJECT_DEPENDS "${archive}")
  add_library(${target} STATIC "${empty}")
  add_custom_command(TARGET ${target} POST_BUILD
    COMMAND "${CMAKE_COMMAND}" -E copy "${archive}" "$<TARGET_FILE:${target}>")
endfunction ()
