# SPDX-License-Identifier: GPL-3.0-or-later
# Builds for another system with the compiler of the package `ziglang`, which has the headers and libraries of all
# systems. Set -DWIREWARP_ZIG to the path of zig, and -DWIREWARP_TARGET to zig's name of the system, such as
# x86_64-windows-gnu.
set(CMAKE_TRY_COMPILE_PLATFORM_VARIABLES WIREWARP_ZIG WIREWARP_TARGET)
if(WIREWARP_TARGET MATCHES "^([^-]+)-(windows|macos|linux)")
  set(CMAKE_SYSTEM_PROCESSOR ${CMAKE_MATCH_1})
  set(names_windows Windows)
  set(names_macos Darwin)
  set(names_linux Linux)
  set(CMAKE_SYSTEM_NAME ${names_${CMAKE_MATCH_2}})
else()
  message(FATAL_ERROR "WIREWARP_TARGET=${WIREWARP_TARGET} is not a target of zig for Windows, macOS or Linux")
endif()
set(CMAKE_CXX_COMPILER "${WIREWARP_ZIG}" c++)
# Linking would make zig compile its own libraries first, without optimization. Therefore, CMake must not link before
# the build. With a target, it does not link to identify the compiler. With STATIC_LIBRARY, it does not link to test the
# compiler.
set(CMAKE_CXX_COMPILER_TARGET ${WIREWARP_TARGET})
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)
set(CMAKE_CXX_FLAGS_INIT -g0)  # otherwise zig adds debug information, which takes a fifth of the time
set(CMAKE_USER_MAKE_RULES_OVERRIDE_CXX "${CMAKE_CURRENT_LIST_DIR}/zig_rules.cmake")
