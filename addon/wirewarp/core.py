# SPDX-License-Identifier: GPL-3.0-or-later
"""The only place that imports the core library, the package wirewarp.

The legacy add-on carries it inside (_core/wirewarp); for the extension Blender installs it from a wheel.
"""

import importlib
import traceback
from pathlib import Path
from types import ModuleType

from .library_problem import folder_of, loading_problem, version_problem

_INSIDE = "_core"
_library: ModuleType | None = None
_problem = "The WireWarp library was not loaded: disable and enable the add-on."


class LibraryError(Exception):
    """There is no usable library; str() is a sentence for the user."""


def load(addon_version: str) -> None:
    """Looks for the library once, when the add-on registers. What is wrong is kept for problem()."""
    global _library, _problem
    _library, _problem = None, ""
    inside = Path(__file__).parent / _INSIDE
    try:
        if inside.is_dir():
            found = importlib.import_module(f".{_INSIDE}.wirewarp", __package__)
        else:
            found = importlib.import_module("wirewarp")
    except Exception as error:  # what a damaged library or one for another numpy raises, is not ours to know
        traceback.print_exc()
        _problem = loading_problem(error, inside / "wirewarp" if inside.is_dir() else folder_of("wirewarp"))
        return
    library_version = getattr(found, "__version__", "of an unknown version")
    if library_version != addon_version:
        _problem = version_problem(addon_version, library_version)
        return
    _library = found


def problem() -> str:
    """Why there is no library, as a sentence; empty if all is well."""
    return _problem


def library() -> ModuleType:
    """The package wirewarp. Raises LibraryError."""
    if _library is None:
        raise LibraryError(_problem)
    return _library
