# SPDX-License-Identifier: GPL-3.0-or-later
"""Takes the pictures of the pages in docs/. The scripts in docs/guide/ use Blender's window on a virtual screen."""

import json
import shutil
from concurrent.futures import ThreadPoolExecutor
from functools import partial
from pathlib import Path

from tools.blender import BLENDER_APT, WINDOW_APT, blender, run_with_addon
from tools.blender_window import run_tours
from tools.environment import BUILD, DEBIAN_PYTHON, ROOT, StepError, require_apt, run, say, venv
from tools.package import BUILD_APT, package_legacy

PILLOW = "pillow==13.0.0"
GUIDE = ROOT / "docs" / "guide"  # the scripts and the pictures
SCRIPT = GUIDE / "take_pictures.py"
TOURS = (
    "mark",
    "flat",
    "report",
    "suggest",
    "tube",
    "contradiction",
    "pieces",
    "allowance",
    "pages",
    "ring_seams",
    "ring",
    "export",
)
SHEET, DOTS = 6, 60  # for the picture of a sheet: number of the page in the PDF, and dots per inch
DRAWN = {"pattern": 2600, "marker": 1100}  # width of each picture in pixels, by the name of its SVG file and style
# The picture of the pattern shows only this part: the left sleeve and the neck of the front. The numbers are its left,
# top, right and bottom edge in pixels.
PART = (970, 0, 1930, 1000)
AT_ONCE = 4  # number of Blenders at a time: several, because they mostly wait for their windows
SECONDS = 600.0  # limit for a busy machine; a tour takes about ten seconds on an idle machine


def take_tour(zip_file: Path, taken: Path, name: str) -> tuple[int, str]:
    say(f"taking pictures: {name}")
    display = 99 + 10 * TOURS.index(name)  # xvfb-run tries the next numbers if a screen is in use, so numbers have gaps
    return run_tours(SCRIPT, [name], taken, SECONDS, display, WIREWARP_ZIP=str(zip_file))


def pictures() -> None:
    """Take all pictures again. The old pictures are replaced when all new ones exist."""
    require_apt(*BUILD_APT, *BLENDER_APT, *WINDOW_APT, "librsvg2-bin", "poppler-utils")
    zip_file = package_legacy()
    taken = BUILD / "pictures"
    shutil.rmtree(taken, ignore_errors=True)
    taken.mkdir(parents=True)
    with ThreadPoolExecutor(AT_ONCE) as pool:  # each tour in its own Blender, because the window remembers open panels
        for name, (code, output) in zip(TOURS, pool.map(partial(take_tour, zip_file, taken), TOURS), strict=True):
            if code:
                print(output, flush=True)
                raise StepError(f"the tour {name} of {SCRIPT.name} failed; its last picture is in {taken}")
    for name, width in DRAWN.items():
        paper = ["--width", str(width), "--background-color", "white", "--stylesheet", str(GUIDE / f"{name}.css")]
        run(["rsvg-convert", *paper, taken / f"{name}.svg", "-o", taken / f"{name}.png"])
    run(blender("--python", GUIDE / "draw_lines.py", "--", taken / "lines.png"))
    (taken / "pattern.json").write_text(json.dumps(PART))
    shown = ["-png", "-singlefile", "-r", str(DOTS), "-f", str(SHEET), "-l", str(SHEET)]
    run(["pdftoppm", *shown, taken / "sheets.pdf", taken / "sheet"])
    python = venv("pictures", DEBIAN_PYTHON, PILLOW)
    run([python, GUIDE / "shrink_pictures.py", taken, GUIDE])
    drawn = BUILD / "drawn"
    shutil.rmtree(drawn, ignore_errors=True)
    run_with_addon("pictures", ROOT / "blend_samples" / "moving_picture.py", drawn)
    run([python, GUIDE / "shrink_pictures.py", drawn / "stills", ROOT / "docs" / "gallery"])
    run([python, GUIDE / "join_frames.py", drawn / "frames", ROOT / "docs" / "unfold.gif"])
