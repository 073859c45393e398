# SPDX-License-Identifier: GPL-3.0-or-later
# Installs the library with `cmake --install`, so that find_package(wirewarp) finds the target wirewarp::wirewarp.
# The installed library needs no other library. It contains OpenMesh, unless an installed OpenMesh was used, and comes
# with the Eigen headers that it was compiled with.
include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

set(config_folder ${CMAKE_INSTALL_LIBDIR}/cmake/wirewarp)
set(eigen_folder ${CMAKE_INSTALL_INCLUDEDIR}/wirewarp/eigen)
set(find_openmesh)
if(NOT openmesh_sources)
  set(find_openmesh "find_dependency(OpenMesh)")
  target_link_libraries(wirewarp PRIVATE $<INSTALL_INTERFACE:OpenMeshCore>)
endif()
configure_file(cmake/wirewarp-config.cmake.in wirewarp-config.cmake @ONLY)
# SameMinorVersion: as long as the version is 0.x, minor versions may change the API
write_basic_package_version_file(wirewarp-config-version.cmake COMPATIBILITY SameMinorVersion)

# Wheels only contain the component `wirewarp`.
set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME development)
install(TARGETS wirewarp EXPORT wirewarp-targets INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} ${eigen_folder})
install(DIRECTORY native/include/wirewarp DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(DIRECTORY ${eigen_headers}/Eigen DESTINATION ${eigen_folder})
install(EXPORT wirewarp-targets NAMESPACE wirewarp:: DESTINATION ${config_folder})
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/wirewarp-config.cmake
              ${CMAKE_CURRENT_BINARY_DIR}/wirewarp-config-version.cmake DESTINATION ${config_folder})
install(FILES LICENSE THIRD_PARTY.md DESTINATION ${CMAKE_INSTALL_DOCDIR})
