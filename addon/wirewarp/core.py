# SPDX-License-Identifier: GPL-3.0-or-later
"""Imports the core library, the package wirewarp. Other modules import its names from this module.

- Legacy add-on: the library and its requirements are in _core.
- Extension: Blender installs both from wheels.
"""

import importlib
import platform
import re
import sys
import traceback
from importlib.machinery import EXTENSION_SUFFIXES, PathFinder
from importlib.util import find_spec
from pathlib import Path
from types import ModuleType
from typing import TYPE_CHECKING

_INSIDE = "_core"
_library: ModuleType | None = None
_BINARIES = (".so", ".pyd")
_MADE_FOR = re.compile(r"_wirewarp\.(?:cpython-|cp)(\d)(\d+)-(.+)\.(?:so|pyd)")
_SYSTEMS = {
    "x86_64-linux-gnu": "Linux on x86-64",
    "aarch64-linux-gnu": "Linux on ARM",
    "win_amd64": "Windows on x86-64",
    "darwin": "macOS",
}
_NEWER_GLIBC = re.compile(r"version `GLIBC_([0-9.]+)' not found")
_AGAIN = "Remove WireWarp, restart Blender, and install the zip for your Blender and system again."


class LibraryError(Exception):
    """The library cannot be used; str() is a sentence for the user."""


def load(addon_version: str) -> None:
    """Import the library when the add-on registers. Raise LibraryError if it cannot be used."""
    global _library
    _library = None
    inside = find_spec(f".{_INSIDE}", __package__)
    places = inside.submodule_search_locations if inside else None
    try:
        found = importlib.import_module(f".{_INSIDE}.wirewarp" if inside else "wirewarp", __package__)
        library_version = getattr(found, "__version__", "of an unknown version")
        if library_version == addon_version:
            for part in ("pattern", "report"):  # so that a missing part of the library is noticed now
                importlib.import_module(f"{found.__name__}.{part}")
    except Exception as error:  # a damaged library, or one for another numpy, may raise anything
        traceback.print_exc()
        spec = PathFinder.find_spec("wirewarp", places)  # this runs no code of the library
        folder = Path(spec.submodule_search_locations[0]) if spec and spec.submodule_search_locations else None
        raise LibraryError(loading_problem(error, folder)) from error
    if library_version != addon_version:
        found_one = f"The add-on is WireWarp {addon_version} but the library found is {library_version}."
        raise LibraryError(f"{found_one} {_AGAIN}")
    _library = found


def library() -> ModuleType:
    """Return the package wirewarp. Modules that need the library are imported only after load() has found it."""
    assert _library
    return _library


if TYPE_CHECKING:
    from wirewarp import *  # noqa: F403
    from wirewarp import pattern as pattern
    from wirewarp import report as report
    from wirewarp.report import *  # type: ignore[assignment] # noqa: F403
else:

    def __getattr__(name: str) -> object:
        """Return a name of the library or of its package report, so that `from ..core import Piece, Report` works."""
        if name.startswith("_"):  # Python looks up such names even before load()
            raise AttributeError(name)
        package = library()
        return getattr(package if hasattr(package, name) else package.report, name)


def loading_problem(error: Exception, folder: Path | None) -> str:
    """Return a sentence about an import that failed with this error. folder: folder of the library's files, None if it
    was not found."""
    if isinstance(error, ModuleNotFoundError) and error.name == "numpy":
        return (
            "Blender's Python has no numpy, which WireWarp needs: install it (on Debian and Ubuntu the package "
            "python3-numpy), restart Blender, and enable WireWarp again."
        )
    modules = [file for file in sorted(folder.glob("_wirewarp.*")) if file.suffix in _BINARIES] if folder else []
    if not modules:
        return f"The WireWarp library is not installed beside the add-on. {_AGAIN}"
    if not any(module.name.removeprefix("_wirewarp") in EXTENSION_SUFFIXES for module in modules):
        made_for = " and ".join(_made_for(module.name) for module in modules)
        here = f"Python {sys.version_info.major}.{sys.version_info.minor} on {platform.system()}"
        return f"The installed WireWarp library is for {made_for}, but this Blender has {here}. {_AGAIN}"
    if "incompatible architecture" in str(error):  # the error on macOS, where file names do not contain the processor
        return f"The installed WireWarp library is for Macs with another kind of processor. {_AGAIN}"
    if newer := _NEWER_GLIBC.search(str(error)):
        return (
            f"The WireWarp library needs the C library glibc {newer[1]} or newer, and this system has "
            f"{platform.libc_ver()[1]}. Use a newer Linux, or build WireWarp on this system (see WireWarp's README)."
        )
    return f"The WireWarp library does not load ({type(error).__name__}: {error}): it may be damaged. {_AGAIN}"


def _made_for(name: str) -> str:
    match = _MADE_FOR.fullmatch(name)
    if not match:
        return name
    return f"Python {match[1]}.{match[2]} on {_SYSTEMS.get(match[3], match[3])}"
