# SPDX-License-Identifier: GPL-3.0-or-later
# Defines wirewarp_eigen and wirewarp_openmesh: each library as installed, else from its tagged release.
# FETCHCONTENT_SOURCE_DIR_EIGEN and FETCHCONTENT_SOURCE_DIR_OPENMESH name folders to take the sources from; then no
# installed one is looked for.
include(FetchContent)

FetchContent_Declare(
  Eigen
  GIT_REPOSITORY https://gitlab.com/libeigen/eigen.git
  GIT_TAG 3.4.0
  GIT_SHALLOW ON
  SOURCE_SUBDIR headers-only  # there is no such folder: nothing of Eigen is to be built
)
FetchContent_Declare(
  OpenMesh
  GIT_REPOSITORY https://gitlab.vci.rwth-aachen.de:9000/OpenMesh/OpenMesh.git
  GIT_TAG OpenMesh-11.0
  GIT_SHALLOW ON
)

add_library(wirewarp_eigen INTERFACE)
if(NOT FETCHCONTENT_SOURCE_DIR_EIGEN)
  find_package(Eigen3 3.4 QUIET NO_MODULE)
endif()
if(TARGET Eigen3::Eigen)
  target_link_libraries(wirewarp_eigen INTERFACE Eigen3::Eigen)
else()
  FetchContent_MakeAvailable(Eigen)
  target_include_directories(wirewarp_eigen SYSTEM INTERFACE ${eigen_SOURCE_DIR})
endif()

# A function, so that what OpenMesh's build needs to be set holds for it alone.
function(build_openmesh)
  set(BUILD_APPS OFF)
  set(CMAKE_POLICY_DEFAULT_CMP0077 NEW)
  set(CMAKE_POLICY_VERSION_MINIMUM 3.5)  # it asks for less than newer CMakes still know
  set(CMAKE_COMPILE_WARNING_AS_ERROR OFF)
  FetchContent_MakeAvailable(OpenMesh)
  set_property(DIRECTORY ${openmesh_SOURCE_DIR} PROPERTY EXCLUDE_FROM_ALL ON)  # what nobody links is not built
  set(library OpenMeshCoreStatic)
  if(WIN32)
    set(library OpenMeshCore)  # static there, and the only one
  endif()
  # Its headers do not keep to our warnings.
  get_target_property(headers ${library} INTERFACE_INCLUDE_DIRECTORIES)
  set_target_properties(${library} PROPERTIES INTERFACE_SYSTEM_INCLUDE_DIRECTORIES "${headers}")
  target_link_libraries(wirewarp_openmesh INTERFACE ${library})
endfunction()

add_library(wirewarp_openmesh INTERFACE)
if(NOT FETCHCONTENT_SOURCE_DIR_OPENMESH)
  find_package(OpenMesh QUIET)
endif()
if(TARGET OpenMeshCore)
  target_link_libraries(wirewarp_openmesh INTERFACE OpenMeshCore)
else()
  build_openmesh()
endif()
