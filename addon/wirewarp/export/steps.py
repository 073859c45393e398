# SPDX-License-Identifier: GPL-3.0-or-later
"""Common part of the export operators: a dialog that shows sizes beforehand, and a run that writes the file."""

import json
import math
from dataclasses import replace
from pathlib import Path
from typing import NamedTuple

import bpy
import numpy as np
from bpy.props import BoolProperty, StringProperty
from bpy_extras.io_utils import ExportHelper

from ..blender.files import (
    OPTIONS,
    check_ending,
    check_file,
    check_room,
    file_name,
    given_file,
    unwritten,
)
from ..blender.selection import WORKING_MODES, in_object_mode
from ..core import FlattenError, counted, listed, pattern
from ..issues import ObjectError, object_error
from ..solve.steps import CanceledError
from ..state.owners import earlier_sentence, has_flat_object, is_earlier, model_or_self
from ..state.reports import pieces_report
from ..state.settings import number
from ..ui import window_run
from ..ui.editing import OnMesh
from ..ui.layout import draw_sentence
from ..ui.settings import settings_sentence
from ..ui.window_run import WindowSteps
from .export import Exported, KeptMarker, PatternParts, export, made_pattern
from .read import keep_marker, pieces_over_others, read_pattern


def crossing_sentence(made: pattern.Pattern) -> str:
    names = pieces_over_others(made.pieces)
    return f"These pieces overlap: {listed(names)}. Move them apart before you cut." if names else ""


def copies_sentences(made: pattern.Pattern) -> list[str]:
    """Return sentences about pieces that are drawn once for all their copies, and about pieces that are drawn as
    halves."""
    drawn: dict[str, list[str]] = {}
    for piece in made.pieces:
        if piece.copied_names:
            drawn.setdefault(piece.quantity_text, []).append(listed([piece.name, *piece.copied_names]))
    folds = [piece.name for piece in made.pieces if piece.on_fold]
    sentences = [f"{what}: {'; '.join(names)}" for what, names in drawn.items()]
    return [*sentences, f"On the fold: {', '.join(folds)}"] if folds else sentences


def copies_of_piece(made: pattern.Pattern, name: str) -> str:
    """Return a text about the copies and the symmetry of the piece of this name; "" if it has neither. made: the
    pattern in which copies are drawn once, and symmetric pieces as halves."""
    for piece in made.pieces:
        names = [piece.name, *piece.copied_names]
        if name not in names:
            continue
        others = names.copy()
        others.remove(name)  # removes one entry only, because pieces may have the same name
        equal = [f"{piece.quantity_text}, with {listed(others)}"] if others else []
        return ". ".join(equal + ["Can be cut on the fold"] * piece.on_fold)
    return ""


def size_sentences(made: pattern.Pattern, size: np.ndarray) -> list[str]:
    return [f"{counted(len(made.pieces), 'piece')} on {_size_text(made, *size)}.", largest_sentence(made)]


def largest_sentence(made: pattern.Pattern) -> str:
    """Return a sentence about the piece with the largest bounding box, for which a sheet must have room."""
    largest = max(made.pieces, key=lambda piece: float(piece.size.prod()))
    return f"Largest piece: {largest.name}, {_size_text(made, *largest.size)}."


def _size_text(made: pattern.Pattern, width: float, height: float) -> str:
    """Return the text of a size. width, height: millimeters."""
    inch = pattern.units.INCH
    inches = f" ({width / inch:.1f} × {height / inch:.1f} in)" if made.units.name == "imperial" else ""
    return f"{width:.0f} × {height:.0f} mm{inches}"


FAULTS = (ObjectError, FlattenError, OSError, RuntimeError)  # errors whose text is a sentence for the user


class _Beforehand(NamedTuple):
    """Sentences of the dialog, and the settings for which they are valid."""

    settings: tuple
    sentences: list[tuple[str, str]]  # with their icons


