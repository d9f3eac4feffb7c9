# SPDX-FileCopyrightText: 2026 The WCAM developers
# SPDX-License-Identifier: GPL-3.0-or-later
# cmake --install: components engine, cli, gui, plugins, data and sdk. The installed tree finds its parts
# relative to the engine library, so it may be moved to any folder.
include(CMakePackageConfigHelpers)

set(wcam_package_dir "${CMAKE_INSTALL_LIBDIR}/cmake/wcam")
set(WCAM_DATA_DIR "${CMAKE_INSTALL_DATADIR}/wcam")

install(TARGETS wcam_engine EXPORT wcamTargets
  LIBRARY DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT engine NAMELINK_COMPONENT sdk
  INCLUDES DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}")
file(RELATIVE_PATH library_from_program "/prefix/${CMAKE_INSTALL_BINDIR}" "/prefix/${CMAKE_INSTALL_LIBDIR}")
if(TARGET camcli)
  set_target_properties(camcli PROPERTIES INSTALL_RPATH "$ORIGIN/${library_from_program}")
  install(TARGETS camcli RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}" COMPONENT cli)
  install(FILES "${PROJECT_SOURCE_DIR}/packaging/camcli.1" DESTINATION "${CMAKE_INSTALL_MANDIR}/man1" COMPONENT cli)
  # From the option table of the program that was just built.
  set(completion "${PROJECT_BINARY_DIR}/package/completion")
  file(MAKE_DIRECTORY "${completion}")
  add_custom_command(OUTPUT "${completion}/camcli" "${completion}/_camcli" VERBATIM
    COMMAND camcli completion bash > "${completion}/camcli"
    COMMAND camcli completion zsh > "${completion}/_camcli"
    DEPENDS camcli)
  add_custom_target(wcam_completion ALL DEPENDS "${completion}/camcli" "${completion}/_camcli")
  install(FILES "${completion}/camcli" DESTINATION "${CMAKE_INSTALL_DATADIR}/bash-completion/completions" COMPONENT cli)
  # Debian's zsh looks for those of packages in the first folder, for those of /usr/local in the second.
  foreach(functions vendor-completions site-functions)
    install(FILES "${completion}/_camcli" DESTINATION "${CMAKE_INSTALL_DATADIR}/zsh/${functions}" COMPONENT cli)
  endforeach()
endif()

if(TARGET wcam)
  set_target_properties(wcam PROPERTIES INSTALL_RPATH "$ORIGIN/${library_from_program}")
  install(TARGETS wcam RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}" COMPONENT gui)
  install(FILES "${PROJECT_SOURCE_DIR}/packaging/wcam.1" DESTINATION "${CMAKE_INSTALL_MANDIR}/man1" COMPONENT gui)
  set(desktop "${PROJECT_SOURCE_DIR}/packaging/desktop")
  install(FILES "${desktop}/org.wcam.wcam.desktop" DESTINATION "${CMAKE_INSTALL_DATADIR}/applications" COMPONENT gui)
  install(FILES "${desktop}/org.wcam.wcam.xml" DESTINATION "${CMAKE_INSTALL_DATADIR}/mime/packages" COMPONENT gui)
  install(FILES "${desktop}/org.wcam.wcam.metainfo.xml" DESTINATION "${CMAKE_INSTALL_DATADIR}/metainfo" COMPONENT gui)
  install(FILES "${PROJECT_SOURCE_DIR}/resources/icons/org.wcam.wcam.svg"
    DESTINATION "${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps" COMPONENT gui)
endif()

foreach(folder cells processes projects doc schema)
  install(DIRECTORY "${PROJECT_SOURCE_DIR}/resources/${folder}" DESTINATION "${WCAM_DATA_DIR}" COMPONENT data)
endforeach()
install(FILES "${PROJECT_SOURCE_DIR}/LICENSE" DESTINATION "${CMAKE_INSTALL_DOCDIR}" COMPONENT engine)

install(DIRECTORY "${PROJECT_SOURCE_DIR}/engine/include/wcam" DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}" COMPONENT sdk
  FILES_MATCHING PATTERN "*.hpp" PATTERN "*.h")
install(DIRECTORY "${PROJECT_SOURCE_DIR}/plugins/example_post" DESTINATION "${WCAM_DATA_DIR}/examples" COMPONENT sdk)
install(EXPORT wcamTargets NAMESPACE wcam:: DESTINATION "${wcam_package_dir}" COMPONENT sdk)
configure_package_config_file("${CMAKE_CURRENT_LIST_DIR}/wcamConfig.cmake.in"
  "${PROJECT_BINARY_DIR}/package/wcamConfig.cmake"
  INSTALL_DESTINATION "${wcam_package_dir}" PATH_VARS WCAM_DATA_DIR)
# Until 1.0 a new minor version may change the interfaces.
write_basic_package_version_file("${PROJECT_BINARY_DIR}/package/wcamConfigVersion.cmake"
  COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/package/wcamConfig.cmake"
  "${PROJECT_BINARY_DIR}/package/wcamConfigVersion.cmake" "${CMAKE_CURRENT_LIST_DIR}/WcamPlugin.cmake"
  DESTINATION "${wcam_package_dir}" COMPONENT sdk)

# The build tree has the layout of the installed one: programs find the resources the same way.
file(MAKE_DIRECTORY "${CMAKE_BINARY_DIR}/${CMAKE_INSTALL_DATADIR}")
file(CREATE_LINK "${PROJECT_SOURCE_DIR}/resources" "${CMAKE_BINARY_DIR}/${WCAM_DATA_DIR}" SYMBOLIC)
