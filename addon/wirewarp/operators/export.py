# SPDX-License-Identifier: GPL-3.0-or-later
"""File > Export: the pattern as a file to print, plot or cut."""

from pathlib import Path

import bpy
import numpy as np
from bpy.props import BoolProperty, EnumProperty, FloatProperty, StringProperty
from bpy_extras.io_utils import ExportHelper

from ..blender.files import OPTIONS, check_ending, check_file, file_name, given_file, unwritten
from ..blender.modes import in_object_mode
from ..core import FlattenError, pattern
from ..flat.pattern import PatternChoices, pieces_over_others, read_pattern
from ..flat.reports import pieces_report
from ..issues import ObjectError, object_error
from ..model.owners import earlier_sentence, has_flat_object, is_earlier, model_or_self
from ..properties import allowance_property
from ..report.verdict import SHOWN_NAMES
from ..ui.layout import draw_sentence
from ..ui.settings import settings_sentence
from ..words import counted

INCH = 25.4
FORMATS = [
    ("PDF", "PDF, to print", "Sheets to tape together, a roll for a plotter, or one page for a projector"),
    ("SVG", "SVG, to draw on and cut", "For Inkscape, LightBurn, Glowforge and Cricut"),
    ("DXF", "DXF, for CAD", "For programs of the clothing industry, or for lasers and routers"),
    ("PLT", "PLT, for plotters", "HPGL, which plotters and vinyl cutters read"),
]
PAPERS = {  # as the library knows them, and as makers do
    "A4": ("a4", "A4"),
    "LETTER": ("letter", "Letter"),
    "A4_LETTER": ("a4-letter", "A4 or Letter"),
    "A3": ("a3", "A3"),
    "TABLOID": ("tabloid", "Tabloid"),
    "A0": ("a0", "A0"),
    "ROLL_36": ("36in", "Roll of 36 in"),
    "ROLL_24": ("24in", "Roll of 24 in"),
    "ROLL": ("", "Roll of another width"),
    "PROJECTOR": ("projector", "Projector"),
}
ONE_PAGE = "PROJECTOR"
PRESETS = [
    ("PRINT", "To print or draw on", "Colors, dashes and texts"),
    ("LASER", "Laser", "For LightBurn, Glowforge and the like: thin lines without dashes, no texts"),
    ("CRICUT", "Cricut", "As for lasers, and in pixels, for programs that know no units"),
]
DIALECTS = [
    ("ASTM", "Clothing: ASTM", "Layers by number, as AccuMark reads them"),
    ("AAMA", "Clothing: AAMA", "Layers by number, as CLO and Optitex read them"),
    ("PLAIN", "Lasers and drawing", "Outlines on named layers, in millimeters"),
]
DRAWN = [  # kinds of the library, upper case and with underscores
    ("SEW", "Sew Lines", "Where to sew, inside the line to cut"),
    ("WIRES", "Wires", "The wires inside of pieces"),
    ("GRAIN", "Grain", "An arrow along the grain"),
    ("NOTCHES", "Notches", "Notches, clips and holes to drill"),
    ("TEXTS", "Texts", "Name, number and how often to cut the piece"),
    ("LINE_NAMES", "Line Names", "Numbers of seams, which are the same on both sides, and names of wires"),
]
DARTS = [
    ("CLOSE", "Closed", "Cut straight over their mouths, to be folded: notches at the legs, a hole before the tip"),
    ("CUT", "Cut Out", "Cut out, with allowance on the legs"),
    ("SLIT", "Slit", "Cut along the legs"),
]
ALL_DRAWN = {kind for kind, _, _ in DRAWN}


