# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the source package for PyPI: the Python package, and the core with the sources of Eigen and OpenMesh.

pip can build it with packages from PyPI only.
"""

import shutil
from pathlib import Path

from tools.bindings import HYPOTHESIS
from tools.blender import NUMPY, PYTEST
from tools.environment import (
    BUILD,
    DEBIAN_PYTHON,
    DEBIAN_VERSION,
    FAST_TO_COMPILE,
    ROOT,
    TIME_STAMP,
    output_of,
    require_apt,
    run,
    run_quietly,
    venv,
)
from tools.libraries import PATTERN
from tools.old_glibc import openmesh_source
from tools.package import BUILD_APT, CORE_SOURCES, DIST, WHEEL_TOOLS
from tools.zips import VERSION

EIGEN = Path("/usr/include/eigen3")  # headers of Debian's libeigen3-dev, 3.4.0
EIGEN_LICENSE = Path("/usr/share/doc/libeigen3-dev/copyright")
FOLDER = BUILD / "source"
PARTS = (*(name for name in CORE_SOURCES if not name.startswith("tools/")), "CHANGELOG.md", "examples")
# `python -m build` would not make this program shorter, because it calls the same function.
BUILD_SDIST = "import scikit_build_core.build, sys; scikit_build_core.build.build_sdist(sys.argv[1])"


def source_package() -> Path:
    require_apt(*BUILD_APT)
    staged = FOLDER / "staged"
    shutil.rmtree(staged, ignore_errors=True)
    for name in PARTS:
        (staged / name).parent.mkdir(parents=True, exist_ok=True)
        if (ROOT / name).is_dir():
            shutil.copytree(ROOT / name, staged / name, ignore=shutil.ignore_patterns("__pycache__"))
        else:
            shutil.copy(ROOT / name, staged / name)
    shutil.copytree(EIGEN / "Eigen", staged / "libraries" / "eigen" / "Eigen")
    shutil.copy(EIGEN_LICENSE, staged / "libraries" / "eigen")
    core = Path("src", "OpenMesh", "Core")
    shutil.copytree(openmesh_source() / core, staged / "libraries" / "openmesh" / core)
    shutil.copy(openmesh_source() / "LICENSE", staged / "libraries" / "openmesh")
    python = venv(f"build-{DEBIAN_VERSION}", DEBIAN_PYTHON, *WHEEL_TOOLS)
    here = f"import os; os.chdir({str(staged)!r})"
    output_of([python, "-c", f"{here}; {BUILD_SDIST}", DIST], SOURCE_DATE_EPOCH=TIME_STAMP)
    return DIST / f"wirewarp-{VERSION}.tar.gz"


def source_package_tests() -> None:
    """Build a wheel from the source package as pip does, without other sources. Test this wheel with a few tests."""
    unpacked, compiled = FOLDER / "unpacked", FOLDER / "compiled"
    for folder in (unpacked, compiled):
        shutil.rmtree(folder, ignore_errors=True)
    shutil.unpack_archive(source_package(), unpacked)
    python = venv("source", DEBIAN_PYTHON, PYTEST, HYPOTHESIS, NUMPY[DEBIAN_VERSION], *PATTERN)
    definitions = {"FETCHCONTENT_FULLY_DISCONNECTED": "ON", "CMAKE_CXX_FLAGS_RELEASE": FAST_TO_COMPILE}
    settings = [f"--config-settings=cmake.define.{name}={value}" for name, value in definitions.items()]
    # The folder is fixed, so that ccache finds the objects of the last run.
    options = (*settings, f"--config-settings=build-dir={compiled}", "--no-deps", "--force-reinstall")
    (sources,) = unpacked.iterdir()
    install: list[str | Path] = [python, "-m", "pip", "install", *options, sources]
    run_quietly("building a wheel from the source package", install)
    run([python, "-m", "pytest", "-q", "tests/bindings/test_readme.py", "tests/bindings/test_stub.py"])
