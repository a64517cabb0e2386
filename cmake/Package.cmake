# Debian packages, made by `cpack -G DEB` in the build tree: direction-fields with the plugin, the
# filters' library and their Python package, and direction-fields-dev to build upon them, where the
# plugin is built; python3-direction-fields where the package for NumPy is.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_VENDOR "The Direction Fields authors")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "Globally optimal direction fields on surfaces")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_COMPONENTS_ALL)
if (DIRECTIONFIELDS_BUILD_VTK AND DIRECTIONFIELDS_BUILD_PLUGIN)
  list(APPEND CPACK_COMPONENTS_ALL runtime development)
endif ()
if (DIRECTIONFIELDS_BUILD_NUMPY)
  list(APPEND CPACK_COMPONENTS_ALL numpy)
endif ()
set(CPACK_DEB_COMPONENT_INSTALL ON)

# As with Debian's own tools, who builds the packages is who maintains them.
set(maintainer "The Direction Fields authors <direction-fields@localhost>")
if (DEFINED ENV{DEBEMAIL})
  set(maintainer "$ENV{DEBFULLNAME} <$ENV{DEBEMAIL}>")
endif ()
set(CPACK_DEBIAN_PACKAGE_MAINTAINER "${maintainer}" CACHE STRING "Who maintains the packages")
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)

set(CPACK_DEBIAN_RUNTIME_PACKAGE_NAME direction-fields)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SECTION science)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_RUNTIME_DESCRIPTION
"Smooth n-direction fields on surfaces: vector, line, cross and hex fields
for remeshing, texture, hatching and fibre layout. The field of each
connected component is the global optimum of its smoothness energy, on its
own or drawn to curvature, to features or to given vectors.

This package has the VTK filters, their Python package, and the ParaView
plugin DirectionFields, which ParaView lists in its plugin manager.")
if (DIRECTIONFIELDS_WRAP_PYTHON)
  set(CPACK_DEBIAN_RUNTIME_PACKAGE_DEPENDS "python3")
endif ()
set(CPACK_DEBIAN_RUNTIME_PACKAGE_RECOMMENDS "python3-paraview, python3-numpy")

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME direction-fields-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(version "${PROJECT_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE}")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS
  "direction-fields (= ${version}), libeigen3-dev, paraview-dev")
if (NOT VTK_DIR MATCHES "/paraview-")
  # ParaView is built upon Debian's VTK.
  string(APPEND CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS ", libvtk9-dev")
endif ()
set(CPACK_DEBIAN_DEVELOPMENT_DESCRIPTION
"This package has the headers, the static libraries of DirectionFields::Core and the
CMake package for programs that compute direction fields, with VTK or without.")

set(CPACK_DEBIAN_NUMPY_PACKAGE_NAME python3-direction-fields)
set(CPACK_DEBIAN_NUMPY_PACKAGE_SECTION python)
set(CPACK_DEBIAN_NUMPY_PACKAGE_SHLIBDEPS ON)
if (DIRECTIONFIELDS_BUILD_NUMPY)
  # Its module is for one version of Python.
  math(EXPR next "${Python3_VERSION_MINOR} + 1")
  set(CPACK_DEBIAN_NUMPY_PACKAGE_DEPENDS
    "python3 (>= 3.${Python3_VERSION_MINOR}), python3 (<< 3.${next}), python3-numpy")
endif ()
set(CPACK_DEBIAN_NUMPY_PACKAGE_SUGGESTS "python3-pyvista")
set(CPACK_DEBIAN_NUMPY_DESCRIPTION
"Smooth n-direction fields on surfaces, on NumPy arrays: fields, lines along
them, stripes, meshes of quads, edited singularities, and files of other
programs. PyVista's surfaces have them as mesh.directions.")

set(debian "${PROJECT_BINARY_DIR}/Debian")
function (write_prerm component module)
  configure_file(
    "${CMAKE_CURRENT_FUNCTION_LIST_DIR}/Debian/prerm.in" "${debian}/${component}/prerm" @ONLY
    FILE_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE
      GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
endfunction ()
write_prerm(runtime directionfields_vtk)
write_prerm(numpy direction_fields)
set(CPACK_DEBIAN_NUMPY_PACKAGE_CONTROL_EXTRA "${debian}/numpy/prerm")
if (runtime IN_LIST CPACK_COMPONENTS_ALL)
  include(PackagePlugin)
endif ()
file(READ LICENSE license)
string(REGEX REPLACE "\n\n" "\n.\n" license "${license}")
string(REGEX REPLACE "\n([^\n])" "\n \\1" license "${license}")
file(WRITE "${debian}/copyright"
"Format: https://www.debian.org/doc/packaging-manuals/copyright-format/1.0/

Files: *
Copyright: the Direction Fields authors
License: BSD-3-Clause
 ${license}")
string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)
file(WRITE "${debian}/changelog.Debian"
"direction-fields (${version}) unstable; urgency=medium

  * Version ${PROJECT_VERSION}.

 -- ${CPACK_DEBIAN_PACKAGE_MAINTAINER}  ${date}
")
execute_process(COMMAND gzip -9nkf "${debian}/changelog.Debian")
foreach (component IN LISTS CPACK_COMPONENTS_ALL)
  string(TOUPPER "${component}" upper)
  install(FILES "${debian}/copyright" "${debian}/changelog.Debian.gz"
    DESTINATION "share/doc/${CPACK_DEBIAN_${upper}_PACKAGE_NAME}"
    COMPONENT ${component} EXCLUDE_FROM_ALL)
endforeach ()
include(CPack)
