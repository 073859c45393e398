# SPDX-License-Identifier: GPL-3.0-or-later
"""Tests the wheel of the Python package for Linux on ARM, with QEMU.

The tests use Debian's Python for ARM. apt downloads its packages, which are unpacked into a folder but not installed.
"""

import shutil
from pathlib import Path

from tools.bindings import HYPOTHESIS, MODELS, READERS
from tools.blender import NUMPY, PYTEST
from tools.cross import ARM
from tools.environment import (
    BUILD,
    DEBIAN_VERSION,
    fingerprint,
    is_current,
    require_apt,
    require_python,
    run,
    run_quietly,
    set_current,
)
from tools.libraries import PATTERN, install_for
from tools.package import BUILD_APT, build_wheel, cross_wheel

QEMU_APT = ("qemu-user",)
PYTHON_APT = (f"python{DEBIAN_VERSION}-minimal", f"libpython{DEBIAN_VERSION}-stdlib", "libstdc++6")
FOLDER = BUILD / "arm"
PLATFORMS = ("manylinux_2_28_aarch64", "manylinux2014_aarch64")  # pip's names; each package has a wheel for one of them
# These tests check lengths, errors and pattern files. Other tests are left out, because QEMU is slow, and because some
# of them run programs for this machine's processor.
TESTS = ("test_readme", "test_errors", "test_results", "test_wire_and_options", "test_pattern_files")


def arm_tests() -> None:
    require_apt(*BUILD_APT, *QEMU_APT)
    wheel = build_wheel(DEBIAN_VERSION, require_python(DEBIAN_VERSION))
    made = cross_wheel(ARM, DEBIAN_VERSION, wheel)
    requirements = (PYTEST, HYPOTHESIS, NUMPY[DEBIAN_VERSION], *PATTERN, *READERS, *MODELS)
    packages = FOLDER / "packages"
    key = fingerprint([], *requirements)
    if not (packages.is_dir() and is_current("arm-packages", key)):
        shutil.rmtree(packages, ignore_errors=True)
        install_for(PLATFORMS, DEBIAN_VERSION, packages, *requirements)
        set_current("arm-packages", key)
    install_for(PLATFORMS, DEBIAN_VERSION, packages, "--no-deps", "--upgrade", made)
    root = arm_python()
    python = ("qemu-aarch64", "-L", root, root / "usr" / "bin" / f"python{DEBIAN_VERSION}")
    tests = [f"tests/bindings/{name}.py" for name in TESTS]
    run([*python, "-m", "pytest", "-q", "-p", "no:cacheprovider", *tests], PYTHONPATH=str(packages))


def arm_python() -> Path:
    """Return a root folder with Debian's Python for ARM, which is downloaded once."""
    root = FOLDER / "root"
    key = fingerprint([], *PYTHON_APT)
    if not (root.is_dir() and is_current("arm-python", key)):
        for folder in (root, FOLDER / "apt"):
            shutil.rmtree(folder, ignore_errors=True)
        lists, archives, status = FOLDER / "apt" / "lists", FOLDER / "apt" / "archives", FOLDER / "apt" / "status"
        for folder in (lists, archives):
            (folder / "partial").mkdir(parents=True, exist_ok=True)
        status.touch()  # an empty list of installed packages, so that apt downloads every dependency
        settings = {
            "APT::Architecture": "arm64",
            "APT::Architectures": "arm64",
            "APT::Sandbox::User": "",  # apt does not change the user, because the folders belong to the caller
            "Dir::State::Lists": lists,
            "Dir::State::status": status,
            "Dir::Cache::archives": archives,
            "Dir::Cache::pkgcache": "",
            "Dir::Cache::srcpkgcache": "",
        }
        apt = ["apt-get", "-q", *(f"-o{name}={value}" for name, value in settings.items())]
        run_quietly("asking Debian for its packages for ARM", [*apt, "update"])
        options = ("--yes", "--no-install-recommends", "--download-only")
        run_quietly(f"fetching {' '.join(PYTHON_APT)} for ARM", [*apt, *options, "install", *PYTHON_APT])
        for package in sorted(archives.glob("*.deb")):
            run_quietly(f"unpacking {package.name}", ["dpkg-deb", "--extract", package, root])
        set_current("arm-python", key)
    return root
