# SPDX-License-Identifier: GPL-3.0-or-later
"""The add-on consists of a few packages. Each states which others it may import.

A contract in pyproject.toml, which `./dev test lint` checks, forbids circular imports.
"""

import ast
import re

import pytest
from addon_imports import ADDON, own_imports, room_of

MOST_PACKAGES = 10
GROUND = {"core", "issues", "names"}  # modules of the root that packages may import, and that import no package
ROOF = {"__init__", "properties", "registration", "without_library"}  # modules that connect the packages


def packages() -> list[str]:
    return sorted(folder.parent.name for folder in ADDON.glob("*/__init__.py"))


def may_import(package: str) -> set[str]:
    """Return the imports that a package's docstring allows: "May import: model, blender, issues.", or "nothing"."""
    sentence = ast.get_docstring(ast.parse((ADDON / package / "__init__.py").read_text())) or ""
    match = re.search(r"May import: ([\w,\s]+)\.", sentence)
    assert match, f"{package}/__init__.py does not say what the package may import"
    return set(re.split(r",\s*", match[1])) - {"nothing"}


def imports_of(package: str) -> set[str]:
    files = (ADDON / package).glob("*.py")
    return {room_of(each) for file in files for each in own_imports(file)} - {package}


def test_there_are_few_packages_and_none_within_another() -> None:
    assert 0 < len(packages()) <= MOST_PACKAGES
    assert [str(file.relative_to(ADDON)) for file in ADDON.glob("*/*/**/*.py")] == []


def test_the_root_contains_only_its_listed_modules() -> None:
    assert {file.stem for file in ADDON.glob("*.py")} == GROUND | ROOF


@pytest.mark.parametrize("package", packages())
def test_a_package_imports_exactly_the_packages_that_it_names(package: str) -> None:
    assert imports_of(package) == may_import(package)


@pytest.mark.parametrize("module", sorted(GROUND))
def test_modules_of_the_ground_import_no_package(module: str) -> None:
    assert {room_of(each) for each in own_imports(ADDON / f"{module}.py")} <= GROUND
