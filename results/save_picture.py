# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes a figure as a small PNG, with the same bytes in every run."""

from __future__ import annotations

from io import BytesIO
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.figure import Figure
from PIL import Image

COLORS = 256  # the maximum for a PNG with a palette


def save(figure: Figure, path: Path) -> None:
    """Save the figure with only its COLORS most frequent colors, and close it.

    Other colors, which occur at borders of lines and letters, are replaced by the nearest of the frequent colors.
    """
    raw = BytesIO()
    figure.savefig(raw, format="png", metadata={"Software": None})
    plt.close(figure)
    pixels = np.asarray(Image.open(raw).convert("RGB"))
    colors, of_pixel, count = np.unique(pixels.reshape(-1, 3), axis=0, return_inverse=True, return_counts=True)
    palette = colors[np.argsort(-count, kind="stable")[:COLORS]]
    distance = ((colors[:, None, :].astype(np.int32) - palette) ** 2).sum(axis=2)
    image = Image.fromarray(distance.argmin(axis=1).astype(np.uint8)[of_pixel].reshape(pixels.shape[:2]), mode="P")
    image.putpalette(palette.tobytes())
    image.save(path, optimize=True)
