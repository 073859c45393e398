# SPDX-License-Identifier: GPL-3.0-or-later
"""Loads the modules of the add-on that do not use Blender, with the library of the installed wheel."""

import importlib
import sys
from pathlib import Path
from types import ModuleType

import pytest
import wirewarp

FOLDER = Path(__file__).resolve().parents[2] / "addon" / "wirewarp"
MODULES = (
    "issues",
    "solve.chains",
    "solve.error_sentences",
    "solve.flatten",
    "solve.identity",
    "solve.maps",
    "solve.seam_sets",
    "solve.steps",
    "solve.suggest",
)


@pytest.fixture(scope="session")
def addon() -> ModuleType:
    """Return the add-on without its root, which imports Blender."""
    package = ModuleType("wirewarp_addon")
    package.__path__ = [str(FOLDER)]
    sys.modules[package.__name__] = package
    importlib.import_module("wirewarp_addon.core").load(wirewarp.__version__)
    for module in MODULES:
        importlib.import_module(f"wirewarp_addon.{module}")
    return package
