# The other files of the Debian package with the plugin tell ParaView of it: from Debian 13 on
# ParaView's configuration names a directory for lists of plugins and, beside them, the plugins;
# before, scripts do it.
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
  ${scripts} "${debian}/runtime/prerm" "${debian}/shlibs"
  "${CMAKE_CURRENT_LIST_DIR}/Debian/triggers")
install(FILES "${CMAKE_CURRENT_LIST_DIR}/Debian/lintian-overrides"
  DESTINATION share/lintian/overrides RENAME "${CPACK_DEBIAN_RUNTIME_PACKAGE_NAME}"
  COMPONENT runtime EXCLUDE_FROM_ALL)
