# SPDX-License-Identifier: GPL-3.0-or-later
"""Reports of samples, like those of the command line."""

from samples import SAMPLES
from wirewarp import Ease, Options, Wire, flatten
from wirewarp.report import Report, make_report


def report_of(name: str, **options) -> Report:
    shape = SAMPLES[name]
    vertices, faces = shape.vertices, shape.triangles()
    wires = [Wire(wire.vertices, wire.tolerance, wire.name) for wire in shape.wires]
    eases = [Ease(ease.half_edges, ease.ratio) for ease in shape.eases]
    cloth = options.get("cloth")
    result = flatten(vertices, faces, seams=shape.seams, wires=wires, eases=eases, options=Options(cloth=cloth))
    return make_report(result, vertices, faces, wires=wires, eases=eases, name=name, **options)
