# SPDX-License-Identifier: GPL-3.0-or-later
"""The add-on in Blender's real window on a virtual screen. Each tour of tours.py runs in a Blender of its own."""

import os
from pathlib import Path

import pytest

from tools.blender_window import run_tour

TOURS = Path(__file__).with_name("tours.py")
SECONDS = 400.0  # for a slow machine; a tour takes about ten


def blender_environment(folder: Path) -> dict[str, str]:
    """Private and empty places for add-ons, settings and pictures."""
    parts = {"BLENDER_USER_SCRIPTS": "scripts", "BLENDER_USER_CONFIG": "config", "WIREWARP_PICTURES": "pictures"}
    for part in parts.values():
        (folder / part).mkdir()
    return dict(os.environ) | {name: str(folder / part) for name, part in parts.items()}


@pytest.mark.parametrize(
    "name",
    [
        "panel_button",
        "one_undo_step",
        "one_undo_step_in_edit_mode",
        "auto_update",
        "report_shows_the_place",
        "copies_the_report",
    ],
)
def test_window(name, tmp_path):
    code, output = run_tour(TOURS, name, blender_environment(tmp_path), SECONDS)
    assert code == 0, output
