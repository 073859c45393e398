# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes reports of samples, as python -m wirewarp does."""

from samples import SAMPLES, eases_of, flatten, flattened_with_eases, wires_of
from wirewarp.report import Report, make_report


def report_of(name: str, cloth=None, **options) -> Report:
    shape = SAMPLES[name]
    eases = eases_of(shape)
    result = flatten(shape, eases=eases, cloth=cloth) if cloth else flattened_with_eases(name)
    mesh = (shape.vertices, shape.triangles())
    return make_report(result, *mesh, wires=wires_of(shape), eases=eases, name=name, cloth=cloth, **options)
