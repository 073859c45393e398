# SPDX-License-Identifier: GPL-3.0-or-later
"""The only place that imports the core library, the package wirewarp.

The legacy add-on carries it inside (_core/wirewarp); for the extension Blender installs it from a wheel.
"""

import importlib
import sys
from importlib.machinery import EXTENSION_SUFFIXES
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
    inside = Path(__file__).parent / _INSIDE / "wirewarp"
    try:
        if inside.is_dir():
            found = importlib.import_module(f".{_INSIDE}.wirewarp", __package__)
        else:
            found = importlib.import_module("wirewarp")
    except ImportError as error:
        _problem = _loading_problem(error, inside)
        return
    if found.__version__ != addon_version:
        _problem = (
            f"The add-on is WireWarp {addon_version} but the library found is {found.__version__}: "
            "remove WireWarp, restart Blender and install the zip again."
        )
        return
    _library = found


def _loading_problem(error: ImportError, inside: Path) -> str:
    here = f"Python {sys.version_info.major}.{sys.version_info.minor} on {sys.platform}"
    suffixes = {path.name.removeprefix("_wirewarp") for path in inside.glob("_wirewarp.*.*")}
    if suffixes and not suffixes.intersection(EXTENSION_SUFFIXES):
        reason = f"it is made for {', '.join(sorted(suffixes))}"
    else:
        reason = str(error)
    return (
        f"The WireWarp library does not load in this Blender ({here}): {reason}. WireWarp runs on Linux on x86-64, in "
        "Blender 4.2 and later (the extension zip) and in Blenders with Python 3.11 (the legacy zip)."
    )


def problem() -> str:
    """Why there is no library, as a sentence; empty if all is well."""
    return _problem


def library() -> ModuleType:
    """The package wirewarp. Raises LibraryError."""
    if _library is None:
        raise LibraryError(_problem)
    return _library
