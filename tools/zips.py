# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the zips that users install from wheels: for each platform an extension, and an add-on for older Blenders.

The same sources and wheels give the same bytes. Blender's `extension build` cannot write legacy zips.
"""

import json
import os
import re
import tomllib
import zipfile
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any

from tools.environment import ROOT, StepError
from tools.libraries import library_wheels

PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text())
VERSION: str = PROJECT["project"]["version"]
if not re.fullmatch(r"\d+\.\d+\.\d+", VERSION):
    raise SystemExit(f"pyproject.toml: version {VERSION} is not three numbers, as Blender wants them")
ADDON: dict[str, Any] = PROJECT["tool"]["wirewarp"]["addon"]
LEGACY_MODULE = "wirewarp_addon"
EXTENSION_MODULE = f"bl_ext.user_default.{ADDON['id']}"
LEGACY_TAG = "cp311"
NEWEST_TAG = "cp313"
FIRST_BLENDER_ON_NEWEST = "5.1.0"
SAMPLES = ("cushion", "fitted_top", "jeans", "toy", "carnival_mask")  # files for the menu Open Sample
PLATFORMS = {  # pattern of a wheel's tag: Blender's name of the system
    r"manylinux_\d+_\d+_x86_64": "linux-x64",
    r"manylinux_\d+_\d+_aarch64": "linux-arm64",
    r"win_amd64": "windows-x64",
    r"macosx_\d+_\d+_arm64": "macos-arm64",
    r"macosx_\d+_\d+_x86_64": "macos-x64",
}
NOT_IN_STORE = "linux-arm64"  # extensions.blender.org refuses a zip for this platform


# A function of this type returns the wheels of the other packages for a platform and a Python tag.
Libraries = Callable[[str, str], list[Path]]


def write_zips(folder: Path, libraries: Libraries = library_wheels) -> list[Path]:
    """Write the zips for all wheels of this version in the folder, and return the written zips.

    Raises StepError for a wheel of an unknown platform, and if there is no wheel.
    """
    by_platform: dict[str, list[Path]] = {}
    for wheel in sorted(folder.glob(f"wirewarp-{VERSION}-*.whl")):
        by_platform.setdefault(platform_of(wheel), []).append(wheel)
    if not by_platform:
        raise StepError(f"there is no wheel of WireWarp {VERSION} in {folder}")
    written = []
    for platform, wheels in by_platform.items():
        others = {library.name: library for tag in map(python_of, wheels) for library in libraries(platform, tag)}
        written.append(write_extension(folder, platform, [*wheels, *others.values()]))
        for wheel in wheels:
            if python_of(wheel) == LEGACY_TAG:
                written.append(write_legacy(folder, platform, wheel, libraries(platform, LEGACY_TAG)))
    return written


def python_of(wheel: Path) -> str:
    """Return the Python tag of a wheel, such as "cp311"."""
    return wheel.stem.split("-")[2]


def platform_of(wheel: Path) -> str:
    tags = wheel.stem.rsplit("-", 1)[1]  # a wheel that follows several policies has several tags with dots between
    for pattern, platform in PLATFORMS.items():
        if any(re.fullmatch(pattern, tag) for tag in tags.split(".")):
            return platform
    raise StepError(f"{wheel.name} is for a platform that Blender does not name: {tags}")


def extension_zip(folder: Path, platform: str) -> Path:
    return folder / f"wirewarp-{VERSION}-{platform}.zip"


def legacy_zip(folder: Path, platform: str) -> Path:
    return folder / f"wirewarp-{VERSION}-legacy-{platform}.zip"


def extension_zips(folder: Path) -> list[Path]:
    """Return the extension zips of all systems in the folder, sorted by name."""
    return [path for path in map(partial(extension_zip, folder), sorted(PLATFORMS.values())) if path.is_file()]


def store_zips(folder: Path) -> list[Path]:
    """Return the extension zips in the folder that Blender's store accepts, sorted by name."""
    return [path for path in extension_zips(folder) if path != extension_zip(folder, NOT_IN_STORE)]


