# SPDX-License-Identifier: GPL-3.0-or-later
"""Why the core library does not load here, as a sentence with the remedy. No Blender in here."""

import platform
import re
import sys
from importlib.machinery import EXTENSION_SUFFIXES, PathFinder
from pathlib import Path

_BINARIES = (".so", ".pyd")
_MADE_FOR = re.compile(r"_wirewarp\.(?:cpython-|cp)(\d)(\d+)-(.+)\.(?:so|pyd)")
_SYSTEMS = {"x86_64-linux-gnu": "Linux on x86-64", "win_amd64": "Windows on x86-64", "darwin": "macOS"}
_NEWER_GLIBC = re.compile(r"version `GLIBC_([0-9.]+)' not found")
_AGAIN = "Remove WireWarp, restart Blender, and install the zip for your Blender and system again."


def folder_of(package: str) -> Path | None:
    """Where the package would be imported from, None if it is nowhere. Runs none of its code."""
    spec = PathFinder.find_spec(package)
    return Path(spec.submodule_search_locations[0]) if spec and spec.submodule_search_locations else None


def loading_problem(error: Exception, folder: Path | None) -> str:
    """error: what importing the library raised; folder: where its files are, None if there are none."""
    modules = [file for file in sorted(folder.glob("_wirewarp.*")) if file.suffix in _BINARIES] if folder else []
    if not modules:
        return f"The WireWarp library is not installed beside the add-on. {_AGAIN}"
    if not any(module.name.removeprefix("_wirewarp") in EXTENSION_SUFFIXES for module in modules):
        made_for = " and ".join(_made_for(module.name) for module in modules)
        here = f"Python {sys.version_info.major}.{sys.version_info.minor} on {platform.system()}"
        return f"The WireWarp library that is installed is made for {made_for}; this Blender has {here}. {_AGAIN}"
    if newer := _NEWER_GLIBC.search(str(error)):
        return (
            f"The WireWarp library needs the C library glibc {newer[1]} or newer, and this system has "
            f"{platform.libc_ver()[1]}: use a newer Linux, or build WireWarp on this one (see its README)."
        )
    return f"The WireWarp library does not load ({type(error).__name__}: {error}): it may be damaged. {_AGAIN}"


def version_problem(addon_version: str, library_version: str) -> str:
    return f"The add-on is WireWarp {addon_version} but the library found is {library_version}. {_AGAIN}"


def _made_for(name: str) -> str:
    match = _MADE_FOR.fullmatch(name)
    if not match:
        return name
    return f"Python {match[1]}.{match[2]} on {_SYSTEMS.get(match[3], match[3])}"
