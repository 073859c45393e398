# SPDX-License-Identifier: GPL-3.0-or-later
"""File > Export: the pattern as an SVG file."""

from pathlib import Path

import bpy
from bpy.props import BoolProperty, FloatProperty, StringProperty
from bpy_extras.io_utils import ExportHelper

from ..blender.files import OPTIONS, check_ending, file_name, given_file, replaced_file, unwritten
from ..blender.modes import in_object_mode
from ..flat.pattern import read_pattern
from ..flat.reports import pieces_report
from ..issues import ObjectError, object_error
from ..model.owners import earlier_sentence, has_flat_object, is_earlier, model_or_self
from ..pattern.pattern import IMPERIAL, INCH, Pattern, pieces_over_others
from ..pattern.svg import page_size, write_svg
from ..report.verdict import SHOWN_NAMES
from ..ui.layout import draw_sentence
from ..ui.settings import settings_sentence
from ..words import counted


class OBJECT_OT_wirewarp_export_svg(bpy.types.Operator, ExportHelper):
    """Write the flat pieces of the active object to an SVG file in true size, with wires, notches and names"""

    bl_idname = "object.wirewarp_export_svg"
    bl_label = "Export Pattern"

    filename_ext = ".svg"
    # Skipped when settings are kept for the next time: the next model gets a name of its own.
    filepath: StringProperty(name="File Path", description="The file to write", subtype="FILE_PATH", options=OPTIONS)
    filter_glob: StringProperty(description="The files shown", default="*.svg", options={"HIDDEN"})
    notch_spacing: FloatProperty(
        name="Notches Every",
        description="Distance in millimeters (25.4 to the inch) of notches along seams, from the same end on both "
        "sides; shorter seams get one in their middle, from 15 mm on. Ends of wires always get one. At least 1 mm; 0: "
        "no others",
        min=0.0,
        soft_max=500.0,
        default=100.0,
        precision=1,
        step=1000,
    )
    failed_pieces: BoolProperty(
        name="Failed Pieces",
        description="Also export failed pieces, for inspection only",
        default=False,
    )

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        active = context.active_object
        if active is not None and active.type == "MESH" and context.mode in {"OBJECT", "EDIT_MESH"}:
            return True
        cls.poll_message_set("Select a model that has been flattened, or its flat pieces")
        return False

    def invoke(self, context: bpy.types.Context, event: bpy.types.Event) -> set[str]:
        source = _source(context)
        if not self.filepath:
            self.filepath = str(Path(bpy.data.filepath).parent / file_name(source.name, " Pattern.svg"))
        try:
            pattern = self._pattern(context, failed_too=True)
        except ObjectError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        self._sizes, self._crossing = _size_sentences(pattern), _crossing_sentence(pattern)
        return super().invoke(context, event)

    def draw(self, context: bpy.types.Context) -> None:
        if self._crossing:
            draw_sentence(context, self.layout, self._crossing, "ERROR")
        for sentence in self._sizes:
            draw_sentence(context, self.layout, sentence)
        self.layout.prop(self, "notch_spacing", text="Notches Every (mm)")
        if context.scene.unit_settings.system == "IMPERIAL":
            self.layout.label(text=f"That is {self.notch_spacing / INCH:.2f} in")
        self.layout.prop(self, "failed_pieces")

    def execute(self, context: bpy.types.Context) -> set[str]:
        try:
            path = given_file(self.filepath)
            check_ending(path, self.filename_ext)
            pattern = self._pattern(context, self.failed_pieces)
            with replaced_file(path) as unfinished:
                write_svg(unfinished, pattern)
        except ObjectError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        except OSError as error:
            self.report({"ERROR"}, unwritten(self.filepath, error))
            return {"CANCELLED"}
        only = f' Of the selected ones, "{pattern.title}" only.' if _has_others(context) else ""
        said = f'"{path.name}": {" ".join(_size_sentences(pattern))} Print at 100%.{only}'
        source, crossing = _source(context), _crossing_sentence(pattern)
        settings = settings_sentence(source, pieces_report(source), context.scene.wirewarp)
        self.report({"WARNING" if crossing else "INFO"}, "\n".join(filter(None, [crossing, said, settings])))
        return {"FINISHED"}

    def _pattern(self, context: bpy.types.Context, failed_too: bool) -> Pattern:
        active, source = context.active_object, _source(context)
        if is_earlier(active):
            raise object_error("earlier_pieces", earlier_sentence(active))
        with in_object_mode(context):
            return read_pattern(context.scene, source, self.notch_spacing, failed_too)


def _source(context: bpy.types.Context) -> bpy.types.Object:
    return model_or_self(context.active_object)


def _has_others(context: bpy.types.Context) -> bool:
    """Whether pieces of other models are selected, too: each has a file of its own."""
    sources = {model_or_self(each) for each in context.selected_objects} - {_source(context)}
    return any(map(has_flat_object, sources))


def _crossing_sentence(pattern: Pattern) -> str:
    """Empty where no pieces lie over one another."""
    names = pieces_over_others(pattern)
    if not names:
        return ""
    hidden = len(names) - SHOWN_NAMES
    shown = ", ".join(names[:SHOWN_NAMES]) + (f" and {hidden} more" if hidden > 0 else "")
    return f"These pieces lie over one another: {shown}. Move them apart before you cut."


def _size_sentences(pattern: Pattern) -> list[str]:
    width, height = page_size(pattern)
    count = counted(len(pattern.pieces), "piece")
    return [
        f"{count} on {_size_text(pattern, width, height)}.",
        f"The largest, {pattern.largest.name}: {_size_text(pattern, *pattern.largest.size)}.",
    ]


def _size_text(pattern: Pattern, width: float, height: float) -> str:
    """Of millimeters, in inches too for those who measure in them."""
    inches = f" ({width / INCH:.1f} × {height / INCH:.1f} in)" if pattern.ruler == IMPERIAL else ""
    return f"{width:.0f} × {height:.0f} mm{inches}"
