# SPDX-License-Identifier: GPL-3.0-or-later
"""Includes and imports of the code have one direction, and every source file names its license."""

import ast
import re
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
CORE = ROOT / "native" / "src"
SOURCE_FOLDERS = [
    "addon",
    "bench",
    "blend_samples",
    "docs",
    "examples",
    "native",
    "python",
    "results",
    "tests",
    "tools",
]

# The folders of native/src. A file may include files of its own folder and of the folders before it.
LAYERS = [
    "base",
    "numerics/optimize",
    "numerics/cholesky",
    "surface/mesh",
    "surface/check_input",
    "surface/cut_mesh",
    "surface/charts",
    "surface/network",
    "surface/orientation",
    "surface",
    "energy",
    "warp/topology",
    "warp/inner",
    "warp/outer",
    "newton/coarsen",
    "newton",
    "newton/cache",
    "newton/solve",
    "cuts/feasibility",
    "cuts/parts",
    "cuts/propose",
    "result",
]


def listed(*patterns: str) -> list[Path]:
    """Return the files that match the patterns, sorted, without Python's caches."""
    return sorted(p for pattern in patterns for p in ROOT.glob(pattern) if p.is_file() and p.suffix != ".pyc")


def sources() -> list[Path]:
    return listed(*(f"{folder}/**/*.{kind}" for folder in SOURCE_FOLDERS for kind in ("py", "h", "cpp")), "dev")


def includes(file: Path) -> list[str]:
    return re.findall(r'^\s*#include\s+[<"]([^">]+)[">]', file.read_text(), re.MULTILINE)


def imports(file: Path) -> Iterator[str]:
    """Yield the top-level names of all absolute imports, including imports inside functions."""
    for node in ast.walk(ast.parse(file.read_text())):
        if isinstance(node, ast.Import):
            yield from (alias.name.split(".")[0] for alias in node.names)
        elif isinstance(node, ast.ImportFrom) and node.level == 0 and node.module:
            yield node.module.split(".")[0]


def offenders(files: list[Path], is_bad: Callable[[Path], bool]) -> list[str]:
    assert files, "the pattern finds no file: the layout has changed"
    return [str(file.relative_to(ROOT)) for file in files if is_bad(file)]


def test_every_source_file_begins_with_its_license() -> None:
    others = listed("dev", ".ci/run", "CMakeLists.txt", "pyproject.toml")
    mark = "SPDX-License-Identifier: GPL-3.0-or-later"
    assert offenders(sources() + others, lambda file: mark not in "".join(file.read_text().splitlines()[:2])) == []


def test_no_source_file_is_longer_than_400_lines() -> None:
    assert offenders(sources(), lambda file: len(file.read_text().splitlines()) > 400) == []


def folders_of_the_core() -> list[str]:
    return sorted({file.parent.relative_to(CORE).as_posix() for file in listed("native/src/*/**/*")})


@pytest.mark.parametrize("folder", folders_of_the_core())
def test_native_includes_point_one_way(folder: str) -> None:
    allowed = {*LAYERS[: LAYERS.index(folder) + 1]}

    def includes_upward(file: Path) -> bool:
        ours = [name for name in includes(file) if (CORE / name).is_file()]
        # The search for cuts needs the solver, because the search flattens pieces to evaluate each cut.
        ours = [name for name in ours if (folder, name) != ("cuts/propose", "flatten.h")]
        return any(Path(name).parent.as_posix() not in allowed for name in ours)

    assert offenders(listed(f"native/src/{folder}/*"), includes_upward) == []


def test_only_the_entry_points_of_the_core_are_outside_of_its_folders() -> None:
    assert {file.stem for file in listed("native/src/*")} == {"flatten", "measure", "propose"}


def test_the_core_knows_no_python() -> None:
    def includes_python(file: Path) -> bool:
        return any(re.match(r"pybind11|Python\.h|numpy", name) for name in includes(file))

    core = listed("native/src/**/*", "native/include/**/*", "native/bench/**/*", "tests/native/**/*")
    assert offenders(core, includes_python) == []


def test_bindings_and_public_headers_see_the_public_api_only() -> None:
    def includes_private(file: Path) -> bool:
        return any((CORE / name).is_file() or name.startswith("OpenMesh") for name in includes(file))

    assert offenders(listed("native/bindings/**/*", "native/include/**/*"), includes_private) == []


def test_bpy_is_imported_in_the_add_on_only() -> None:
    elsewhere = listed("python/**/*.py", "tests/bindings/**/*.py", "tools/**/*.py", "bench/**/*.py", "dev")
    elsewhere = [file for file in elsewhere if not file.name.endswith("_in_blender.py")]  # scripts that Blender runs
    blender = {"bpy", "bmesh", "bl_ui", "mathutils", "gpu", "blf"}
    assert offenders(elsewhere, lambda file: not blender.isdisjoint(imports(file))) == []


def test_one_module_of_the_add_on_imports_the_core() -> None:
    by_name = re.compile(r"""import_module\(["']wirewarp""")

    def imports_core(file: Path) -> bool:
        return "wirewarp" in imports(file) or bool(by_name.search(file.read_text()))

    assert offenders(listed("addon/**/*.py"), imports_core) == ["addon/wirewarp/core.py"]


def test_tests_omitted_under_the_sanitizers_exist() -> None:
    """GoogleTest ignores the names of tests that do not exist, so this test checks them."""
    native = "\n".join(file.read_text() for file in listed("tests/native/**/*.cpp", "tests/bugs/*.cpp"))
    lines = (ROOT / "tests" / "native" / "without_sanitizers.txt").read_text().splitlines()
    missing = []
    for name in (line for line in lines if not line.startswith("#")):
        found = re.fullmatch(r"(?:(\w+)/)?(\w+)\.(\w+)(?:/(\w+|\*))?", name)
        assert found, name
        prefix, suite, test, case = found.groups()
        patterns = [rf"TEST{'_P' if prefix else '(_F)?'}\({suite},\s+{test}\)"]
        patterns += [rf"INSTANTIATE_TEST_SUITE_P\({prefix},\s+{suite}\b"] if prefix else []
        patterns += [f'"{case}"'] if case and case != "*" else []
        if not all(re.search(pattern, native) for pattern in patterns):
            missing.append(name)
    assert missing == []
