# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes docs/results.md and its pictures: the paper's section IV on our own geometry, and more comparisons.

python results/write_page.py UNWRAPS WORN ERROR_CURVES [--output FILE]

UNWRAPS is the output of unwrap_in_blender.py. WORN is the output of wear_in_newton.py. ERROR_CURVES is the program
built from native/bench/error_curves.
"""

from __future__ import annotations

import argparse
import json
import os
import re
from pathlib import Path

os.environ["IGL_NUM_THREADS"] = os.environ["OMP_NUM_THREADS"] = "1"  # so that sums are reproducible

import all_samples  # noqa: E402 (modules read the number of threads when they are loaded)
import beyond_the_paper  # noqa: E402
import cloths  # noqa: E402
import ease_and_stretch  # noqa: E402
import elastic_seams  # noqa: E402
import figure_1  # noqa: E402
import figure_3  # noqa: E402
import figure_6  # noqa: E402
import figure_8  # noqa: E402
import figure_9  # noqa: E402
import figure_11  # noqa: E402
import numpy as np  # noqa: E402
from inputs import Inputs  # noqa: E402
from methods import METHODS  # noqa: E402
from palette import use_style  # noqa: E402
from shapes import all_shapes  # noqa: E402
from text import wrap  # noqa: E402
from which_commit import commit  # noqa: E402

ROOT = Path(__file__).resolve().parent.parent
PAPER = [figure_1, figure_3, figure_6, figure_8, figure_9, figure_11]
SECTIONS = [*PAPER, beyond_the_paper, cloths, elastic_seams, ease_and_stretch, all_samples]


def contents(sections: list[str]) -> str:
    """Return a list of links to the headings of the sections."""
    headings = [section.partition("\n")[0].removeprefix("## ") for section in sections]
    anchors = [re.sub(r"[^a-z0-9 -]", "", heading.lower()).replace(" ", "-") for heading in headings]
    return "\n".join(f"- [{heading}](#{anchor})" for heading, anchor in zip(headings, anchors, strict=True))


def opening(version: str, sections: list[str]) -> str:
    return f"""# Results

`./dev results` writes this page with all its numbers and pictures. Commit: {version}.

This page repeats the examples of "WireWarping++" (Zhang, Wang), section IV, on our own geometry
(`blend_samples/shapes/`). It compares these methods: {", ".join(METHODS)}. The
same code measures the results of all methods: `wirewarp.measure`.

{contents(sections)}

**Measures.** *E* is the ARAP energy of Eq. (4), divided by the area of the surface. *E_A* is the energy of a triangle,
Eq. (6), divided by the area of the triangle. *E* is therefore the mean of *E_A*, and neither depends on the mesh size.
*E_r* is the larger of a triangle's largest stretch and its largest compression, as a ratio. It is 1 only without
distortion. Means are over the area. Length changes refer to whole wires and to sections of outline between junctions.

**Differences from the paper.** Our angles are the local minimum of Eq. (1) that the search reaches from the surface
angles. The paper stops at the first angles that close all loops. The weight of a node follows from the length of wire
around it. The gradient of *E* with respect to *h* is exact. Flipped triangles are reported. "Refined" is not in the
paper: see [Beyond the paper](#beyond-the-paper).

A separate page, not written by `./dev results`, compares [cuts with those of OptCuts](cuts.md) on its benchmark.
"""


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("unwraps", type=Path)
    parser.add_argument("worn", type=Path)
    parser.add_argument("error_curves", type=Path)
    parser.add_argument("--output", type=Path, default=ROOT / "docs" / "results.md")
    arguments = parser.parse_args()

    version = commit()  # read first, because new pages and pictures would mark the commit as changed
    use_style()
    pictures = arguments.output.with_suffix("")
    pictures.mkdir(parents=True, exist_ok=True)
    inputs = Inputs(
        shapes={shape.name: shape for shape in all_shapes()},
        unwraps=dict(np.load(arguments.unwraps)),
        worn=json.loads(arguments.worn.read_text()),
        error_curves=arguments.error_curves,
        pictures=pictures,
    )
    sections = [module.section(inputs) for module in SECTIONS]
    page = wrap("\n".join([opening(version, sections), *sections]))
    arguments.output.write_text(page.rstrip() + "\n", encoding="utf-8")
    print(f"wrote {arguments.output}")


if __name__ == "__main__":
    main()
