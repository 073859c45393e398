# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the tests of the Python package, and of the add-on's modules that do not use Blender, on the installed wheel."""

import os
from pathlib import Path

from tools.blender import NUMPY, PYTEST
from tools.environment import CORES, DEBIAN_VERSION, run
from tools.libraries import PATTERN
from tools.package import venv_with_core

HYPOTHESIS = "hypothesis==6.170.15"
XDIST = "pytest-xdist==3.8.0"  # runs tests on all cores, because most tests use one core
READERS = (
    "dxfgrabber==1.0.1",
    "ezdxf==1.4.5",
    "pypdfium2==5.15.2",
    "python-bidi==0.6.12",
    "resvg-py==0.5.0",
    "shapely==2.2.0",
)  # only tests use these packages, to read pattern files and right-to-left text
# Tests that need one of these optional packages are skipped without it.
OPTIONAL = ("spyrrow==0.9.0", "fonttools[woff]==4.68.0", "hyperqueue==0.27.0")
MODELS = ("trimesh==5.2.0", "pillow==13.0.0", "psutil==7.2.2", "tqdm==4.70.1")  # packages for python -m wirewarp


def bindings_python(version: str) -> Path:
    packages = (PYTEST, XDIST, HYPOTHESIS, NUMPY[version], *PATTERN, *READERS, *OPTIONAL, *MODELS)
    return venv_with_core(f"bindings-{version}", version, *packages)


def bindings_tests(version: str, *options: str) -> None:
    """Run all tests in Debian's Python. In other Pythons, leave out the tests of the core's results.

    options: options of pytest
    """
    chosen = [] if version == DEBIAN_VERSION else ["-m", "not core"]
    has_options = bool(os.environ.get("PYTEST_ADDOPTS"))
    # All tests of a file run in one process, because they share results. With PYTEST_ADDOPTS, all tests run in one
    # process, in which breakpoint() works.
    at_once = [] if has_options else ["-n", str(CORES), "--dist", "loadfile"]
    folders = ("tests/bindings", "tests/without_blender")
    run([bindings_python(version), "-m", "pytest", "-q", *at_once, *chosen, *options, *folders])


def search_arguments() -> None:
    """Test the package with many random arguments, which differ in each run."""
    bindings_tests(DEBIAN_VERSION, "-m", "hypothesis", "--hypothesis-profile=search")
