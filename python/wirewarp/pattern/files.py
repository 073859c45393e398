# SPDX-License-Identifier: GPL-3.0-or-later
"""Files are written whole or not at all, and are dated alike on request."""

import datetime
import os
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path


def today() -> datetime.date:
    """The date, or that of SOURCE_DATE_EPOCH (reproducible-builds.org) so that files are the same again."""
    epoch = os.environ.get("SOURCE_DATE_EPOCH")
    return datetime.datetime.fromtimestamp(int(epoch), datetime.UTC).date() if epoch else datetime.date.today()


@contextmanager
def replaced_file(path: Path) -> Iterator[Path]:
    """For `with`: a path beside this one to write to, which takes its place if nothing was raised.

    So a full disk leaves the file that was there. Raises OSError if no file can be there.
    """
    path = path.resolve()  # what a link leads to is replaced, and the link stays
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
