# SPDX-License-Identifier: GPL-3.0-or-later
"""How each kind of line looks. People with any color vision tell the colors apart, on gray and on the color maps.

No Blender in here.
"""

from dataclasses import dataclass


@dataclass(frozen=True)
class LineStyle:
    label: str
    color: tuple[float, float, float]  # as the screen shows it, sRGB
    width: float  # pixels at interface scale 1
    dash: tuple[float, float] | None = None  # lengths of dash and gap in pixels; in the gaps the line is thin

    @property
    def line_width(self) -> float:
        """Of the line that goes through."""
        return THIN if self.dash else self.width

    @property
    def rim(self) -> tuple[float, float, float]:
        """Of a line below it that is a little wider: light around dark colors and dark around light ones."""
        red, green, blue = self.color
        return (1.0, 1.0, 1.0) if 0.2126 * red + 0.7152 * green + 0.0722 * blue < 0.4 else (0.0, 0.0, 0.0)


def _hex(text: str) -> tuple[float, float, float]:
    red, green, blue = (int(text[k : k + 2], 16) / 255 for k in (1, 3, 5))
    return red, green, blue


THIN = 1.0  # pixels
RIM, RIM_ALPHA = 1.5, 0.6  # of the rim: pixels wider than the line

# In the order in which they are drawn: a wire on a seam or in what failed is seen on top of it.
STYLES = {
    "failed": LineStyle("Failed", _hex("#d8001f"), 4.0),
    "helper": LineStyle("Helper wire, added", _hex("#ffffff"), 1.5),
    "proposed": LineStyle("Proposed seam", _hex("#890089"), 6.0),
    "outline": LineStyle("Outline", _hex("#786068"), 2.5),
    "seam": LineStyle("Seam", _hex("#101018"), 4.5),
    "free": LineStyle("Free wire", _hex("#4fc3f7"), 3.5, dash=(4, 8)),
    "elastic": LineStyle("Elastic wire", _hex("#ffc400"), 3.5, dash=(14, 7)),
    "rigid": LineStyle("Rigid wire", _hex("#0048e8"), 2.5),
    "selected": LineStyle("Selected", _hex("#ffffff"), 1.2),
}
CORES = {"selected"}  # drawn on one of the others, which is seen on both sides
