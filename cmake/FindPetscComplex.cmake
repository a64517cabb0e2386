# PETSc for complex numbers, which the distributed solver of several processes needs. Sets
# DIRECTIONFIELDS_HAVE_PETSC, and where it is there DIRECTIONFIELDS_PETSC_INCLUDE_DIRS and
# DIRECTIONFIELDS_PETSC_LINK_LIBRARIES.
set(DIRECTIONFIELDS_HAVE_PETSC OFF)
if (DIRECTIONFIELDS_USE_PETSC STREQUAL "OFF" OR NOT DIRECTIONFIELDS_HAVE_MPI)
  if (DIRECTIONFIELDS_USE_PETSC STREQUAL "ON")
    message(FATAL_ERROR "DIRECTIONFIELDS_USE_PETSC is ON, but there is no MPI: this VTK has none, or DIRECTIONFIELDS_USE_MPI is OFF.")
  endif ()
  message(STATUS "Distributed solver: none")
  return ()
endif ()

find_package(PkgConfig QUIET)
if (PKG_CONFIG_FOUND)
  # Debian's packages for real and for complex numbers stand side by side; this is that for complex ones.
  set(pkgConfigPath "$ENV{PKG_CONFIG_PATH}")
  set(ENV{PKG_CONFIG_PATH}
    "$ENV{PKG_CONFIG_PATH}:/usr/lib/petscdir/petsc-complex/lib/pkgconfig")
  pkg_check_modules(DIRECTIONFIELDS_PETSC QUIET PETSc)
  set(ENV{PKG_CONFIG_PATH} "${pkgConfigPath}")
endif ()
if (DIRECTIONFIELDS_PETSC_FOUND)
  try_compile(DIRECTIONFIELDS_PETSC_IS_COMPLEX
    "${CMAKE_CURRENT_BINARY_DIR}/CheckPetscComplex"
    "${PROJECT_SOURCE_DIR}/cmake/CheckPetscComplex.cxx"
    LINK_LIBRARIES ${DIRECTIONFIELDS_PETSC_LINK_LIBRARIES} VTK::mpi
    CMAKE_FLAGS "-DINCLUDE_DIRECTORIES=${DIRECTIONFIELDS_PETSC_INCLUDE_DIRS}"
    CXX_STANDARD 17)
  set(DIRECTIONFIELDS_HAVE_PETSC "${DIRECTIONFIELDS_PETSC_IS_COMPLEX}")
endif ()
if (DIRECTIONFIELDS_HAVE_PETSC)
  message(STATUS "Distributed solver: PETSc ${DIRECTIONFIELDS_PETSC_VERSION}")
elseif (DIRECTIONFIELDS_USE_PETSC STREQUAL "ON")
  message(FATAL_ERROR "DIRECTIONFIELDS_USE_PETSC is ON, but PETSc for complex numbers was not found: "
    "install libpetsc-complex-dev, or put the folder of its PETSc.pc into PKG_CONFIG_PATH.")
else ()
  message(STATUS "Distributed solver: none (libpetsc-complex-dev is not installed)")
endif ()
