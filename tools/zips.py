# SPDX-License-Identifier: GPL-3.0-or-later
"""The zips that users install, from wheels: for each platform an extension, and an add-on for older Blenders.

Version and manifest come from pyproject.toml alone. The same sources and wheels give the same bytes.
"""

import json
import os
import re
import tomllib
import zipfile
from pathlib import Path
from typing import Any

from tools.environment import ROOT, StepError

PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text())
VERSION: str = PROJECT["project"]["version"]
if not re.fullmatch(r"\d+\.\d+\.\d+", VERSION):
    raise SystemExit(f"pyproject.toml: version {VERSION} is not three numbers, as Blender wants them")
ADDON: dict[str, Any] = PROJECT["tool"]["wirewarp"]["addon"]
LEGACY_MODULE = "wirewarp_addon"
LEGACY_TAG = "cp311"
NEWEST_TAG = "cp313"
FIRST_BLENDER_ON_NEWEST = "5.1.0"
PLATFORMS = {  # how the tag of a wheel looks: Blender's word for it
    r"manylinux_\d+_\d+_x86_64": "linux-x64",
    r"win_amd64": "windows-x64",
    r"macosx_\d+_\d+_arm64": "macos-arm64",
    r"macosx_\d+_\d+_x86_64": "macos-x64",
}


def write_zips(folder: Path) -> list[Path]:
    """For each platform that has wheels of this version in the folder: the extension, and the legacy zip if it can be.

    Raises StepError for a wheel whose platform is unknown, and if there is none.
    """
    by_platform: dict[str, list[Path]] = {}
    for wheel in sorted(folder.glob(f"wirewarp-{VERSION}-*.whl")):
        by_platform.setdefault(platform_of(wheel), []).append(wheel)
    if not by_platform:
        raise StepError(f"there is no wheel of WireWarp {VERSION} in {folder}")
    written = []
    for platform, wheels in by_platform.items():
        written.append(write_extension(folder, platform, wheels))
        written += [write_legacy(folder, platform, wheel) for wheel in wheels if f"-{LEGACY_TAG}-" in wheel.name]
    return written


def platform_of(wheel: Path) -> str:
    tags = wheel.stem.rsplit("-", 1)[1]  # several, with dots between, where a wheel keeps to several policies
    for pattern, platform in PLATFORMS.items():
        if any(re.fullmatch(pattern, tag) for tag in tags.split(".")):
            return platform
    raise StepError(f"{wheel.name} is for a platform that Blender has no word for: {tags}")


def extension_zip(folder: Path, platform: str) -> Path:
    return folder / f"wirewarp-{VERSION}-{platform}.zip"


def legacy_zip(folder: Path, platform: str) -> Path:
    return folder / f"wirewarp-{VERSION}-legacy-{platform}.zip"


def addon_files() -> dict[str, bytes]:
    """The add-on's own files by their path inside its folder, the version filled in."""
    source = ROOT / "addon" / "wirewarp"
    files = {
        str(path.relative_to(source)): path.read_bytes()
        for path in sorted(source.rglob("*"))
        if path.is_file() and "__pycache__" not in path.parts
    }
    files["__init__.py"] = with_version(files["__init__.py"].decode()).encode()
    for name in PROJECT["project"]["license-files"]:
        files[name] = (ROOT / name).read_bytes()
    return files


def with_version(text: str) -> str:
    """bl_info must be a literal, so its version is written into it here."""
    version = ", ".join(VERSION.split("."))
    text, count = re.subn(r'"version": \(0, 0, 0\)', f'"version": ({version})', text)
    if count != 1:
        raise StepError('addon/wirewarp/__init__.py must hold "version": (0, 0, 0) once, in bl_info')
    return text


def write_extension(folder: Path, platform: str, wheels: list[Path]) -> Path:
    """In one folder, which Blender 4.2 and later skip: older ones, that know no extensions, then scatter no files."""
    files = addon_files()
    for wheel in wheels:
        files[f"wheels/{wheel.name}"] = wheel.read_bytes()
    files["blender_manifest.toml"] = manifest(platform, wheels).encode()
    return write_zip(extension_zip(folder, platform), {f"{LEGACY_MODULE}/{name}": files[name] for name in files})


def manifest(platform: str, wheels: list[Path]) -> str:
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
        "platforms": [platform],
        "wheels": [f"./wheels/{wheel.name}" for wheel in wheels],
    }
    if not any(f"-{NEWEST_TAG}-" in wheel.name for wheel in wheels):
        entries["blender_version_max"] = FIRST_BLENDER_ON_NEWEST  # the maximum is exclusive
    # A JSON string or list of strings is a TOML one.
    return "".join(f"{key} = {json.dumps(value)}\n" for key, value in entries.items())


def write_legacy(folder: Path, platform: str, wheel: Path) -> Path:
    """The core goes into _core/, where the add-on's core module finds it by relative import."""
    files = {f"{LEGACY_MODULE}/{name}": content for name, content in addon_files().items()}
    files[f"{LEGACY_MODULE}/_core/__init__.py"] = b"# SPDX-License-Identifier: GPL-3.0-or-later\n"
    with zipfile.ZipFile(wheel) as archive:
        for name in archive.namelist():
            if ".dist-info/" not in name and not name.endswith("/"):
                files[f"{LEGACY_MODULE}/_core/{name}"] = archive.read(name)
    return write_zip(legacy_zip(folder, platform), files)


def write_zip(path: Path, files: dict[str, bytes]) -> Path:
    """Sorted names and one fixed time: the same files give the same bytes. It takes the place of an old one that may be
    in use.
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
