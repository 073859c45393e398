# SPDX-License-Identifier: GPL-3.0-or-later
"""Finds the imports of the add-on's files in their text."""

import ast
from collections.abc import Iterator
from pathlib import Path

ADDON = Path(__file__).resolve().parents[2] / "addon" / "wirewarp"


def imported(file: Path) -> Iterator[Path | str]:
    """Yield files for our own modules and top-level names for others, including imports inside functions."""
    for node in ast.walk(ast.parse(file.read_text())):
        if isinstance(node, ast.Import):
            yield from (alias.name.split(".")[0] for alias in node.names)
        elif isinstance(node, ast.ImportFrom) and node.level == 0:
            yield node.module.split(".")[0]
        elif isinstance(node, ast.ImportFrom):
            base = file.parents[node.level - 1].joinpath(*(node.module or "").split("."))
            yield from (_module_file(base, alias.name) for alias in node.names)


def own_imports(file: Path) -> set[Path]:
    """Return the imported modules that are our own."""
    return {each for each in imported(file) if isinstance(each, Path)}


def room_of(file: Path) -> str:
    """Return the name of the package that contains the file; for a file in the root, the name of the file."""
    first = file.relative_to(ADDON).parts[0]
    return first.removesuffix(".py")


def _module_file(base: Path, name: str) -> Path:
    """Return the module for `from base import name`: the one with this name, or the one that defines the name."""
    choices = [base / f"{name}.py", base / name / "__init__.py", base.with_suffix(".py"), base / "__init__.py"]
    return next(choice for choice in choices if choice.is_file())
