# SPDX-License-Identifier: GPL-3.0-or-later
# Builds for Windows with the compiler of the package `ziglang`, which has its headers and libraries:
# -DWIREWARP_ZIG=path of zig.
set(CMAKE_TRY_COMPILE_PLATFORM_VARIABLES WIREWARP_ZIG)
set(CMAKE_SYSTEM_NAME Windows)
set(CMAKE_SYSTEM_PROCESSOR AMD64)
set(CMAKE_CXX_COMPILER "${WIREWARP_ZIG}" c++ -target x86_64-windows-gnu)
set(CMAKE_C_COMPILER "${WIREWARP_ZIG}" cc -target x86_64-windows-gnu)
