# Two Debian packages, made by `cpack -G DEB` in the build tree: direction-fields with the plugin,
# the filters' library and their Python package, and direction-fields-dev to build upon them.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_VENDOR "The Direction Fields authors")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_COMPONENTS_ALL runtime development)
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

set(debian "${PROJECT_BINARY_DIR}/Debian")
# The other files of a Debian package tell ParaView of the plugin: from Debian 13 on its configuration
# names a directory for lists of plugins and, beside them, the plugins; before, scripts do it.
set(scripts)
set(pluginLists)
get_filename_component(name "${PARAVIEW_PLUGIN_SUBDIR}" DIRECTORY)
set(configuration "${ParaView_DIR}/../../${name}/paraview.conf")
if (EXISTS "${configuration}")
  file(STRINGS "${configuration}" pluginLists REGEX "^/usr/share/" LIMIT_COUNT 1)
endif ()
if (pluginLists)
  file(RELATIVE_PATH pluginDirectory "${pluginLists}"
    "/usr/${CMAKE_INSTALL_LIBDIR}/${PARAVIEW_PLUGIN_SUBDIR}/DirectionFields")
  file(MAKE_DIRECTORY "${debian}")
  file(CREATE_LINK "${pluginDirectory}" "${debian}/DirectionFields" SYMBOLIC)
  file(RELATIVE_PATH destination /usr "${pluginLists}")
  install(
    FILES "${debian}/DirectionFields" "${PROJECT_BINARY_DIR}/${CMAKE_INSTALL_LIBDIR}/${DIRECTIONFIELDS_PLUGINS_FILE}"
    DESTINATION "${destination}" COMPONENT runtime EXCLUDE_FROM_ALL)
else ()
  foreach (script IN ITEMS postinst postrm)
    configure_file("${CMAKE_CURRENT_LIST_DIR}/Debian/${script}.in" "${debian}/${script}" @ONLY
      FILE_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE
        GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
    list(APPEND scripts "${debian}/${script}")
  endforeach ()
endif ()
set(soversion "${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}")
file(WRITE "${debian}/shlibs"
"libvtkDirectionFieldsFilters ${soversion} direction-fields (= ${version})
libvtkDirectionFieldsFiltersParallel ${soversion} direction-fields (= ${version})
libvtkDirectionFieldsServerManager ${soversion} direction-fields (= ${version})
")
set(CPACK_DEBIAN_RUNTIME_PACKAGE_CONTROL_EXTRA
  ${scripts} "${CMAKE_CURRENT_LIST_DIR}/Debian/prerm" "${debian}/shlibs"
  "${CMAKE_CURRENT_LIST_DIR}/Debian/triggers")
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
foreach (component IN ITEMS RUNTIME DEVELOPMENT)
  string(TOLOWER "${component}" lower)
  install(FILES "${debian}/copyright" "${debian}/changelog.Debian.gz"
    DESTINATION "share/doc/${CPACK_DEBIAN_${component}_PACKAGE_NAME}"
    COMPONENT ${lower} EXCLUDE_FROM_ALL)
endforeach ()
install(FILES "${CMAKE_CURRENT_LIST_DIR}/Debian/lintian-overrides"
  DESTINATION share/lintian/overrides RENAME "${CPACK_DEBIAN_RUNTIME_PACKAGE_NAME}"
  COMPONENT runtime EXCLUDE_FROM_ALL)
include(CPack)
