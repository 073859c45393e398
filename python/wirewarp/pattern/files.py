# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes files completely or not at all, with a reproducible date on request."""

import datetime
import os
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path


def today() -> datetime.date:
    """Return the date of today or, for reproducible files, of SOURCE_DATE_EPOCH (reproducible-builds.org)."""
    epoch = os.environ.get("SOURCE_DATE_EPOCH")
    return datetime.datetime.fromtimestamp(int(epoch), datetime.UTC).date() if epoch else datetime.date.today()


@contextmanager
def replaced_file(path: Path) -> Iterator[Path]:
    """Yield a temporary path beside this one. At the end, the temporary file replaces this one, unless an error was
    raised. A full disk therefore does not damage the existing file. Raises OSError if no file can be created there."""
    path = path.resolve()  # the target of a link is replaced, and the link stays
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
