# SPDX-License-Identifier: GPL-3.0-or-later
# Builds for another system with the compiler of the package `ziglang`, which has the headers and libraries of all of
# them: -DWIREWARP_ZIG=path of zig, -DWIREWARP_TARGET=zig's word for the system, as x86_64-windows-gnu.
set(CMAKE_TRY_COMPILE_PLATFORM_VARIABLES WIREWARP_ZIG WIREWARP_TARGET)
if(WIREWARP_TARGET MATCHES "^([^-]+)-(windows|macos|linux)")
  set(CMAKE_SYSTEM_PROCESSOR ${CMAKE_MATCH_1})
  set(names_windows Windows)
  set(names_macos Darwin)
  set(names_linux Linux)
  set(CMAKE_SYSTEM_NAME ${names_${CMAKE_MATCH_2}})
else()
  message(FATAL_ERROR "WIREWARP_TARGET=${WIREWARP_TARGET} is no target of zig for Windows, macOS or Linux")
endif()
set(CMAKE_CXX_COMPILER "${WIREWARP_ZIG}" c++ -target ${WIREWARP_TARGET})
set(CMAKE_C_COMPILER "${WIREWARP_ZIG}" cc -target ${WIREWARP_TARGET})
