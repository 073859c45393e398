# SPDX-License-Identifier: GPL-3.0-or-later
"""Installs a zip as users do, then runs pytest inside Blender and exits with its code.

blender --background --factory-startup --python-exit-code 1 --python tests/addon/run_in_blender.py -- PYTEST_ARGUMENTS
python tests/addon/run_in_blender.py -- PYTEST_ARGUMENTS        (a Python with bpy)

Environment variables:

- WIREWARP_ZIP: path of the zip
- BLENDER_USER_RESOURCES (Blender 3.4: BLENDER_USER_SCRIPTS and _CONFIG): an empty folder for the installed files
"""

import os
import shutil
import sys
from pathlib import Path

import bpy
import pytest


def install(path: str) -> None:
    if "legacy" in Path(path).name:
        bpy.ops.preferences.addon_install(filepath=path, overwrite=True)
        bpy.ops.preferences.addon_enable(module="wirewarp_addon")
    else:
        bpy.ops.extensions.package_install_files(repo="user_default", filepath=path, enable_on_install=True)


measured = None
if "COVERAGE_PROCESS_START" in os.environ:  # path of the settings of coverage; see tools/addon_coverage.py
    import coverage

    measured = coverage.process_startup()
install(os.environ["WIREWARP_ZIP"])
code = pytest.main(sys.argv[sys.argv.index("--") + 1 :])
if measured:
    measured.stop()
    measured.save()
sys.stdout.flush()
sys.stderr.flush()
if not bpy.app.binary_path:  # At the end of Python, the module bpy could wait forever for one of its threads.
    shutil.rmtree(bpy.app.tempdir, ignore_errors=True)
    os._exit(int(code))
sys.exit(int(code))
