# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the wheels run on Linux systems with an older glibc than this machine."""

import re
import shutil
import subprocess
import zipfile
from pathlib import Path

from tools.environment import (
    BUILD,
    DEBIAN_PYTHON,
    StepError,
    clean_environment,
    is_current,
    run_quietly,
    set_current,
    venv,
)
from tools.zig import ZIG, cache_variables, zig

OPENMESH = "openmesh==1.2.1"  # contains the C++ source of OpenMesh 9.1
GLIBC = "2.28"  # version on the oldest systems that blender.org supports
POLICY = f"manylinux_{GLIBC.replace('.', '_')}_x86_64"
# Definitions without which libstdc++ or its headers would need a newer glibc:
# - __libc_single_threaded: 0 is always safe (there may be several threads)
# - __isoc23_*: Debian 13's headers replace strtol and strtoul by these functions
NEWER_GLIBC = """
#define OURS extern "C" __attribute__((visibility("hidden")))
OURS char __libc_single_threaded;
char __libc_single_threaded = 0;
extern "C" long strtol(const char*, char**, int);
extern "C" unsigned long strtoul(const char*, char**, int);
OURS long __isoc23_strtol(const char* text, char** end, int base) { return strtol(text, end, base); }
OURS unsigned long __isoc23_strtoul(const char* text, char** end, int base) { return strtoul(text, end, base); }
"""
# These options link only the used parts of libstdc++, which need no newer glibc, and hide them from other modules.
SECTIONS = "-Wl,--gc-sections -Wl,--exclude-libs,ALL"


def openmesh_source() -> Path:
    """Return the folder with OpenMesh's CMakeLists.txt."""
    folder = BUILD / "openmesh"
    source = folder / OPENMESH.replace("==", "-") / "OpenMesh"
    if not (source.is_dir() and is_current("openmesh", OPENMESH)):
        shutil.rmtree(folder, ignore_errors=True)
        python = venv("zig", DEBIAN_PYTHON, ZIG)
        options = ("--quiet", "--no-deps", "--no-binary", ":all:", "-d", folder)
        run_quietly(f"pip download {OPENMESH}", [python, "-m", "pip", "download", *options, OPENMESH])
        (archive,) = folder.glob("*.tar.gz")
        shutil.unpack_archive(archive, folder)
        set_current("openmesh", OPENMESH)
    return source


def cmake_definitions() -> dict[str, str]:
    """Return CMake's definitions for linking with an old glibc."""
    folder = BUILD / "wheels" / f"glibc-{GLIBC}"
    newer = folder / "newer_glibc.o"
    if not (newer.is_file() and is_current("old-glibc", f"{ZIG} {GLIBC} {NEWER_GLIBC}")):
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir(parents=True)
        write_stubs(folder)
        newer.with_suffix(".cpp").write_text(NEWER_GLIBC)
        run_quietly("compiling newer_glibc.cpp", ["g++", "-fPIC", "-c", newer.with_suffix(".cpp"), "-o", newer])
        set_current("old-glibc", f"{ZIG} {GLIBC} {NEWER_GLIBC}")
    return {
        "FETCHCONTENT_SOURCE_DIR_OPENMESH": str(openmesh_source()),
        "CMAKE_MODULE_LINKER_FLAGS": f"-L{folder} {newer} -static-libstdc++ {SECTIONS}",
        "CMAKE_CXX_STANDARD_LIBRARIES": "-lpthread -lld",
    }


def write_stubs(folder: Path) -> None:
    """Write the libraries of the old glibc, such as libc.so. zig makes them in its cache when it links any program."""
    cache = folder / "zig"
    (folder / "empty.c").write_text("")
    link = ("cc", "-target", f"x86_64-linux-gnu.{GLIBC}", "-shared", "-o", folder / "empty.so", folder / "empty.c")
    run_quietly(f"writing the symbols of glibc {GLIBC}", [zig(), *link], **cache_variables(cache))
    (libc,) = cache.glob("o/*/libc.so.6")
    for library in libc.parent.glob("lib*.so.*"):
        shutil.copy(library, folder)
        (folder / library.name.split(".so")[0]).with_suffix(".so").symlink_to(library.name)
    shutil.rmtree(cache)


def check_symbols(wheel: Path) -> None:
    """Raise StepError if the module needs a symbol without a version, because the old glibc may lack it."""
    with zipfile.ZipFile(wheel) as archive:
        (name,) = (name for name in archive.namelist() if name.endswith(".so"))
        module = Path(archive.extract(name, wheel.parent))
    listed = subprocess.run(
        ["nm", "-D", "--undefined-only", module], check=True, capture_output=True, text=True, env=clean_environment()
    )
    missing = [line.split()[-1] for line in listed.stdout.splitlines() if re.search(r" U (?!_?Py)[^@]+$", line)]
    if missing:
        raise StepError(f"{wheel.name} needs symbols that glibc {GLIBC} lacks: {', '.join(missing)}")
