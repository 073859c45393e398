# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the add-on's tests in every available Blender, on the zips that users install.

Debian's Blender is the whole program. Other Blenders are the module `bpy` in a Python of their own.
"""

import os
import shutil
from collections.abc import Sequence
from pathlib import Path

from tools import addon_coverage
from tools.environment import (
    BUILD,
    DEBIAN_PYTHON,
    DEBIAN_VERSION,
    ROOT,
    require_apt,
    require_python,
    run,
    run_at_once,
    run_quietly,
    venv,
)
from tools.package import BUILD_APT, LEGACY_PYTHON, extension_zip, package, package_legacy
from tools.zips import EXTENSION_MODULE, LEGACY_MODULE

PYTEST = "pytest==9.2.0"
BLENDER_APT = ("blender", "libegl1", "python3-numpy", "python3-pytest")  # EGL is needed for drawing without a window
WINDOW_APT = ("xvfb", "xauth", "libgl1-mesa-dri")
BPY_APT = ("libgl1", "libice6", "libsm6", "libxfixes3", "libxi6", "libxkbcommon0", "libxrender1")
NUMPY = {"3.11": "numpy==1.26.4", "3.13": "numpy==2.5.5"}  # for Blender up to 5.0, and for 5.1 and later
# The version is "" on other systems, which check_system() refuses.
DEBIAN_BLENDER = {"3.11": "3.4", "3.13": "4.3"}.get(DEBIAN_VERSION, "")
ADDON_MODULE = LEGACY_MODULE if DEBIAN_VERSION == LEGACY_PYTHON else EXTENSION_MODULE
RUNNER = ROOT / "tests" / "addon" / "run_in_blender.py"
BLENDERS = 2  # number of Blenders that run tests at the same time; each uses little more than one core
BPY = {"bpy==4.2.23": "3.11", "bpy==4.5.15": "3.11", "bpy==5.0.1": "3.11", "bpy==5.2.3": "3.13"}
EXTENSION_PROGRAM = "addons_core/bl_pkg/cli/blender_ext.py"  # the program behind `blender --command extension`


def blender_folder(name: str) -> dict[str, str]:
    """Return environment variables with which Blender uses only the add-ons and settings of a new, empty folder."""
    folder = BUILD / "blender" / name
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    parts = {"SCRIPTS": "scripts", "CONFIG": "config", "DATAFILES": "datafiles"}
    for part in parts.values():
        (folder / part).mkdir()
    return {"BLENDER_USER_RESOURCES": str(folder)} | {f"BLENDER_USER_{k}": str(folder / v) for k, v in parts.items()}


def blender(*arguments: str | Path) -> list[str | Path]:
    return ["/usr/bin/blender", "--background", "--factory-startup", "--python-exit-code", "1", *arguments]


def debian_blender_zip() -> Path:
    """Return the zip for Debian's Blender: the legacy zip in Blender 3.4, the extension in later versions."""
    if DEBIAN_VERSION == LEGACY_PYTHON:
        return package_legacy()
    package()
    return extension_zip()


def install_privately(name: str) -> dict[str, str]:
    """Install the add-on of this repository for Debian's Blender, in separate settings. Return Blender's variables."""
    require_apt(*BUILD_APT, *BLENDER_APT)
    settings = blender_folder(name)
    file = str(debian_blender_zip())
    if ADDON_MODULE == LEGACY_MODULE:
        install = f"preferences.addon_install(filepath={file!r})"
    else:
        install = f"extensions.package_install_files(repo='user_default', filepath={file!r}, enable_on_install=False)"
    command = blender("--python-expr", f"import bpy; bpy.ops.{install}")
    run_quietly("installing the add-on privately", command, **settings)
    return settings


def run_with_addon(name: str, script: Path, *arguments: str | Path) -> None:
    """Run a script in Debian's Blender with the add-on. name: name of the folder with the separate settings."""
    settings = install_privately(name)
    run(blender("--addons", ADDON_MODULE, "--python", script, "--", *arguments), **settings)


def debian_blender_tests() -> None:
    require_apt(*BLENDER_APT)
    settings = {"WIREWARP_ZIP": str(debian_blender_zip())} | addon_coverage.begin("headless")
    run_addon_tests(blender("--python", RUNNER), "debian", **settings)
    addon_coverage.show("headless")


def run_addon_tests(command: Sequence[str | Path], name: str, *options: str, **settings: str) -> None:
    """Run the tests of the add-on in several Blenders at once, each with a share of the files.

    command: starts a Blender that runs RUNNER
    options: options of pytest
    """
    files = sorted((ROOT / "tests" / "addon").glob("test_*.py"), key=lambda file: (-file.stat().st_size, file.name))
    shares = 1 if os.environ.get("PYTEST_ADDOPTS") else BLENDERS
    # The files are dealt by size, forward and back, so that all shares take about the same time.
    dealt = [files[k :: 2 * shares] + files[2 * shares - 1 - k :: 2 * shares] for k in range(shares)]
    run_at_once([
        ([*command, "--", "-q", *options, *share], blender_folder(f"test-{name}-{k}") | settings)
        for k, share in enumerate(dealt)
    ])  # fmt: skip


def window_tests() -> None:
    require_apt(*BLENDER_APT, *WINDOW_APT)
    python = venv("repository", DEBIAN_PYTHON, PYTEST)
    settings = {"WIREWARP_ZIP": str(debian_blender_zip())} | addon_coverage.begin("window")
    run([python, "-m", "pytest", "-q", "tests/window"], **settings)
    addon_coverage.show("window")


def bpy_python(requirement: str) -> Path:
    version = BPY[requirement]
    return venv(requirement.replace("==", "-"), require_python(version), requirement, PYTEST, NUMPY[version])


def blender_script(python: Path, name: str) -> Path:
    """Return the path of one of the scripts that come with this Python's bpy."""
    (script,) = python.parent.parent.glob(f"lib/*/site-packages/bpy/*/scripts/{name}")
    return script


def bpy_tests(requirement: str) -> None:
    """Check the extension zip with Blender's own program, then run tests of the add-on on this zip."""
    require_apt(*BPY_APT)
    package()
    python = bpy_python(requirement)
    tags = blender_script(python, "modules/_bpy_internal/extensions/tags.py")
    run([python, blender_script(python, EXTENSION_PROGRAM), "validate", f"--valid-tags={tags}", extension_zip()])
    # Blenders except the newest run only tests that depend on Blender's Python interface.
    chosen = "not core" if requirement == list(BPY)[-1] else "api"
    run_addon_tests([python, RUNNER], python.parent.parent.name, "-m", chosen, WIREWARP_ZIP=str(extension_zip()))