class PatternExport(OnMesh, WindowSteps, ExportHelper):
    """Mixin for export operators, which must define filename_ext, choices() and size_sentences()."""

    # Unlike other settings, the path is not remembered, because the next model has another name.
    filepath: StringProperty(name="File Path", description="The file to write", subtype="FILE_PATH", options=OPTIONS)
    report_path: StringProperty(
        name="Report File",
        description="For scripts: JSON file for the warnings",
        subtype="FILE_PATH",
        options=OPTIONS | {"HIDDEN"},
    )
    notch_spacing: number(
        "Notches Every",
        "Distance between notches along seams, in millimeters: at least 1, or 0 for notches only at wires. On both "
        "sides of a seam, it is measured from the same end. Seams shorter than this distance, but at least 15 mm long, "
        "get one notch",
        (0.0, 100.0, 500.0),
        step=1000,
    )
    failed_pieces: BoolProperty(name="Failed Pieces", description="Also export failed pieces, for inspection only")
    modes = WORKING_MODES
    refusal = "Select a model that has been flattened, or its flat pieces"
    _has_dialog = False  # stays False in a script

    def invoke(self, context: bpy.types.Context, event: bpy.types.Event) -> set[str]:
        if not self.filepath:
            name = file_name(_source(context).name, f" Pattern{self.filename_ext}")
            self.filepath = str(Path(bpy.data.filepath).parent / name)
        try:
            self._parts: PatternParts = _read(context)
        except ObjectError as error:
            return self._failed(error)
        self._has_dialog, self._beforehand = True, _Beforehand((), [])
        self._look_ahead()
        return super().invoke(context, event)

    def check(self, context: bpy.types.Context) -> bool:
        """Update the dialog: Blender calls this after each change of a setting."""
        super().check(context)
        self._look_ahead()
        return True

    def _look_ahead(self) -> None:
        key = self.choices(), self.filename_ext, self.failed_pieces
        if key != self._beforehand.settings:
            self._beforehand = _Beforehand(key, self.beforehand(self._parts))

    def beforehand(self, parts: PatternParts) -> list[tuple[str, str]]:
        """Return sentences with their icons: faults first, then the size of the pattern with the present settings."""
        try:
            choices = self.choices()
            made = made_pattern(parts, replace(choices, seconds=0.0))
            sizes = [(sentence, "NONE") for sentence in self.size_sentences(made)]
        except (ObjectError, FlattenError) as error:
            return [(str(error), "ERROR")]
        if made.marker and (parts.kept is None or made.marker != parts.kept.marker) and choices.seconds:
            sizes.insert(0, ("Without a search:", "NONE"))
        refusal = "" if self.failed_pieces else parts.refusal
        return [
            (sentence, "ERROR") for sentence in (refusal, crossing_sentence(made), *made.warnings) if sentence
        ] + sizes

    def draw_beforehand(self, context: bpy.types.Context) -> None:
        for sentence, icon in self._beforehand.sentences:
            draw_sentence(context, self.layout, sentence, icon)

    def draw_lengths(self, context: bpy.types.Context, *names: str) -> None:
        """Draw settings with lengths in millimeters. Scenes in imperial units also show the inches."""
        column, properties = self.layout.column(align=True), self.properties.bl_rna.properties
        for name in names:
            column.prop(self, name, text=f"{properties[name].name} (mm)")
            if context.scene.unit_settings.system == "IMPERIAL":
                column.label(text=f"That is {getattr(self, name) / pattern.units.INCH:.2f} in")

    def execute(self, context: bpy.types.Context) -> set[str]:
        """Read the model again, because it may have changed while the dialog was open. A script waits for the end of
        the run."""
        if window_run.is_running():
            self.report({"ERROR"}, window_run.busy_sentence())
            return {"CANCELLED"}
        try:
            if self.report_path:
                check_room(given_file(self.report_path))
        except OSError as error:
            self.report({"ERROR"}, unwritten(self.report_path, error))
            return {"CANCELLED"}
        try:
            path = given_file(self.filepath)
            check_ending(path, self.filename_ext)
            check_file(path)
            parts = _read(context)
            if parts.refusal and not self.failed_pieces:
                raise object_error("failed_pieces", parts.refusal)
            source = _source(context)
            self._notes = [
                f'Only "{parts.title}" was exported. Export other models separately.' if _has_others(context) else "",
                settings_sentence(source, pieces_report(source), context.scene.wirewarp),
            ]
            self._source_name = source.name_full
            steps = export(parts, self.choices(), path)
            if self._has_dialog:
                return self.begin(context, window_run.EXPORT, parts.title, steps)
            return self._tell(self.wait_for(context, steps))
        except FAULTS as error:
            return self._failed(error)

    def finish_run(self, context: bpy.types.Context) -> set[str]:
        try:
            return self._tell(self._run.result())
        except CanceledError:
            self.report({"WARNING"}, "Export was canceled. Nothing was written.")
            return {"CANCELLED"}
        except FAULTS as error:
            return self._failed(error)

    def _failed(self, error: Exception) -> set[str]:
        self.report({"ERROR"}, unwritten(self.filepath, error) if isinstance(error, OSError) else str(error))
        return {"CANCELLED"}

    def _tell(self, exported: Exported) -> set[str]:
        made, written, cloth = exported.made, exported.written, exported.cloth
        source = bpy.data.objects.get(self._source_name)  # absent if it was deleted or renamed during the run
        if made.marker and source is not None and source.library is None:
            keep_marker(source, KeptMarker(cloth, made.marker))
        only, settings = self._notes
        sizes = " ".join(self.size_sentences(made))
        off = max(math.ceil(100 * written.off), 1) / 100
        # The print scale is first, because the status bar cuts off long sentences.
        said = f'Print at 100% scale. Lengths in "{written.path.name}" are right to {off:g} mm. {sizes}'
        warnings = [sentence for sentence in [crossing_sentence(made), *written.warnings] if sentence]
        if self.report_path:
            try:
                with pattern.files.replaced_file(given_file(self.report_path)) as unfinished:
                    unfinished.write_text(json.dumps({"warnings": warnings}), encoding="utf-8")
            except OSError as error:  # the pattern is written anyway
                warnings.append(unwritten(self.report_path, error))
        lines = [*warnings, f"{said} {only}".rstrip(), settings]
        self.report({"WARNING" if warnings else "INFO"}, "\n".join(filter(None, lines)))
        return {"FINISHED"}


def _read(context: bpy.types.Context) -> PatternParts:
    active = context.active_object
    if is_earlier(active):
        raise object_error("earlier_pieces", earlier_sentence(active))
    with in_object_mode(context):
        return read_pattern(context.scene, _source(context))


def _source(context: bpy.types.Context) -> bpy.types.Object:
    return model_or_self(context.active_object)


def _has_others(context: bpy.types.Context) -> bool:
    """Return whether pieces of other models are selected, too. Each model has its own file."""
    sources = {model_or_self(each) for each in context.selected_objects} - {_source(context)}
    return any(map(has_flat_object, sources))
