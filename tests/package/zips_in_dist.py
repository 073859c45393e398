# SPDX-License-Identifier: GPL-3.0-or-later
"""Finds and reads the zips that ./dev package has left in dist/, for all platforms."""

import ast
import io
import tomllib
import zipfile
from collections.abc import Iterator
from functools import cache
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
ZIPS = sorted((ROOT / "dist").glob("wirewarp-*.zip"))
EXTENSIONS = [path for path in ZIPS if "legacy" not in path.name]


@cache
def files_of(path: Path) -> dict[str, bytes]:
    """Return the files of a zip, keyed by their path inside the zip's only folder."""
    with zipfile.ZipFile(path) as archive:
        assert archive.testzip() is None
        return {name.split("/", 1)[1]: archive.read(name) for name in archive.namelist()}


@cache
def wheels_of(path: Path) -> dict[str, dict[str, bytes]]:
    """Return the files of each wheel inside, keyed by the path of the wheel."""
    found = {}
    for name, content in files_of(path).items():
        if name.endswith(".whl"):
            with zipfile.ZipFile(io.BytesIO(content)) as wheel:
                assert wheel.testzip() is None
                found[name] = {each: wheel.read(each) for each in wheel.namelist() if not each.endswith("/")}
    return found


def manifest_of(path: Path) -> dict:
    return tomllib.loads(files_of(path)["blender_manifest.toml"].decode())


def sources_of(path: Path) -> dict[str, ast.Module]:
    """Return the sources that Blender runs: modules of the add-on, and of the library without its command line."""
    sources = {name: content for name, content in files_of(path).items() if name.endswith(".py")}
    for wheel, files in wheels_of(path).items():
        if wheel.startswith("wheels/wirewarp-"):
            sources |= {name: content for name, content in files.items() if name.endswith(".py")}
    command_line = ("wirewarp/command/", "wirewarp/__main__.py")
    return {name: ast.parse(content) for name, content in sources.items() if not name.startswith(command_line)}


def imports(tree: ast.Module) -> Iterator[str]:
    """Yield the top-level names of all absolute imports, including imports inside functions."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            yield from (alias.name.split(".")[0] for alias in node.names)
        elif isinstance(node, ast.ImportFrom) and node.level == 0 and node.module:
            yield node.module.split(".")[0]


def at_import(tree: ast.AST) -> Iterator[ast.AST]:
    """Yield the nodes that run when the module is imported: all except those inside functions."""
    for node in ast.iter_child_nodes(tree):
        if not isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef | ast.Lambda):
            yield node
            yield from at_import(node)
