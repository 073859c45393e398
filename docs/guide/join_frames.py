# SPDX-License-Identifier: GPL-3.0-or-later
"""Joins frames into a moving picture: join_frames.py FOLDER FILE.gif. Needs Pillow."""

import sys
from pathlib import Path

from PIL import Image

COLORS = 96  # keeps the file below 2 MB; the colors of stretch stay smooth
FRAME, LAST = 60, 2500  # display time of a frame, and of the last one, in milliseconds


def main() -> None:
    folder, target = map(Path, sys.argv[1:])
    frames = [Image.open(file).convert("RGB") for file in sorted(folder.glob("*.png"))]
    palette = frames[-1].quantize(COLORS, method=Image.Quantize.MEDIANCUT, kmeans=4)
    first, *others = [frame.quantize(palette=palette, dither=Image.Dither.NONE) for frame in frames]
    times = [FRAME] * len(others) + [LAST]
    first.save(target, save_all=True, append_images=others, duration=times, loop=0, optimize=True)
    print(f"{target.name}: {len(frames)} frames, {target.stat().st_size / 1e6:.2f} MB")


main()
