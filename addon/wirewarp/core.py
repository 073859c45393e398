# SPDX-License-Identifier: GPL-3.0-or-later
"""The only place that imports the core library, the package wirewarp.

The legacy add-on carries it inside (_core/wirewarp); for the extension Blender installs it from a wheel.
"""

import importlib
import sys
from pathlib import Path
from types import ModuleType

_INSIDE = "_core"
_library: ModuleType | None = None
_problem = "The WireWarp library was not loaded: disable and enable the add-on."


class LibraryError(Exception):
    """There is no usable library; str() is a sentence for the user."""


def load(addon_version: str) -> None:
    """Looks for the library once, when the add-on registers. What is wrong is kept for problem()."""
    global _library, _problem
    _library, _problem = None, ""
    inside = (Path(__file__).parent / _INSIDE / "wirewarp").is_dir()
    try:
        found = importlib.import_module(f".{_INSIDE}.wirewarp", __package__) if inside else _import_wheel()
    except ImportError as error:
        python = f"{sys.version_info.major}.{sys.version_info.minor}"
        _problem = (
            f"The WireWarp library does not load in this Blender (Python {python}, {sys.platform}): {error}. "
            "Install the WireWarp zip made for this version of Blender and this system."
        )
        return
    if found.__version__ != addon_version:
        _problem = (
            f"The add-on is WireWarp {addon_version} but the library found is {found.__version__}: "
            "remove WireWarp, restart Blender and install the zip again."
        )
        return
    _library = found


def _import_wheel() -> ModuleType:
    return importlib.import_module("wirewarp")


def problem() -> str:
    """Why there is no library, as a sentence; empty if all is well."""
    return _problem


def library() -> ModuleType:
    """The package wirewarp. Raises LibraryError."""
    if _library is None:
        raise LibraryError(_problem)
    return _library
