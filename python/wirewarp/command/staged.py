# SPDX-License-Identifier: GPL-3.0-or-later
"""Moves all files of a model to their places together, so that a refused or stopped run changes nothing."""

import hashlib
import json
import shutil
import tempfile
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path

from .request import InputError, Request

HIDDEN = ".wirewarp-"  # prefix of the names of staged folders
EARLIER = ".earlier"  # folder in the staged folder for the files of the previous run


@contextmanager
def staged_folder(request: Request) -> Iterator[Path]:
    """Yield a hidden folder beside the future files, and remove it afterward."""
    request.folder.mkdir(parents=True, exist_ok=True)
    remove_staged(request)
    folder = Path(tempfile.mkdtemp(prefix=_prefix(request), dir=request.folder))
    try:
        yield folder
    finally:
        _remove(folder, request)


def remove_staged(request: Request) -> None:
    """Remove the remains of a killed run of this model. Raises OSError if files cannot be put back."""
    for left in request.folder.glob(f"{_prefix(request)}*"):
        _remove(left, request)


def with_left(requests: Sequence[Request]) -> list[Request]:
    """Return the requests whose models have a folder left behind by a killed run."""
    left = {folder: {path.name for path in folder.glob(f"{HIDDEN}*")} for folder in {r.folder for r in requests}}
    return [r for r in requests if any(name.startswith(_prefix(r)) for name in left[r.folder])]


def listed_files(report: Path) -> list[str]:
    """Return the files that our report lists, including itself; none if it is not our report."""
    try:
        names = json.loads(report.read_text(encoding="utf-8"))["line"]["files"]
        # accepts only names of files beside the report, because others may have written it
        return [name for name in names if Path(name).name == name]
    except (FileNotFoundError, ValueError, KeyError, TypeError):
        return []


def take_places(staged: Path, request: Request) -> None:
    """Move the files to their places, and the earlier files into the staged folder, which is removed.

    The report is removed first and placed last, so that all files belong to it whenever it exists. Raises InputError if
    a file is not ours.
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
    """Remove the folder. After an error or a kill during take_places, put the earlier files back first."""
    if (staged / EARLIER).is_dir() and (staged / request.report_path.name).exists():
        _put_back(staged, request)
    shutil.rmtree(staged, ignore_errors=True)


def _put_back(staged: Path, request: Request) -> None:
    """Put the earlier files back. This can be repeated after a kill: a new file is in place once it has left the
    folder."""
    for name in listed_files(staged / request.report_path.name):
        if not (staged / name).exists() and (request.folder / name).exists():
            (request.folder / name).replace(staged / name)
    earlier = sorted((staged / EARLIER).iterdir(), key=lambda path: path.name == request.report_path.name)
    for path in earlier:
        path.replace(request.folder / path.name)
    (staged / EARLIER).rmdir()


def _prefix(request: Request) -> str:
    """Use a digest, because the name of a model may already have the maximum length of the file system."""
    return f"{HIDDEN}{hashlib.blake2b(request.model.stem.encode(), digest_size=8).hexdigest()}-"
