# SPDX-License-Identifier: GPL-3.0-or-later
"""Installs the add-on from a repository in Blender, and updates it, as users do.

Usage: python update_in_blender.py REPOSITORY GENERATOR

- REPOSITORY: dist/repository/
- GENERATOR: Blender's program for extensions

The environment variable BLENDER_USER_RESOURCES must be the path of an empty folder.
"""

import os
import shutil
import subprocess
import sys
import traceback
import zipfile
from pathlib import Path

import bpy

NEXT_VERSION = "99.0.0"  # higher than any future version of this project
MODULE = "bl_ext.WireWarpupdates.wirewarp"  # Blender's name of the add-on contains the repository's name
SAMPLE = Path(__file__).resolve().parents[2] / "blend_samples" / "half_cylinder.blend"


def raise_version(zip_file: Path) -> None:
    with zipfile.ZipFile(zip_file) as archive:
        files = {name: archive.read(name) for name in archive.namelist()}
    (manifest,) = (name for name in files if name.endswith("blender_manifest.toml"))
    lines = files[manifest].decode().splitlines()
    raised = [f'version = "{NEXT_VERSION}"' if line.startswith("version = ") else line for line in lines]
    assert raised != lines
    files[manifest] = "\n".join(raised).encode()
    with zipfile.ZipFile(zip_file, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in files.items():
            archive.writestr(name, content)


def installed_version(repository: bpy.types.UserExtensionRepo) -> str:
    manifest = Path(repository.directory) / "wirewarp" / "blender_manifest.toml"
    (line,) = (line for line in manifest.read_text().splitlines() if line.startswith("version = "))
    return line.split('"')[1]


def flatten_sample() -> None:
    bpy.ops.wm.open_mainfile(filepath=str(SAMPLE))
    assert bpy.ops.object.wirewarp_flatten() == {"FINISHED"}
    assert [each for each in bpy.data.objects if each.name.endswith("Flat")]


def main() -> None:
    original, generator = map(Path, sys.argv[1:])
    folder = Path(os.environ["BLENDER_USER_RESOURCES"]) / "served"
    shutil.copytree(original, folder)

    preferences = bpy.context.preferences
    preferences.system.use_online_access = True  # as a user allows it on the splash screen
    address = (folder / "index.json").as_uri()
    bpy.ops.preferences.extension_repo_add(name="WireWarp updates", remote_url=address, type="REMOTE")
    index, repository = next((i, r) for i, r in enumerate(preferences.extensions.repos) if r.remote_url == address)
    assert repository.module == MODULE.split(".")[1]

    bpy.ops.extensions.repo_sync(repo_index=index)
    bpy.ops.extensions.package_install(repo_index=index, pkg_id="wirewarp", enable_on_install=True)
    assert MODULE in preferences.addons
    first = installed_version(repository)
    flatten_sample()

    for zip_file in folder.glob("*.zip"):
        raise_version(zip_file)
    subprocess.run([sys.executable, generator, "server-generate", f"--repo-dir={folder}"], check=True)
    bpy.ops.extensions.repo_sync(repo_index=index)
    bpy.ops.extensions.package_upgrade_all()
    assert first != installed_version(repository) == NEXT_VERSION, (first, installed_version(repository))
    assert MODULE in preferences.addons
    flatten_sample()
    print(f"installed {first}, updated to {NEXT_VERSION}: 1 passed, 0 failed")


code = 1
try:
    main()
    code = 0
except Exception:
    traceback.print_exc()
sys.stdout.flush()
sys.stderr.flush()
shutil.rmtree(bpy.app.tempdir, ignore_errors=True)
os._exit(code)  # when Python ends, bpy could wait forever for one of its threads