def addon_files() -> dict[str, bytes]:
    """Return the contents of the add-on's own files, by path inside its folder. bl_info has the version."""
    source = ROOT / "addon" / "wirewarp"
    files = {
        str(path.relative_to(source)): path.read_bytes()
        for path in sorted(source.rglob("*"))
        if path.is_file() and "__pycache__" not in path.parts
    }
    files["__init__.py"] = with_version(files["__init__.py"].decode()).encode()
    for name in SAMPLES:
        files[f"samples/{name}.blend"] = (ROOT / "blend_samples" / f"{name}.blend").read_bytes()
    for name in PROJECT["project"]["license-files"]:
        files[name] = (ROOT / name).read_bytes()
    return files


def with_version(text: str) -> str:
    """Return the text of __init__.py with the version in bl_info, which Blender reads as a literal."""
    version = ", ".join(VERSION.split("."))
    text, count = re.subn(r'"version": \(0, 0, 0\)', f'"version": ({version})', text)
    if count != 1:
        raise StepError('addon/wirewarp/__init__.py must contain "version": (0, 0, 0) once, in bl_info')
    return text


def write_extension(folder: Path, platform: str, wheels: list[Path]) -> Path:
    """Write the extension. All files are in one folder, which Blender 4.2 and later ignore.

    Without this folder, earlier Blenders, which have no extensions, would scatter the files among their add-ons.
    """
    files = addon_files()
    for wheel in wheels:
        files[f"wheels/{wheel.name}"] = wheel.read_bytes()
    files["blender_manifest.toml"] = manifest(platform, wheels).encode()
    return write_zip(extension_zip(folder, platform), {f"{LEGACY_MODULE}/{name}": files[name] for name in files})


def manifest(platform: str, wheels: list[Path]) -> str:
    """Return the text of blender_manifest.toml: the metadata in pyproject.toml, and the paths of the wheels."""
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
        "platforms": [platform],
        "wheels": [f"./wheels/{wheel.name}" for wheel in wheels],
    }
    if NEWEST_TAG not in map(python_of, wheels):
        entries["blender_version_max"] = FIRST_BLENDER_ON_NEWEST  # in Blender, the maximum itself is excluded
    # JSON strings and lists of strings are valid TOML. The table comes last, because keys below it would belong to it.
    lines = [f"{key} = {json.dumps(value)}" for key, value in entries.items()]
    lines += ["[permissions]", *(f"{key} = {json.dumps(reason)}" for key, reason in ADDON["permissions"].items())]
    return "\n".join(lines) + "\n"


def write_legacy(folder: Path, platform: str, wheel: Path, libraries: list[Path]) -> Path:
    """Write the legacy zip.

    The core is in _core/, from which the add-on's core module imports it. Other packages are in _core/libraries, from
    which addon/legacy_core imports them.
    """
    files = addon_files()
    files["_core/__init__.py"] = (ROOT / "addon" / "legacy_core" / "__init__.py").read_bytes()
    files |= {f"_core/{name}": content for name, content in unpacked(wheel).items()}
    for library in libraries:
        files |= {f"_core/libraries/{name}": content for name, content in unpacked(library).items()}
    return write_zip(legacy_zip(folder, platform), {f"{LEGACY_MODULE}/{name}": files[name] for name in files})


def unpacked(wheel: Path) -> dict[str, bytes]:
    """Return the contents of a wheel's files by path, without files that only pip needs."""
    with zipfile.ZipFile(wheel) as archive:
        names = [name for name in archive.namelist() if ".dist-info/" not in name and not name.endswith("/")]
        return {name: archive.read(name) for name in names}


def write_zip(path: Path, files: dict[str, bytes]) -> Path:
    """Write the zip with sorted names and a fixed time, so that the same files give the same bytes.

    An old zip is replaced, even if it is in use.
    """
    part = path.with_suffix(f".part{os.getpid()}")
    try:
        with zipfile.ZipFile(part, "w", zipfile.ZIP_DEFLATED) as archive:
            for name in sorted(files):
                entry = zipfile.ZipInfo(name, date_time=(1980, 1, 1, 0, 0, 0))
                entry.compress_type = zipfile.ZIP_DEFLATED
                entry.external_attr = 0o644 << 16
                archive.writestr(entry, files[name])
        return part.replace(path)
    finally:
        part.unlink(missing_ok=True)
