# SPDX-License-Identifier: GPL-3.0-or-later
"""Flattens Blender files with the add-on, in a Blender without a window. Marks and settings come from the files."""

import json
import shutil
import subprocess
from pathlib import Path
from typing import Any

from ..report import Report, ReportError, from_dict, place_name
from ..report.names import note_text
from .request import InputError, Request
from .verdicts import Line, finished

SCRIPT = Path(__file__).with_name("flatten_in_blender.py")
ANSWER = ".answer.json"


class BlenderError(Exception):
    """Raised if Blender itself crashed. str() is a sentence."""


def flatten_blend(request: Request, folder: Path) -> tuple[Line, dict[str, Any]]:
    """Write patterns to the folder. Return the line to print, and the rest of the report. Raises InputError, or
    BlenderError if Blender crashed."""
    program = shutil.which(request.blender)
    if program is None:
        raise InputError(f'There is no Blender at "{request.blender}": give --blender PATH.')
    job = {"folder": str(folder), "stem": request.model.stem, "formats": request.formats, "answer": ANSWER}
    # Scripts in the file do not run. An absolute path cannot be read as an option, because it does not begin with "-".
    options = ("--background", "--disable-autoexec", str(request.model.absolute()), "--python-exit-code", "1")
    with subprocess.Popen(
        [program, *options, "--python", str(SCRIPT), "--", json.dumps(job)],
        # Nothing is written to this pipe. It closes when this process ends, and the script then ends Blender.
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        errors="replace",
    ) as process:
        said = process.stdout.read() if process.stdout else ""
    answer = folder / ANSWER
    if process.returncode != 0 or not answer.is_file():
        last = said.strip().splitlines()[-1:] or ["it printed nothing"]
        raise BlenderError(f"Blender ended with code {process.returncode}: {last[0]}")
    answered = json.loads(answer.read_text(encoding="utf-8"))
    answer.unlink()
    if answered["refusal"]:
        raise InputError(answered["refusal"])
    return _outcome(request, answered)


def _outcome(request: Request, answered: dict[str, Any]) -> tuple[Line, dict[str, Any]]:
    written = answered["report"]["objects"]
    try:
        reports = [from_dict(each, Report) for each in written]
    except ReportError as error:
        raise InputError(
            f"The add-on in Blender has another version: install the zip of this version there. {error}"
        ) from error
    for each in written:
        del each["seconds"]  # without durations, the same model always gives the same report
    issues = [(report, issue) for report in reports for issue in report.issues]
    problems = [(f"{place_name(report, issue.piece)}: {issue.sentence}", issue.code) for report, issue in issues]
    notes = [note_text(report, note) for report in reports for note in report.notes if note.is_warning]
    warnings = [*notes, *answered["warnings"]]
    line = finished(reports, problems, warnings, files=[request.report_path.name, *answered["files"]])
    return line, answered["report"]
