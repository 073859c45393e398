# SPDX-License-Identifier: GPL-3.0-or-later
"""All files of a model take their places together: what is refused or stopped on the way changes nothing."""

import hashlib
import json
import shutil
import tempfile
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path

from .input_error import InputError
from .request import Request

HIDDEN = ".wirewarp-"  # how the names of staged folders begin
EARLIER = ".earlier"  # folder in the staged one, for the files of the last run


@contextmanager
def staged_folder(request: Request) -> Iterator[Path]:
    """For `with`: a hidden folder beside the files that there will be, which is gone afterward."""
    request.folder.mkdir(parents=True, exist_ok=True)
    remove_staged(request)
    folder = Path(tempfile.mkdtemp(prefix=_prefix(request), dir=request.folder))
    try:
        yield folder
    finally:
        _remove(folder, request)


def remove_staged(request: Request) -> None:
    """What a run of this model has left that was killed. Raises OSError if files cannot be put back."""
    for left in request.folder.glob(f"{_prefix(request)}*"):
        _remove(left, request)


def with_left(requests: Sequence[Request]) -> list[Request]:
    """Those of which a run that was killed has left a folder."""
    left = {folder: {path.name for path in folder.glob(f"{HIDDEN}*")} for folder in {r.folder for r in requests}}
    return [r for r in requests if any(name.startswith(_prefix(r)) for name in left[r.folder])]


def listed_files(report: Path) -> list[str]:
    """The names of the files that a report of ours is of, itself among them; none if it is not our report."""
    try:
        names = json.loads(report.read_text(encoding="utf-8"))["line"]["files"]
        return [name for name in names if Path(name).name == name]  # beside it, whoever has written it
    except (FileNotFoundError, ValueError, KeyError, TypeError):
        return []


def take_places(staged: Path, request: Request) -> None:
    """Moves the files where they belong, and those of the last run into the staged folder, which is removed.

    The report goes first and comes last: where there is one, all is of it. Raises InputError where a file is of others.
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
    """After an error or a kill amid take_places, what was there before is put back first."""
    if (staged / EARLIER).is_dir() and (staged / request.report_path.name).exists():
        _put_back(staged, request)
    shutil.rmtree(staged, ignore_errors=True)


def _put_back(staged: Path, request: Request) -> None:
    """Killed at any moment, it can be done again: a new file is in its place as long as it is not in the folder."""
    for name in listed_files(staged / request.report_path.name):
        if not (staged / name).exists() and (request.folder / name).exists():
            (request.folder / name).replace(staged / name)
    earlier = sorted((staged / EARLIER).iterdir(), key=lambda path: path.name == request.report_path.name)
    for path in earlier:
        path.replace(request.folder / path.name)
    (staged / EARLIER).rmdir()


def _prefix(request: Request) -> str:
    """By a digest, for the name of a model may be as long as file systems allow."""
    return f"{HIDDEN}{hashlib.blake2b(request.model.stem.encode(), digest_size=8).hexdigest()}-"
