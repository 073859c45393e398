# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes dist/repository/: a folder that any web server can offer as an extension repository, with updates in Blender.

Blender's own generator writes index.json, so the list always has the format that Blender reads.
"""

import json
import shutil
from pathlib import Path

from tools.blender import BPY, BPY_APT, EXTENSION_PROGRAM, blender_folder, blender_script, bpy_python
from tools.environment import DEBIAN_VERSION, ROOT, StepError, require_apt, run_quietly
from tools.package import DIST, package
from tools.zips import extension_zips

REPOSITORY = DIST / "repository"
# In this template, Blender replaces ${body} by the table of zips, and ${date} by the time.
PAGE = ROOT / "tools" / "repository.html"
# This bpy generates the list. It is the newest that runs in Debian's Python.
GENERATOR = next((each for each in reversed(BPY) if BPY[each] == DEBIAN_VERSION), "")


def write_repository(zips: Path) -> Path:
    """Copy the extension zips in `zips` to dist/repository/, and write Blender's list of them, index.json, beside them.

    Return dist/repository/.
    """
    found = extension_zips(zips)
    if not found:
        raise StepError(f"there is no extension zip in {zips}; ./dev package makes one")
    shutil.rmtree(REPOSITORY, ignore_errors=True)
    REPOSITORY.mkdir(parents=True)
    for path in found:
        shutil.copy(path, REPOSITORY)
    python = bpy_python(GENERATOR)
    command: list[str | Path] = [
        python,
        blender_script(python, EXTENSION_PROGRAM),
        "server-generate",
        f"--repo-dir={REPOSITORY}",
    ]
    run_quietly("listing the extensions", [*command, "--html", f"--html-template={PAGE}"])
    listed = json.loads((REPOSITORY / "index.json").read_text())["data"]
    if sorted(each["archive_url"] for each in listed) != [f"./{path.name}" for path in found]:
        raise StepError(f"Blender refused a zip of {REPOSITORY}: its index.json lists {len(listed)} of {len(found)}")
    return REPOSITORY


def update_tests() -> None:
    """In every Blender of BPY, with private settings, add dist/repository/, install WireWarp from it, and update it."""
    require_apt(*BPY_APT)
    package()
    folder = write_repository(DIST)
    for requirement in BPY:
        python = bpy_python(requirement)
        settings = blender_folder(f"updates-{requirement.replace('==', '-')}")
        update: list[str | Path] = [
            python,
            "tests/package/update_in_blender.py",
            folder,
            blender_script(python, EXTENSION_PROGRAM),
        ]
        run_quietly(f"installing and updating from {folder.relative_to(ROOT)} in {requirement}", update, **settings)
