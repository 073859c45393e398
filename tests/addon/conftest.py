# SPDX-License-Identifier: GPL-3.0-or-later
"""The tests run inside Blender on the installed add-on, whichever way it was installed."""

import sys
from types import ModuleType

import bpy
import pytest

# The legacy add-on, and the extension in Blender's repository for local files.
MODULE_NAMES = ("wirewarp_addon", "bl_ext.user_default.wirewarp")


def pytest_configure(config: pytest.Config) -> None:
    # Longer tracebacks print local variables, and printing a Blender object that is gone is a crash.
    config.option.tbstyle = "short"


@pytest.fixture(scope="session")
def addon() -> ModuleType:
    return next(sys.modules[name] for name in MODULE_NAMES if name in sys.modules)


@pytest.fixture(autouse=True)
def empty_scene() -> None:
    bpy.ops.wm.read_homefile(use_empty=True, use_factory_startup=True)
