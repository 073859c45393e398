# SPDX-License-Identifier: GPL-3.0-or-later
"""The add-on consists of a few packages. Each package states what it may import, and whether it runs without Blender.

A contract in pyproject.toml, which `./dev test lint` checks, forbids circular imports.
"""

import ast
import re
from collections.abc import Iterator
from pathlib import Path

import pytest

ADDON = Path(__file__).resolve().parents[2] / "addon" / "wirewarp"
MOST_PACKAGES = 10
GROUND = {"core", "issues", "names"}  # modules of the root that packages may import, and that import no package
ROOF = {"__init__", "properties", "registration", "without_library"}  # modules that connect the packages
BLENDER = {"bpy", "bpy_extras", "bmesh", "mathutils", "gpu", "gpu_extras", "blf"}
SAYS_SO = "Does not use Blender"


def imported(file: Path) -> Iterator[Path | str]:
    """Yield all imports of a file: files for our own modules, and top-level names for other modules."""
    for node in ast.walk(ast.parse(file.read_text())):
        if isinstance(node, ast.Import):
            yield from (alias.name.split(".")[0] for alias in node.names)
        elif isinstance(node, ast.ImportFrom) and node.level == 0:
            yield node.module.split(".")[0]
        elif isinstance(node, ast.ImportFrom):
            base = file.parents[node.level - 1].joinpath(*(node.module or "").split("."))
            yield from (_module_file(base, alias.name) for alias in node.names)


def own_imports(file: Path) -> set[str]:
    """Return the packages, and the modules of the root, that the file imports."""
    files = [each for each in imported(file) if isinstance(each, Path)]
    return {each.relative_to(ADDON).parts[0].removesuffix(".py") for each in files}


def _module_file(base: Path, name: str) -> Path:
    """Return the module for `from base import name`: the module with this name, or the module that defines the name."""
    choices = [base / f"{name}.py", base / name / "__init__.py", base.with_suffix(".py"), base / "__init__.py"]
    return next(choice for choice in choices if choice.is_file())


def packages() -> list[str]:
    return sorted(folder.parent.name for folder in ADDON.glob("*/__init__.py"))


def may_import(package: str) -> set[str]:
    """Return the packages and modules in the docstring's sentence, such as "May import: model, blender, issues."."""
    sentence = ast.get_docstring(ast.parse((ADDON / package / "__init__.py").read_text())) or ""
    match = re.search(r"May import: ([\w,\s]+)\.", sentence)
    assert match, f"{package}/__init__.py does not say what the package may import"
    return set(re.split(r",\s*", match[1])) - {"nothing"}


def test_there_are_few_packages_and_none_within_another() -> None:
    assert 0 < len(packages()) <= MOST_PACKAGES
    assert [str(file.relative_to(ADDON)) for file in ADDON.glob("*/*/**/*.py")] == []


def test_the_root_contains_only_its_listed_modules() -> None:
    assert {file.stem for file in ADDON.glob("*.py")} == GROUND | ROOF


@pytest.mark.parametrize("package", packages())
def test_a_package_imports_exactly_the_packages_that_it_names(package: str) -> None:
    found = set().union(*(own_imports(file) for file in (ADDON / package).glob("*.py")))
    assert found - {package} == may_import(package)


@pytest.mark.parametrize("module", sorted(GROUND))
def test_modules_of_the_ground_import_no_package(module: str) -> None:
    assert own_imports(ADDON / f"{module}.py") <= GROUND


def claiming() -> list[str]:
    """Return the modules that state that they do not use Blender. An __init__ states this for its whole package."""

    def says_so(file: Path) -> bool:
        return SAYS_SO in (ast.get_docstring(ast.parse(file.read_text())) or "")

    files = [file for file in sorted(ADDON.rglob("*.py")) if says_so(file) or says_so(file.parent / "__init__.py")]
    return [str(file.relative_to(ADDON)) for file in files]


def way_to_blender(file: Path, seen: set[Path]) -> list[str]:
    """Return a chain of imports from this module to Blender, or an empty list if it does not import Blender."""
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
def test_a_module_that_states_that_it_does_not_use_blender_imports_no_blender(module: str) -> None:
    assert way_to_blender(ADDON / module, set()) == []
