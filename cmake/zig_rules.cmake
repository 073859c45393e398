# SPDX-License-Identifier: GPL-3.0-or-later
# How zig archives and links where CMake would do it otherwise.

# This system's archiver knows no other system's objects.
set(CMAKE_CXX_ARCHIVE_CREATE "\"${WIREWARP_ZIG}\" ar qcs <TARGET> <OBJECTS>")
set(CMAKE_CXX_ARCHIVE_FINISH "")

# Of macOS' two kinds of module zig writes libraries, not bundles; Python loads either.
if(APPLE)
  set(CMAKE_SHARED_MODULE_CREATE_CXX_FLAGS -shared)
endif()
