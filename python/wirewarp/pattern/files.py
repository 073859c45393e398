# SPDX-License-Identifier: GPL-3.0-or-later
"""Replaces a file only when the new file is complete, and returns the date to write into files."""

import datetime
import os
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path


def today() -> datetime.date:
    """Return today's date. If SOURCE_DATE_EPOCH (a time in seconds) is set, return the date of that time, so that files
    are reproducible."""
    epoch = os.environ.get("SOURCE_DATE_EPOCH")
    return datetime.datetime.fromtimestamp(int(epoch), datetime.UTC).date() if epoch else datetime.date.today()


@contextmanager
def replaced_file(path: Path) -> Iterator[Path]:
    """Yield the path of a temporary file in the same folder. At the end, the temporary file replaces the file at
    `path`, unless an error was raised.

    Raises OSError if the folder is missing or `path` is not a file.
    """
    path = path.resolve()  # if the path is a link, the file that it points to is replaced
    if not path.parent.is_dir():
        raise FileNotFoundError(f'there is no folder "{path.parent}"')
    if path.exists() and not path.is_file():
        raise IsADirectoryError(f'"{path}" is not a file')
    unfinished = path.with_name(f".wirewarp-{os.getpid()}.part")
    try:
        yield unfinished
        unfinished.replace(path)
    finally:
        unfinished.unlink(missing_ok=True)
