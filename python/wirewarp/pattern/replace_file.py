# SPDX-License-Identifier: GPL-3.0-or-later
"""Files that are there whole or not at all."""

import os
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path


@contextmanager
def replaced_file(path: Path) -> Iterator[Path]:
    """For `with`: a path beside this one to write to, which takes its place if nothing was raised.

    So a full disk leaves the file that was there. Raises OSError if no file can be there.
    """
    path = path.resolve()  # what a link leads to is replaced, and the link stays
    if not path.parent.is_dir():
        raise FileNotFoundError(f'there is no folder "{path.parent}"')
    if path.exists() and not path.is_file():
        raise IsADirectoryError(f'"{path}" is no file')
    unfinished = path.with_name(f".wirewarp-{os.getpid()}.part")
    try:
        yield unfinished
        unfinished.replace(path)
    finally:
        unfinished.unlink(missing_ok=True)
