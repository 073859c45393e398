# SPDX-License-Identifier: GPL-3.0-or-later
"""Operators of File > Export, which write the pattern to a file to print, plot or cut."""

from pathlib import Path
from typing import Any

import bpy
from bpy.props import BoolProperty, EnumProperty, IntProperty, StringProperty

from ..core import counted, listed, pattern
from ..properties import PatternSettings, take_settings
from .export import GRAINS, Cloth, ExportChoices, library_paper
from .steps import PatternExport, largest_sentence, size_sentences

FORMATS = {suffix[1:].upper(): each for suffix, each in pattern.FORMATS.items()}
DRAWN = [  # the library's kinds, in upper case and with underscores
    ("SEW", "Stitching Lines", "Where to sew, inside the cutting line"),
    ("WIRES", "Wires", "The wires inside pieces"),
    ("GRAIN", "Grain", "An arrow along the grain"),
    ("NOTCHES", "Notches", "Notches, clips and holes to drill"),
    ("TEXTS", "Texts", "Name and number of the piece, and how many to cut"),
    ("LINE_NAMES", "Line Names", "Numbers of seams, which are the same on both sides, and names of wires"),
]
PROPERTIES = {"proof": "proof_sheet"}  # names of operator properties by option, if they differ
ALL_DRAWN = {kind for kind, _, _ in DRAWN}
ALL_KINDS = frozenset(kind.lower().replace("_", " ") for kind in ALL_DRAWN)


class OBJECT_OT_wirewarp_export(PatternExport, PatternSettings, bpy.types.Operator):
    """Write the flat pieces of the active object in actual size and with seam allowances, to print, plot or cut"""

    bl_idname = "object.wirewarp_export"
    bl_label = "Export Pattern"

    filter_glob: StringProperty(
        description="Files to show",
        default=";".join(f"*{suffix}" for suffix in pattern.FORMATS),
        options={"HIDDEN", "SKIP_SAVE"},
    )
    format: EnumProperty(
        name="Format",
        description="File format. If a script does not set it, the file extension determines it",
        items=[(key, each.label, each.description) for key, each in FORMATS.items()],
    )
    drawn: EnumProperty(
        name="Drawn",
        description="Lines and texts to draw besides the cutting lines",
        items=DRAWN,
        options={"ENUM_FLAG"},
        default=ALL_DRAWN,
    )

    seconds: IntProperty(
        name="Search Time (s)",
        description="Seconds to search for a marker that needs less fabric. Esc cancels the export",
        min=0,
        max=3600,
        soft_max=120,
        default=10,
    )
    new_marker: BoolProperty(
        name="Search Again",
        description="Search for a new marker even if the last marker fits these pieces and this fabric",
        options={"SKIP_SAVE"},
    )

    @property
    def filename_ext(self) -> str:
        return f".{self.format.lower()}"

    def invoke(self, context: bpy.types.Context, event: bpy.types.Event) -> set[str]:
        take_settings(self, context.scene.wirewarp, PatternSettings)
        return super().invoke(context, event)

    def execute(self, context: bpy.types.Context) -> set[str]:
        # First use abspath, because on Windows, Path reads a path that begins with // as the name of a server.
        ending = Path(bpy.path.abspath(self.filepath)).suffix[1:].upper()
        if not self.properties.is_property_set("format") and ending in FORMATS:
            self.format = ending
        if self._has_dialog:
            for name in PatternSettings.__annotations__:
                setattr(context.scene.wirewarp, name, getattr(self, name))
        return super().execute(context)

    def draw(self, context: bpy.types.Context) -> None:
        self.draw_beforehand(context)
        layout = self.layout
        layout.prop(self, "format")
        chosen = FORMATS[self.format]
        if chosen.has_pages and self.arrangement != "MARKER":
            layout.prop(self, "paper")
            if self.paper == "ROLL":
                self.draw_lengths(context, "roll_width")
        for option in chosen.options:
            if not (option.unless and self._chosen(option.unless[0]) == option.unless[1]):
                layout.prop(self, _property_name(option.name))
        layout.prop(self, "arrangement")
        if self.arrangement == "MARKER":
            self.draw_lengths(context, "cloth_width", "gap")
            for name in ("grain", "seconds", "new_marker"):
                layout.prop(self, name)
        self.draw_lengths(context, "allowance", "notch_spacing")
        layout.prop(self, "pairs")
        layout.prop(self, "on_fold")
        layout.prop(self, "darts")
        layout.column(align=True).prop(self, "drawn")
        layout.prop(self, "failed_pieces")

    def choices(self) -> ExportChoices:
        drawn = frozenset(kind.lower().replace("_", " ") for kind in self.drawn)
        return ExportChoices(
            {
                "allowance": self.allowance,
                "notch_spacing": self.notch_spacing,
                "darts": self.darts.lower(),
                "pairs": self.pairs,
                "on_fold": self.on_fold,
            },
            drawn,
            self._write_options(),
            in_rows=self.arrangement == "IN_ROWS",
            cloth=Cloth(self.cloth_width, self.gap, GRAINS[self.grain]) if self.arrangement == "MARKER" else None,
            seconds=float(self.seconds),
            anew=self.new_marker,
        )

    def _write_options(self) -> dict[str, Any]:
        chosen = FORMATS[self.format]
        options: dict[str, Any] = {option.name: self._chosen(option.name) for option in chosen.options}
        if chosen.has_pages:
            # A marker is printed on a roll of its own width.
            paper = None if self.arrangement == "MARKER" else library_paper(self.paper, self.roll_width)
            options |= {"paper": paper, "keep_places": self.arrangement == "AS_LAID_OUT"}
        return options

    def _chosen(self, name: str) -> str | bool:
        value = getattr(self, _property_name(name))
        return value.lower() if isinstance(value, str) else value

    def size_sentences(self, made: pattern.Pattern) -> list[str]:
        if made.marker:
            return [f"{made.marker.sentence(made.units)}.", largest_sentence(made)]
        if not FORMATS[self.format].has_pages:
            return size_sentences(made, FORMATS[self.format].size_of(made))
        pages, count = made.page_sizes(**self._write_options() | {"proof": False}), counted(len(made.pieces), "piece")
        paper = library_paper(self.paper, self.roll_width)
        if pattern.roll_width(paper):
            width, length = map(made.units.text, (pages[0][0], sum(page[1] for page in pages)))
            return [f"{count} on {length} of a roll of {width}, {counted(len(pages), 'page')}."]
        if len(pages) == 1:
            return size_sentences(made, pages[0])
        what, total = ["a map", f"{counted(len(pages) - 1, 'sheet')} of the pattern"], len(pages)
        if self.proof_sheet:
            total = len(made.page_sizes(**self._write_options() | {"proof": True}))
            what.append(counted(total - len(pages), "proof sheet"))
        sheets = f"{total} sheets of {pattern.PAPERS[str(paper)].label}: {listed(what)}"
        return [f"{count} on {sheets}.", largest_sentence(made)]


