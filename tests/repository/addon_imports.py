# SPDX-License-Identifier: GPL-3.0-or-later
"""What the add-on's files import, read from their text."""

import ast
from collections.abc import Iterator
from pathlib import Path

ADDON = Path(__file__).resolve().parents[2] / "addon" / "wirewarp"


def imported(file: Path) -> Iterator[Path | str]:
    """The files of our own modules, and the top-level names of all others; imports inside functions too."""
    for node in ast.walk(ast.parse(file.read_text())):
        if isinstance(node, ast.Import):
            yield from (alias.name.split(".")[0] for alias in node.names)
        elif isinstance(node, ast.ImportFrom) and node.level == 0:
            yield node.module.split(".")[0]
        elif isinstance(node, ast.ImportFrom):
            base = file.parents[node.level - 1].joinpath(*(node.module or "").split("."))
            yield from (_module_file(base, alias.name) for alias in node.names)


def own_imports(file: Path) -> set[Path]:
    """Our own modules alone."""
    return {each for each in imported(file) if isinstance(each, Path)}


def room_of(file: Path) -> str:
    """The package that a file is in, or its own name in the root."""
    first = file.relative_to(ADDON).parts[0]
    return first.removesuffix(".py")


def _module_file(base: Path, name: str) -> Path:
    """Of `from base import name`: the module of this name, or the one that holds it."""
    choices = [base / f"{name}.py", base / name / "__init__.py", base.with_suffix(".py"), base / "__init__.py"]
    return next(choice for choice in choices if choice.is_file())
