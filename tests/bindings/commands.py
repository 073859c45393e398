# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs commands of python -m wirewarp in the process of the tests, which saves a second for each command."""

import io
import json
from contextlib import redirect_stderr, redirect_stdout
from functools import partial

import pytest

pytest.importorskip("trimesh")

from wirewarp.command import run as command_run
from wirewarp.command.arguments import parsed

# An OBJ file of a square of 100 mm with a lifted corner. Its UV map has two islands, the halves of the square.
FOLDED = """v 0 0 0\nv .05 0 0\nv .1 0 0\nv 0 .1 0\nv .05 .1 0\nv .1 .1 .04
vt 0 0\nvt .4 0\nvt .4 1\nvt 0 1\nvt .6 0\nvt 1 0\nvt 1 1\nvt .6 1
f 1/1 2/2 5/3 4/4\nf 2/5 3/6 6/7 5/8\n"""


def printed(command, *words, code=0):
    """Run the command, and return its printed lines and the text on standard error. code: expected exit code."""
    output, errors = io.StringIO(), io.StringIO()
    with redirect_stdout(output), redirect_stderr(errors):
        try:
            ended = command_run.run(parsed([command, *map(str, words)]))
        except SystemExit as refusal:  # raised for invalid arguments
            ended = refusal.code
    assert ended == code, errors.getvalue()
    return [json.loads(line) for line in output.getvalue().splitlines()], errors.getvalue()


def contents(folder):
    """Return the contents of all files below the folder, keyed by their relative paths."""
    return {path.relative_to(folder).as_posix(): path.read_bytes() for path in folder.rglob("*") if path.is_file()}


flatten, batch, propose = (partial(printed, command) for command in ("flatten", "batch", "propose"))
