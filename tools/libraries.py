# SPDX-License-Identifier: GPL-3.0-or-later
"""Downloads wheels of other projects for other systems: packages that WireWarp needs and Blender lacks."""

import shutil
from pathlib import Path

from tools.environment import BUILD, DEBIAN_PYTHON, fingerprint, is_current, run_quietly, set_current, venv
from tools.module_needs import LIEF

WHEEL = "wheel==0.48.0"
PATTERN = ("pyclipper==1.4.0", "pydyf==0.13.0", "uharfbuzz==0.57.0")  # packages without dependencies
PIP_PLATFORMS = {  # by Blender's name of a system: pip's name for the oldest version that Blender supports
    "linux-x64": "manylinux2014_x86_64",
    "linux-arm64": "manylinux_2_28_aarch64",
    "windows-x64": "win_amd64",
    "macos-arm64": "macosx_11_0_arm64",
    "macos-x64": "macosx_11_0_x86_64",
}


def cross_python() -> Path:
    """Return a Python with the tools for packages of other systems."""
    return venv("cross", DEBIAN_PYTHON, LIEF, WHEEL, "pip")


def library_wheels(platform: str, tag: str) -> list[Path]:
    """Return the wheels of PATTERN for a platform and a Python tag, such as "cp311". They are downloaded once."""
    name = f"libraries-{platform}-{tag}"
    folder = BUILD / "wheels" / name
    key = fingerprint([], PIP_PLATFORMS[platform], *PATTERN)
    if not (is_current(name, key) and len(list(folder.glob("*.whl"))) == len(PATTERN)):
        shutil.rmtree(folder, ignore_errors=True)
        version = f"{tag[2]}.{tag[3:]}"
        options = ("--quiet", "--no-deps", "--only-binary=:all:", "--implementation=cp", f"--python-version={version}")
        download = ("pip", "download", *options, f"--platform={PIP_PLATFORMS[platform]}", "--dest", folder)
        what = f"pip download {' '.join(PATTERN)} for {platform} and Python {version}"
        run_quietly(what, [cross_python(), "-m", *download, *PATTERN])
        set_current(name, key)
    return sorted(folder.glob("*.whl"))


def install_for(platforms: tuple[str, ...], version: str, folder: Path, *arguments: str | Path) -> None:
    """Install packages for another system and a Python of this version into a folder. platforms: pip's names."""
    systems = [f"--platform={each}" for each in platforms]
    # Without --ignore-requires-python, pip would check packages against the version of our Python.
    options = ("--implementation=cp", f"--python-version={version}", "--only-binary=:all:", "--ignore-requires-python")
    pip = ["pip", "install", "--quiet", "--target", str(folder), *systems, *options]
    what = f"pip install for {platforms[0]}: " + " ".join(str(a) for a in arguments if not str(a).startswith("-"))
    run_quietly(what, [cross_python(), "-m", *pip, *arguments])
