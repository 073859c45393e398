# SPDX-License-Identifier: GPL-3.0-or-later
"""Starts Debian's Blender with its window on a private virtual screen, and runs the tours of a script in it."""

import os
import signal
import subprocess
from collections.abc import Sequence
from pathlib import Path

from tools.blender import blender_folder
from tools.environment import clean_environment

SCREEN = "-screen 0 1600x900x24 +extension GLX +render -noreset"
DRIVER = Path(__file__).resolve().parent.parent / "tests" / "window"
DRIVE = f"import sys; sys.path.insert(0, {str(DRIVER)!r}); import drive; drive.main()"


def run_tours(
    script: Path, names: Sequence[str], pictures: Path, seconds: float, display: int = 99, **settings: str
) -> tuple[int, str]:
    """Run tours in the window. Return the exit code (-9 if the tours take longer than `seconds`) and the output.

    names: generator functions of `script`
    pictures: existing folder for pictures
    display: number of the first virtual screen to try, different for tours that start at the same time
    settings: more environment variables:

    - WIREWARP_ZIP: the zip to install; unnecessary if it is in the caller's environment
    - WIREWARP_VIEWPORT_AA: Blender's setting for smooth edges in the view, by default "8"
    """
    settings |= blender_folder(f"tours-{script.stem}-{names[0]}") | {"WIREWARP_PICTURES": str(pictures)}
    blender = ["/usr/bin/blender", "--factory-startup", "--no-window-focus"]
    blender += ["--window-geometry", "0", "0", "1600", "900", "--enable-event-simulate"]
    blender += ["--python-exit-code", "1", "--python-expr", DRIVE]
    command = ["/usr/bin/xvfb-run", "-a", "-n", str(display), "-s", SCREEN, *blender, "--", str(script), *names]
    started = subprocess.Popen(
        command,
        env=clean_environment(**settings, LIBGL_ALWAYS_SOFTWARE="1"),
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        errors="replace",
        start_new_session=True,
    )
    try:
        output, _ = started.communicate(timeout=seconds)
    except subprocess.TimeoutExpired:
        os.killpg(started.pid, signal.SIGKILL)
        output, _ = started.communicate()
        output += f"\nstopped after {seconds:.0f} s"
    return started.returncode, output