def _property_name(option: str) -> str:
    return PROPERTIES.get(option, option)


def _option_property(option: pattern.Option) -> Any:  # noqa: ANN401
    if not option.choices:
        return BoolProperty(name=option.label, description=option.description, default=False)
    items = [(choice.value.upper(), choice.label, choice.description) for choice in option.choices]
    return EnumProperty(name=option.label, description=option.description, items=items)


OBJECT_OT_wirewarp_export.__annotations__ |= {
    _property_name(option.name): _option_property(option) for each in FORMATS.values() for option in each.options
}


class OBJECT_OT_wirewarp_export_svg(PatternExport, bpy.types.Operator):
    """Write the flat pieces of the active object in their places to an SVG file in actual size"""

    bl_idname = "object.wirewarp_export_svg"
    bl_label = "Export Pattern as SVG"

    filename_ext = ".svg"
    filter_glob: StringProperty(description="Files to show", default="*.svg", options={"HIDDEN", "SKIP_SAVE"})

    def draw(self, context: bpy.types.Context) -> None:
        self.draw_beforehand(context)
        self.draw_lengths(context, "notch_spacing")
        self.layout.prop(self, "failed_pieces")

    def choices(self) -> ExportChoices:
        """Return choices with allowances only at marked edges. Darts are cut out."""
        return ExportChoices(
            {"allowance": 0.0, "notch_spacing": self.notch_spacing, "darts": "cut"}, ALL_KINDS, in_rows=False
        )

    def size_sentences(self, made: pattern.Pattern) -> list[str]:
        return size_sentences(made, made.svg_size)
