# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the sample surfaces as plain arrays. Needs only numpy, so that tests can use them without Blender."""

from __future__ import annotations

from .armchair import armchair_cover
from .collar import wetsuit_collar
from .cushion import cushion
from .developable import half_cylinder, lampshade
from .hat import hat
from .jeans import jeans
from .mask import mask
from .set_in_sleeve import set_in_sleeve
from .shape import ALLOWANCE, FAIRNESS, Ease, Shape, ShapeBuilder, Wire, chain_of
from .skirt import gathered_skirt
from .spheres import ball, quarter_sphere
from .swimsuit import swimsuit
from .top import fitted_top
from .toy import toy
from .wetsuit import wetsuit_upper_body

__all__ = [
    "ALLOWANCE", "FAIRNESS", "Ease", "Shape", "ShapeBuilder", "Wire", "all_shapes", "armchair_cover", "ball",
    "chain_of", "cushion", "fitted_top", "gathered_skirt", "half_cylinder", "hat", "jeans", "lampshade", "mask",
    "quarter_sphere", "set_in_sleeve", "swimsuit", "toy", "wetsuit_collar", "wetsuit_upper_body",
]  # fmt: skip


def all_shapes() -> list[Shape]:
    """Return every sample, in the order of the demo."""
    return [
        fitted_top(), quarter_sphere(), ball(), half_cylinder(), lampshade(), cushion(), hat(), mask(),
        jeans(), wetsuit_collar(), wetsuit_upper_body(), toy(), armchair_cover(), swimsuit(), set_in_sleeve(),
        gathered_skirt(),
    ]  # fmt: skip
