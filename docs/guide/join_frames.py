# SPDX-License-Identifier: GPL-3.0-or-later
"""Joins frames into a moving picture: join_frames.py FOLDER FILE.gif. Needs Pillow."""

import sys
from pathlib import Path

from PIL import Image

COLORS = 96  # few enough for a file below 2 MB, and enough for smooth colors of stretch
FRAME, LAST = 60, 2500  # milliseconds for which a frame is shown, and for which the last frame is shown


def main() -> None:
    folder, target = map(Path, sys.argv[1:])
    frames = [Image.open(file).convert("RGB") for file in sorted(folder.glob("*.png"))]
    palette = frames[-1].quantize(COLORS, method=Image.Quantize.MEDIANCUT, kmeans=4)
    first, *others = [frame.quantize(palette=palette, dither=Image.Dither.NONE) for frame in frames]
    times = [FRAME] * len(others) + [LAST]
    first.save(target, save_all=True, append_images=others, duration=times, loop=0, optimize=True)
    print(f"{target.name}: {len(frames)} frames, {target.stat().st_size / 1e6:.2f} MB")


main()
