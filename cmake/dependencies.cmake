# SPDX-License-Identifier: GPL-3.0-or-later
# Finds installed copies of Eigen and OpenMesh, or downloads tagged releases.
#   eigen_headers       include folder
#   wirewarp_openmesh   target with the headers, and with the library if it is installed
#   openmesh_sources    if OpenMesh is not installed: the sources of its half-edge mesh, compiled into our library
# FETCHCONTENT_SOURCE_DIR_EIGEN and FETCHCONTENT_SOURCE_DIR_OPENMESH name folders with the sources, which are used
# instead of installed copies. The source package for PyPI contains the sources of both libraries.
include(FetchContent)

FetchContent_Declare(
  Eigen
  GIT_REPOSITORY https://gitlab.com/libeigen/eigen.git
  GIT_TAG 3.4.0
  GIT_SHALLOW ON
  SOURCE_SUBDIR headers-only  # a folder that does not exist, so that nothing of Eigen is built
)
FetchContent_Declare(
  OpenMesh
  GIT_REPOSITORY https://gitlab.vci.rwth-aachen.de:9000/OpenMesh/OpenMesh.git
  GIT_TAG OpenMesh-11.0
  GIT_SHALLOW ON
  SOURCE_SUBDIR built-by-us  # does not exist, because OpenMesh's own build makes much that we do not need
)
set(inside ${CMAKE_CURRENT_SOURCE_DIR}/libraries)
if(EXISTS ${inside})
  set(FETCHCONTENT_SOURCE_DIR_EIGEN ${inside}/eigen)
  set(FETCHCONTENT_SOURCE_DIR_OPENMESH ${inside}/openmesh)
endif()

if(NOT FETCHCONTENT_SOURCE_DIR_EIGEN)
  find_package(Eigen3 3.4 QUIET NO_MODULE)
endif()
if(TARGET Eigen3::Eigen)
  get_target_property(eigen_headers Eigen3::Eigen INTERFACE_INCLUDE_DIRECTORIES)
else()
  FetchContent_MakeAvailable(Eigen)
  set(eigen_headers ${eigen_SOURCE_DIR})
endif()

add_library(wirewarp_openmesh INTERFACE)
set(openmesh_sources)
if(NOT FETCHCONTENT_SOURCE_DIR_OPENMESH)
  find_package(OpenMesh QUIET)
endif()
if(TARGET OpenMeshCore)
  target_link_libraries(wirewarp_openmesh INTERFACE OpenMeshCore)
else()
  FetchContent_MakeAvailable(OpenMesh)
  set(core ${openmesh_SOURCE_DIR}/src/OpenMesh/Core)
  file(GLOB openmesh_sources ${core}/Mesh/*.cc ${core}/Utils/BaseProperty.cc ${core}/System/omstream.cc)
  set_source_files_properties(${openmesh_sources} PROPERTIES COMPILE_OPTIONS -w
                              COMPILE_DEFINITIONS "NOMINMAX;_USE_MATH_DEFINES")  # as in OpenMesh's build for Windows
  target_include_directories(wirewarp_openmesh SYSTEM INTERFACE ${core}/../..)  # SYSTEM hides warnings of the headers
endif()
