# SPDX-License-Identifier: GPL-3.0-or-later
"""Provides the compiler of the package `ziglang`: Clang with the headers and libraries of every system."""

from pathlib import Path

from tools.environment import DEBIAN_PYTHON, venv

ZIG = "ziglang==0.17.1"


def zig() -> Path:
    """Return the program itself, so that CMake and its caches see one compiler."""
    (program,) = venv("zig", DEBIAN_PYTHON, ZIG).parent.parent.glob("lib/python*/site-packages/ziglang/zig")
    return program


def cache_variables(folder: Path) -> dict[str, str]:
    """Return variables for zig's cache folders. They also contain zig's own libraries, which take minutes to build the
    first time.
    """
    return {"ZIG_GLOBAL_CACHE_DIR": str(folder), "ZIG_LOCAL_CACHE_DIR": str(folder)}
