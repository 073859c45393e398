# SPDX-License-Identifier: GPL-3.0-or-later
"""Pieces that keep their lengths but that hardly any cloth can follow. No Blender in here."""

import math

# Of the aspect ratio. A plain limit, not one of a certain cloth: by more than a quarter hardly any stretches or eases.
CLOTH_LIMIT = 1.25


def aspect_ratio(piece: dict) -> float:
    """Of the worst face of a piece with a layout: max(σ1, 1/σ2), inf for a face without area."""
    ratio = piece["aspect_ratio_max"]
    return math.inf if ratio is None else ratio


def strained_pieces(report: dict) -> list[dict]:
    """The good pieces beyond what cloth can follow, worst first."""
    beyond = [piece for piece in report["pieces"] if piece["ok"] and aspect_ratio(piece) > CLOTH_LIMIT]
    return sorted(beyond, key=aspect_ratio, reverse=True)


def strain_text(name: str, piece: dict) -> str:
    """The sentence of one such piece, called by this name."""
    return f"Lengths kept, but {name} must stretch or ease {_amount(piece)}: a seam or a dart there would relieve it"


def _amount(piece: dict) -> str:
    strain = aspect_ratio(piece) - 1
    return "more than any cloth can" if math.isinf(strain) else f"by up to {100 * strain:.0f} %"
