# SPDX-License-Identifier: GPL-3.0-or-later
"""Files that are there whole or not at all. No Blender in here."""

import os
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path


@contextmanager
def replaced_file(path: Path) -> Iterator[Path]:
    """For `with`: a path beside this one to write to, which takes its place if nothing was raised.

    So a full disk leaves the file that was there. Raises OSError if that is a folder or a device.
    """
    path = path.resolve()  # what a link leads to is replaced, and the link stays
    if path.exists() and not path.is_file():
        raise OSError(f"it is no file but a {'directory' if path.is_dir() else 'device'}")
    unfinished = path.with_name(f".wirewarp-{os.getpid()}.part")
    try:
        yield unfinished
        unfinished.replace(path)
    finally:
        unfinished.unlink(missing_ok=True)
