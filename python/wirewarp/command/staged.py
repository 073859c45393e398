# SPDX-License-Identifier: GPL-3.0-or-later
"""Moves all files of a model to their places together, so that a refused or stopped run changes no files."""

import hashlib
import json
import shutil
import tempfile
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path

from .request import InputError, Request

HIDDEN = ".wirewarp-"  # prefix of the names of staged folders
EARLIER = ".earlier"  # subfolder of a staged folder, for the files of the previous run


@contextmanager
def staged_folder(request: Request) -> Iterator[Path]:
    """Yield a hidden folder in the output folder, and remove the hidden folder afterward."""
    request.folder.mkdir(parents=True, exist_ok=True)
    remove_staged(request)
    folder = Path(tempfile.mkdtemp(prefix=_prefix(request), dir=request.folder))
    try:
        yield folder
    finally:
        _remove(folder, request)


def remove_staged(request: Request) -> None:
    """Remove the hidden folder of a killed run of this model. Raises OSError if earlier files cannot be put back."""
    for left in request.folder.glob(f"{_prefix(request)}*"):
        _remove(left, request)


def with_left(requests: Sequence[Request]) -> list[Request]:
    """Return the requests for which a killed run left a hidden folder behind."""
    left = {folder: {path.name for path in folder.glob(f"{HIDDEN}*")} for folder in {r.folder for r in requests}}
    return [r for r in requests if any(name.startswith(_prefix(r)) for name in left[r.folder])]


def listed_files(report: Path) -> list[str]:
    """Return the names of the files that a report lists, including the report; none if the file is not our report."""
    try:
        names = json.loads(report.read_text(encoding="utf-8"))["line"]["files"]
        # Names of files in other folders are ignored, because another program may have written the report.
        return [name for name in names if Path(name).name == name]
    except (FileNotFoundError, ValueError, KeyError, TypeError):
        return []


def take_places(staged: Path, request: Request) -> None:
    """Move new files to their places, and earlier files into the staged folder.

    Whenever a report is in its place, all files that are in their places belong to it. Raises InputError before
    replacing a file that the earlier report does not list.
    """
    earlier = listed_files(request.report_path)
    made = sorted((path.name for path in staged.iterdir()), key=lambda name: name == request.report_path.name)
    for name in made:
        if name not in earlier and (request.folder / name).exists():
            raise InputError(
                f'"{request.folder / name}" would be replaced, but no earlier report of "{request.model}" lists it: '
                "move it away, or give another --out."
            )
    (staged / EARLIER).mkdir()
    for name in sorted(earlier, key=lambda name: name != request.report_path.name):
        if (request.folder / name).exists():
            (request.folder / name).replace(staged / EARLIER / name)
    for name in made:
        (staged / name).replace(request.folder / name)


def _remove(staged: Path, request: Request) -> None:
    """Remove the folder. If take_places() was interrupted, put the earlier files back first."""
    if (staged / EARLIER).is_dir() and (staged / request.report_path.name).exists():
        _put_back(staged, request)
    shutil.rmtree(staged, ignore_errors=True)


def _put_back(staged: Path, request: Request) -> None:
    """Move new files back into the staged folder, and earlier files back to their places.

    If this function is killed, it can be called again, because it moves only files that are not moved yet.
    """
    for name in listed_files(staged / request.report_path.name):
        if not (staged / name).exists() and (request.folder / name).exists():
            (request.folder / name).replace(staged / name)
    earlier = sorted((staged / EARLIER).iterdir(), key=lambda path: path.name == request.report_path.name)
    for path in earlier:
        path.replace(request.folder / path.name)
    (staged / EARLIER).rmdir()


def _prefix(request: Request) -> str:
    """Return the prefix of the staged folder. It contains a digest, because names of models may be very long."""
    return f"{HIDDEN}{hashlib.blake2b(request.model.stem.encode(), digest_size=8).hexdigest()}-"
