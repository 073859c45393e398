# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks paths that users and scripts enter, and makes file names and the sentences of file errors."""

import os
import re
from pathlib import Path

import bpy

# Options of a property with a path that may be relative. Blender before 4.5 has no option for relative paths.
OPTIONS = {"SKIP_SAVE", "PATH_SUPPORTS_BLEND_RELATIVE"} if bpy.app.version >= (4, 5, 0) else {"SKIP_SAVE"}
LONGEST_NAME = 200  # bytes; most systems allow 255
# Windows reserves these names, with or without a suffix.
DEVICE = re.compile(r"(con|prn|aux|nul|com\d|lpt\d)(\.|$)", re.IGNORECASE)
NOT_IN_NAMES = re.compile(r'[/\\:*?"<>|\x00-\x1f]')  # characters that some operating systems forbid


def given_file(path: str) -> Path:
    """Return the path, with "//" at its beginning replaced by the folder of the Blender file. Raise OSError if the path
    begins with "//" and the Blender file was never saved."""
    if path.startswith("//") and not bpy.data.filepath:
        raise OSError('"//" is the folder of the Blender file, so save the file first')
    return Path(bpy.path.abspath(path))


def file_name(name: str, ending: str) -> str:
    """Return a file name for an object's name, without a folder. Replace forbidden characters, and cut long names."""
    plain = NOT_IN_NAMES.sub("_", f"_{name}" if DEVICE.match(name) else name).encode(errors="replace")
    return plain[: LONGEST_NAME - len(ending)].decode(errors="ignore") + ending


def unwritten(path: str | Path, error: OSError) -> str:
    return f'Cannot write "{path}": {error.strerror or error}.'


def check_file(path: Path) -> None:
    """Raises OSError if no file can be written at this path. Blender files are never overwritten."""
    path = path.resolve()
    if not path.parent.is_dir():
        raise OSError(f'there is no folder "{path.parent}"')
    if path.exists() and not path.is_file():
        raise OSError("it is a folder" if path.is_dir() else "it is a device")
    if re.fullmatch(r"\.blend\d*", path.suffix.lower()):
        raise OSError("a Blender file has this name, so choose another name")


def check_ending(path: Path, ending: str) -> None:
    if path.suffix.lower() != ending:
        raise OSError(f"its name must end in {ending}")


def check_room(path: Path) -> None:
    """Raises OSError like check_file, or if the folder accepts no new files."""
    check_file(path)
    # tempfile is not used, because it tries 10,000 names if Windows denies access.
    trial = path.resolve().with_name(f".wirewarp-{os.getpid()}")
    with trial.open("xb"):
        pass
    trial.unlink()
