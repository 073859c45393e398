# SPDX-License-Identifier: GPL-3.0-or-later
"""All files of a model take their places together: what is refused or stopped on the way changes nothing."""

import hashlib
import shutil
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from .request import Request


@contextmanager
def staged_folder(request: Request) -> Iterator[Path]:
    """For `with`: a hidden folder beside the files that there will be, which is gone afterward."""
    request.folder.mkdir(parents=True, exist_ok=True)
    remove_staged(request)
    folder = Path(tempfile.mkdtemp(prefix=_prefix(request), dir=request.folder))
    try:
        yield folder
    finally:
        shutil.rmtree(folder, ignore_errors=True)


def remove_staged(request: Request) -> None:
    """What a run of this model has left that was killed."""
    for left in request.folder.glob(f"{_prefix(request)}*"):
        shutil.rmtree(left, ignore_errors=True)


def _prefix(request: Request) -> str:
    """By a digest, for the name of a model may be as long as file systems allow."""
    return f".wirewarp-{hashlib.blake2b(request.model.stem.encode(), digest_size=8).hexdigest()}-"


def take_places(staged: Path, request: Request) -> None:
    """Moves the files where they belong. The report goes first and comes last: where there is one, all is of it."""
    request.report_path.unlink(missing_ok=True)
    for path in request.all_paths:
        if not (staged / path.name).exists():
            path.unlink(missing_ok=True)  # of an earlier run: nobody is to cut it
    for path in staged.iterdir():
        if path.name != request.report_path.name:
            path.replace(request.folder / path.name)
    (staged / request.report_path.name).replace(request.report_path)
