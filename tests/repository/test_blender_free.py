# SPDX-License-Identifier: GPL-3.0-or-later
"""What says "No Blender in here" may run in a thread, where Blender must not be touched: it imports none on any way."""

import ast
from collections.abc import Iterator
from pathlib import Path

import pytest

ADDON = Path(__file__).resolve().parents[2] / "addon" / "wirewarp"
BLENDER = {"bpy", "bpy_extras", "bmesh", "mathutils", "gpu", "gpu_extras", "blf"}
SAYS_SO = "No Blender in here"


def says_so(file: Path) -> bool:
    """Of a package, its __init__ says it of all its modules."""
    files = [file, file.parent / "__init__.py"]
    return any(SAYS_SO in (ast.get_docstring(ast.parse(each.read_text())) or "") for each in files)


def claiming() -> list[str]:
    return [str(file.relative_to(ADDON)) for file in sorted(ADDON.rglob("*.py")) if says_so(file)]


def imported(file: Path) -> Iterator[Path | str]:
    """The files of our own modules, and the top-level names of all others; imports inside functions too."""
    for node in ast.walk(ast.parse(file.read_text())):
        if isinstance(node, ast.Import):
            yield from (alias.name.split(".")[0] for alias in node.names)
        elif isinstance(node, ast.ImportFrom) and node.level == 0:
            yield node.module.split(".")[0]
        elif isinstance(node, ast.ImportFrom):
            base = file.parents[node.level - 1].joinpath(*(node.module or "").split("."))
            yield from (module_file(base, alias.name) for alias in node.names)


def module_file(base: Path, name: str) -> Path:
    """Of `from base import name`: the module of this name, or the one that holds it."""
    choices = [base / f"{name}.py", base / name / "__init__.py", base.with_suffix(".py"), base / "__init__.py"]
    return next(choice for choice in choices if choice.is_file())


def way_to_blender(file: Path, seen: set[Path]) -> list[str]:
    """The modules from this one to one that imports Blender; none if it cannot be reached."""
    seen.add(file)
    for each in imported(file):
        if each in BLENDER:
            return [file.stem, str(each)]
        if isinstance(each, Path) and each not in seen:
            way = way_to_blender(each, seen)
            if way:
                return [file.stem, *way]
    return []


def test_blender_is_found_where_it_is() -> None:
    assert way_to_blender(ADDON / "operators" / "mark.py", set())[-1] == "bpy"
    assert way_to_blender(ADDON / "read_models.py", set())[-1] == "bpy"
    assert "report.py" in claiming()


@pytest.mark.parametrize("module", claiming())
def test_a_module_that_says_so_imports_no_blender(module: str) -> None:
    assert way_to_blender(ADDON / module, set()) == []
