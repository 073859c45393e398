# SPDX-License-Identifier: GPL-3.0-or-later
"""Files that state "Does not use Blender" run without it: they do not import it, not even indirectly."""

import ast
from pathlib import Path

import pytest
from addon_imports import ADDON, imported

BLENDER = {"bpy", "bpy_extras", "bmesh", "mathutils", "gpu", "gpu_extras", "blf"}
SAYS_SO = "Does not use Blender"


def says_so(file: Path) -> bool:
    """Return whether the file states that it does not use Blender. The __init__ of a package states it for all its
    modules."""
    files = [file, file.parent / "__init__.py"]
    return any(SAYS_SO in (ast.get_docstring(ast.parse(each.read_text())) or "") for each in files)


def claiming() -> list[str]:
    return [str(file.relative_to(ADDON)) for file in sorted(ADDON.rglob("*.py")) if says_so(file)]


def way_to_blender(file: Path, seen: set[Path]) -> list[str]:
    """Return the chain of modules from this one to one that imports Blender; empty if there is none."""
    seen.add(file)
    for each in imported(file):
        if each in BLENDER:
            return [file.stem, str(each)]
        if isinstance(each, Path) and each not in seen:
            way = way_to_blender(each, seen)
            if way:
                return [file.stem, *way]
    return []


def test_imports_of_blender_are_found() -> None:
    assert way_to_blender(ADDON / "marks" / "mark_operators.py", set())[-1] in {"bpy", "bmesh"}
    assert way_to_blender(ADDON / "flatten" / "read.py", set())[-1] == "bpy"
    assert "solve/report.py" in claiming()


@pytest.mark.parametrize("module", claiming())
def test_a_module_that_states_it_imports_no_blender(module: str) -> None:
    assert way_to_blender(ADDON / module, set()) == []
