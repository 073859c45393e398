# SPDX-License-Identifier: GPL-3.0-or-later
"""Provides the compiler of the package `ziglang`: Clang with the headers and libraries of every system."""

from pathlib import Path

from tools.environment import DEBIAN_PYTHON, venv

ZIG = "ziglang==0.17.1"


def zig() -> Path:
    """Return the path of the compiler's program, so that CMake and ccache see one compiler."""
    (program,) = venv("zig", DEBIAN_PYTHON, ZIG).parent.parent.glob("lib/python*/site-packages/ziglang/zig")
    return program


def cache_variables(folder: Path) -> dict[str, str]:
    """Return environment variables for zig's cache. It also contains zig's libraries, which take minutes to build."""
    return {"ZIG_GLOBAL_CACHE_DIR": str(folder), "ZIG_LOCAL_CACHE_DIR": str(folder)}
