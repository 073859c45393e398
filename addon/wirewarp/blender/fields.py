# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes fields of settings and operators with the options that most of them share."""

from typing import Any

from bpy.props import FloatProperty


def number(name: str, description: str, values: tuple[float, ...], **others: Any) -> Any:  # noqa: ANN401
    """Return a number with one decimal. values: minimum, default, end of the slider, and maximum if any."""
    known = dict(zip(("min", "default", "soft_max", "max"), values, strict=False))
    return FloatProperty(**{"name": name, "description": description, "precision": 1} | known | others)


def in_percent(field: str) -> dict[str, Any]:
    """Return arguments of a property that shows another field, a fraction, in percent."""
    return {
        "subtype": "PERCENTAGE",
        "precision": 2,
        "get": lambda operator: 100 * getattr(operator, field),
        "set": lambda operator, percent: setattr(operator, field, percent / 100),
        "options": {"SKIP_SAVE"},
    }