class PatternExport(ExportHelper):
    """What both operators share; mixed into them. Each has `filename_ext`, and says what it writes."""

    # Skipped when settings are kept for the next time: the next model gets a name of its own.
    filepath: StringProperty(name="File Path", description="The file to write", subtype="FILE_PATH", options=OPTIONS)
    notch_spacing: FloatProperty(
        name="Notches Every",
        description="Distance in millimeters (25.4 to the inch) of notches along seams, from the same end on both "
        "sides; shorter seams get one near their middle, from 15 mm on. Ends of wires always get one. At least 1 mm; "
        "0: no others",
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
        if not self.filepath:
            name = file_name(_source(context).name, f" Pattern{self.filename_ext}")
            self.filepath = str(Path(bpy.data.filepath).parent / name)
        try:
            self._pattern(context, failed_too=True)
        except ObjectError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        self._told: tuple[tuple, list[tuple[str, str]]] = ((), [])
        return super().invoke(context, event)

    def draw_beforehand(self, context: bpy.types.Context) -> None:
        """How large it gets with the present settings, or what is wrong with them."""
        names = [each.identifier for each in self.bl_rna.properties if each.identifier not in {"rna_type", "filepath"}]
        key = tuple(_comparable(getattr(self, name)) for name in names)
        if self._told[0] != key:
            self._told = key, self._sentences(context)
        for sentence, icon in self._told[1]:
            draw_sentence(context, self.layout, sentence, icon)

    def _sentences(self, context: bpy.types.Context) -> list[tuple[str, str]]:
        try:
            made = self.made(context, failed_too=True)
            crossing = crossing_sentence(made)
            sizes = [(sentence, "NONE") for sentence in self.size_sentences(made)]
        except (ObjectError, FlattenError) as error:
            return [(str(error), "ERROR")]
        warnings = [(sentence, "ERROR") for sentence in [crossing, *made.warnings] if sentence]
        return warnings + sizes

    def draw_lengths(self, context: bpy.types.Context, *names: str) -> None:
        """Settings in millimeters."""
        column = self.layout.column(align=True)
        for name in names:
            column.prop(self, name, text=f"{self.bl_rna.properties[name].name} (mm)")
            if context.scene.unit_settings.system == "IMPERIAL":
                column.label(text=f"That is {getattr(self, name) / INCH:.2f} in")

    def execute(self, context: bpy.types.Context) -> set[str]:
        try:
            path = given_file(self.filepath)
            check_ending(path, self.filename_ext)
            check_file(path)
            made = self.made(context, self.failed_pieces)
            written = made.write(path, **self.write_options())
        except (ObjectError, FlattenError, RuntimeError) as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        except OSError as error:
            self.report({"ERROR"}, unwritten(self.filepath, error))
            return {"CANCELLED"}
        only = f' Of the selected ones, "{made.title}" only.' if _has_others(context) else ""
        sizes = " ".join(self.size_sentences(made))
        said = f'"{path.name}": {sizes} Read again: {written.off:.2f} mm off. Print at 100%.{only}'
        source, crossing = _source(context), crossing_sentence(made)
        settings = settings_sentence(source, pieces_report(source), context.scene.wirewarp)
        warnings = [sentence for sentence in [crossing, *written.warnings] if sentence]
        self.report({"WARNING" if warnings else "INFO"}, "\n".join(filter(None, [*warnings, said, settings])))
        return {"FINISHED"}

    def _pattern(self, context: bpy.types.Context, failed_too: bool) -> pattern.Pattern:
        active, source = context.active_object, _source(context)
        if is_earlier(active):
            raise object_error("earlier_pieces", earlier_sentence(active))
        with in_object_mode(context):
            return read_pattern(context.scene, source, self.choices(), failed_too)


class OBJECT_OT_wirewarp_export(PatternExport, bpy.types.Operator):
    """Write the flat pieces of the active object in true size, with seam allowances: to print, to plot or to cut"""

    bl_idname = "object.wirewarp_export"
    bl_label = "Export Pattern"

    filter_glob: StringProperty(
        description="The files shown", default="*.pdf;*.svg;*.dxf;*.plt", options={"HIDDEN", "SKIP_SAVE"}
    )
    format: EnumProperty(
        name="Format", description="What the pattern is for. Of scripts: by the name of the file", items=FORMATS
    )
    paper: EnumProperty(
        name="Paper",
        description="What is printed on",
        items=[(key, name, "") for key, (_, name) in PAPERS.items()],
        default="A4",
    )
    roll_width: FloatProperty(
        name="Roll Width",
        description="In millimeters, margins of 10 mm included",
        min=100.0,
        max=5000.0,
        default=1500.0,
        precision=0,
    )
    proof_sheet: BoolProperty(
        name="Proof Sheet",
        description="Last comes a table of all pieces, and of all seams with the lengths of both sides",
        default=False,
    )
    preset: EnumProperty(name="For", description="How the lines look", items=PRESETS, default="PRINT")
    dialect: EnumProperty(name="For", description="Which programs read it", items=DIALECTS, default="ASTM")
    control_square: BoolProperty(
        name="Control Square",
        description="A piece more, a square of 100 mm: whatever unit a program takes, it shows",
        default=False,
    )
    drawn: EnumProperty(
        name="Drawn", description="Besides lines to cut", items=DRAWN, options={"ENUM_FLAG"}, default=ALL_DRAWN
    )
    allowance: allowance_property()
    darts: EnumProperty(name="Darts", description="What is cut of them", items=DARTS, default="CLOSE")
    keep_places: BoolProperty(
        name="As They Lie",
        description="Pieces stay beside each other as in the flat object. Off: in rows. Sheets and rolls have rows",
        default=False,
    )

    @property
    def filename_ext(self) -> str:
        return f".{self.format.lower()}"

    def invoke(self, context: bpy.types.Context, event: bpy.types.Event) -> set[str]:
        if not self.properties.is_property_set("allowance"):
            self.allowance = context.scene.wirewarp.allowance
        return super().invoke(context, event)

    def execute(self, context: bpy.types.Context) -> set[str]:
        ending = Path(self.filepath).suffix[1:].upper()
        if not self.properties.is_property_set("format") and ending in {key for key, _, _ in FORMATS}:
            self.format = ending
        return super().execute(context)

    def draw(self, context: bpy.types.Context) -> None:
        self.draw_beforehand(context)
        layout = self.layout
        layout.prop(self, "format")
        if self.format == "PDF":
            layout.prop(self, "paper")
            if self.paper == "ROLL":
                self.draw_lengths(context, "roll_width")
            layout.prop(self, "proof_sheet")
        elif self.format == "SVG":
            layout.prop(self, "preset")
        elif self.format == "DXF":
            layout.prop(self, "dialect")
            if self.dialect != "PLAIN":
                layout.prop(self, "control_square")
        self.draw_lengths(context, "allowance", "notch_spacing")
        layout.prop(self, "darts")
        layout.column(align=True).prop(self, "drawn")
        if self.format != "PDF" or self.paper == ONE_PAGE:
            layout.prop(self, "keep_places")
        layout.prop(self, "failed_pieces")

    def choices(self) -> PatternChoices:
        return PatternChoices(self.allowance, self.notch_spacing, self.darts.lower())

    def made(self, context: bpy.types.Context, failed_too: bool) -> pattern.Pattern:
        made = self._pattern(context, failed_too).with_only(kind.lower().replace("_", " ") for kind in self.drawn)
        return made if self.keep_places else made.arranged()

    def write_options(self) -> dict[str, object]:
        if self.format == "PDF":
            return {"paper": self._paper(), "proof": self.proof_sheet}
        if self.format == "SVG":
            return {"preset": self.preset.lower()}
        if self.format == "DXF":
            has_square = self.control_square and self.dialect != "PLAIN"
            return {"dialect": self.dialect.lower(), "control_square": has_square}
        return {}

    def _paper(self) -> str | float:
        return self.roll_width if self.paper == "ROLL" else PAPERS[self.paper][0]

    def size_sentences(self, made: pattern.Pattern) -> list[str]:
        if self.format != "PDF":
            return size_sentences(made, made.size if self.format != "SVG" else made.svg_size)
        pages, count = made.page_sizes(self._paper()), counted(len(made.pieces), "piece")
        if self.paper.startswith("ROLL"):
            width, length = map(made.units.text, (pages[0][0], sum(page[1] for page in pages)))
            return [f"{count} on {length} of a roll of {width}, {counted(len(pages), 'page')}."]
        if self.paper == ONE_PAGE:
            return size_sentences(made, pages[0])
        proofs = " and a proof sheet" if self.proof_sheet else ""
        sheets = f"{counted(len(pages), 'sheet')} of {PAPERS[self.paper][1]}, one of them the map{proofs}"
        return [f"{count} on {sheets}.", largest_sentence(made)]


class OBJECT_OT_wirewarp_export_svg(PatternExport, bpy.types.Operator):
    """Write the flat pieces of the active object, as they lie, to an SVG file in true size"""

    bl_idname = "object.wirewarp_export_svg"
    bl_label = "Export Pattern as SVG"

    filename_ext = ".svg"
    filter_glob: StringProperty(description="The files shown", default="*.svg", options={"HIDDEN", "SKIP_SAVE"})

    def draw(self, context: bpy.types.Context) -> None:
        self.draw_beforehand(context)
        self.draw_lengths(context, "notch_spacing")
        self.layout.prop(self, "failed_pieces")

    def choices(self) -> PatternChoices:
        """Allowances only where they are marked, and darts as they are."""
        return PatternChoices(0.0, self.notch_spacing, "cut")

    def made(self, context: bpy.types.Context, failed_too: bool) -> pattern.Pattern:
        return self._pattern(context, failed_too)

    def write_options(self) -> dict[str, object]:
        return {}

    def size_sentences(self, made: pattern.Pattern) -> list[str]:
        return size_sentences(made, made.svg_size)


def _comparable(value: object) -> object:
    return frozenset(value) if isinstance(value, set) else value


def _source(context: bpy.types.Context) -> bpy.types.Object:
    return model_or_self(context.active_object)


def _has_others(context: bpy.types.Context) -> bool:
    """Whether pieces of other models are selected, too: each has a file of its own."""
    sources = {model_or_self(each) for each in context.selected_objects} - {_source(context)}
    return any(map(has_flat_object, sources))


def crossing_sentence(made: pattern.Pattern) -> str:
    """Empty where no pieces lie over one another."""
    names = pieces_over_others(made.pieces)
    if not names:
        return ""
    hidden = len(names) - SHOWN_NAMES
    shown = ", ".join(names[:SHOWN_NAMES]) + (f" and {hidden} more" if hidden > 0 else "")
    return f"These pieces lie over one another: {shown}. Move them apart before you cut."


def size_sentences(made: pattern.Pattern, size: np.ndarray) -> list[str]:
    return [f"{counted(len(made.pieces), 'piece')} on {_size_text(made, *size)}.", largest_sentence(made)]


def largest_sentence(made: pattern.Pattern) -> str:
    """By the area of its box: what a sheet must have room for."""
    largest = max(made.pieces, key=lambda piece: float(piece.size.prod()))
    return f"The largest, {largest.name}: {_size_text(made, *largest.size)}."


def _size_text(made: pattern.Pattern, width: float, height: float) -> str:
    """Of millimeters, in inches too for those who measure in them."""
    inches = f" ({width / INCH:.1f} × {height / INCH:.1f} in)" if made.units.name == "imperial" else ""
    return f"{width:.0f} × {height:.0f} mm{inches}"
