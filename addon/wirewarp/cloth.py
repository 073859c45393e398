# SPDX-License-Identifier: GPL-3.0-or-later
"""Pieces that keep their lengths but that hardly any cloth can follow. No Blender in here."""

import math

# Of the aspect ratio. A plain limit, not one of a certain cloth: by more than a quarter hardly any stretches or eases.
CLOTH_LIMIT = 1.25
# From which share on a dart is worth a thought: pieces are cut beyond it too, but no longer lie on the model without
# being pulled. A plain limit for cloth of which nothing is known; what gives more, like neoprene, needs no dart there.
STRAIN_LIMIT = 0.08
LESSER = 0.5  # of stretch and ease, the lesser is worth words from this share of the greater


def aspect_ratio(piece: dict) -> float:
    """Of the worst face of a piece with a layout: max(σ1, 1/σ2), inf for a face without area."""
    ratio = piece["aspect_ratio_max"]
    return math.inf if ratio is None else ratio


def is_strained(piece: dict) -> bool:
    """A good piece beyond what cloth can follow."""
    return piece["ok"] and aspect_ratio(piece) > CLOTH_LIMIT


def strained_pieces(report: dict) -> list[dict]:
    """Worst first."""
    beyond = [piece for piece in report["pieces"] if is_strained(piece)]
    return sorted(beyond, key=aspect_ratio, reverse=True)


def strain_text(name: str, piece: dict) -> str:
    """The sentence of one such piece, called by this name."""
    words = strain_words(largest(piece["stretch_max"]), largest(piece["ease_max"]))
    return f"Lengths kept, but {name} must {words}: a seam or a dart there would relieve it"


def ready_text(pieces: list[dict]) -> str:
    """The verdict on good pieces that are not beyond cloth: from which cloth they may be cut."""
    strain = max(largest(piece[name]) for piece in pieces for name in ("stretch_max", "ease_max"))
    return f"Ready to cut from cloth that gives {percent_text(strain)}" if strain > STRAIN_LIMIT else "Ready to cut"


def strain_words(stretch: float, ease: float) -> str:
    """What cloth must do, of shares of its flat length: "stretch up to 12 % and ease in up to 9 %"."""
    if math.isinf(stretch):
        return "stretch more than any cloth can"
    worth = _worth_words([("stretch", stretch), ("ease in", ease)])
    return " and ".join(f"{verb} up to {percent_text(share)}" for verb, share in worth)


def strain_figures(stretch: float, ease: float) -> str:
    """The same in short: "stretch 12 %, ease 9 %"."""
    worth = _worth_words([("stretch", stretch), ("ease", ease)])
    return ", ".join(f"{noun} {percent_text(share)}" for noun, share in worth)


def _worth_words(strains: list[tuple[str, float]]) -> list[tuple[str, float]]:
    """The greater, and the lesser where it is not much less."""
    greatest = max(share for _, share in strains)
    return [(word, share) for word, share in strains if share >= LESSER * greatest]


def percent_text(share: float) -> str:
    if math.isinf(share):
        return "beyond measure"
    return f"{100 * share:.0f} %" if share >= 0.0995 else f"{100 * share:.1f} %"


def largest(share: float | None) -> float:
    """A stretch or ease of the report, where JSON has no infinity."""
    return math.inf if share is None else share
