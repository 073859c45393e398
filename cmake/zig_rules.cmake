# SPDX-License-Identifier: GPL-3.0-or-later
# Rules for archiving and linking with zig that differ from CMake's.

# This system's archiver cannot read the objects of other systems.
set(CMAKE_CXX_ARCHIVE_CREATE "\"${WIREWARP_ZIG}\" ar qcs <TARGET> <OBJECTS>")
set(CMAKE_CXX_ARCHIVE_FINISH "")

# zig writes modules for macOS as libraries, not bundles; Python loads both.
if(APPLE)
  set(CMAKE_SHARED_MODULE_CREATE_CXX_FLAGS -shared)
endif()
