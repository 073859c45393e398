# SPDX-License-Identifier: GPL-3.0-or-later
"""Finds the models of folders and lists, and the output folder of each model."""

import json
import os
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from pathlib import Path

from .request import FROM_MODEL, SUFFIXES, InputError

LIST = ".jsonl"
Options = dict[str, str | int | float | bool]


@dataclass(frozen=True)
class Found:
    model: Path
    folder: Path  # relative to the output folder
    options: Options = field(default_factory=dict)  # by the name of the option, without "--"
    source: str = ""  # the path of the list, and the number of the line with the options


def found_models(inputs: Iterable[Path]) -> list[Found]:
    """Return the given models, and the models in given folders and lists, in a fixed order. Raises InputError."""
    models: list[Found] = []
    for path in inputs:
        if path.is_dir():
            found = list(_in_folder(path))
        elif path.suffix.lower() == LIST:
            found = list(_in_list(path))
        else:
            found = [Found(path, Path())]  # a missing file is reported later, in the line of the model
        if not found:
            raise InputError(f'there is no model in "{path}": models end in {", ".join(SUFFIXES)}')
        models += found
    return models


def _in_folder(top: Path) -> Iterator[Found]:
    def refuse(error: OSError) -> None:
        raise InputError(f'the folder "{error.filename}" cannot be read: {error.strerror}') from error

    for name, folders, files in os.walk(top, onerror=refuse, followlinks=True):
        folders[:] = sorted(each for each in folders if not each.startswith("."))
        for file in sorted(files):
            if not file.startswith(".") and Path(file).suffix.lower() in SUFFIXES:
                yield Found(Path(name) / file, Path(name).relative_to(top))


def _in_list(path: Path) -> Iterator[Found]:
    """Yield the models of a list. Paths in the list are relative to the folder of the list."""
    try:
        lines = path.read_text(encoding="utf-8").splitlines()
    except (OSError, ValueError) as error:
        raise InputError(f'the list "{path}" cannot be read: {getattr(error, "strerror", None) or error}') from error
    for number, line in enumerate(lines, start=1):
        if not line.strip():
            continue
        source = f'"{path}", line {number}'
        try:
            entry = json.loads(line)
            model = entry.pop("model")
        except (ValueError, AttributeError, KeyError, TypeError) as error:
            raise InputError(f'{source}, is not JSON like {{"model": "a.obj", "seams": "uv"}}') from error
        for option in ("seams", "wires"):
            if option in entry and entry[option] not in ("", *FROM_MODEL):
                entry[option] = str(path.parent / str(entry[option]))
        if not isinstance(model, str) or not all(isinstance(value, str | int | float) for value in entry.values()):
            raise InputError(f"{source}: a model must be text, and its options texts, numbers or true")
        # A model in a subfolder of the list's folder keeps its subfolder in the output.
        is_inside = not Path(model).is_absolute() and ".." not in Path(model).parts
        yield Found(path.parent / model, Path(model).parent if is_inside else Path(), entry, source)
