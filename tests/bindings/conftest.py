# SPDX-License-Identifier: GPL-3.0-or-later
"""Random arguments are the same in every run, so that only a change of the code can cause a failure.

`./dev fuzz` tries other arguments, and prints a decorator, @reproduce_failure, that repeats a failure.
"""

import signal
import sys
from pathlib import Path

import pytest
from hypothesis import settings
from wirewarp.pattern.label import fonts, glyphs

# The folder is added for drawing.py. It is last, because both folders have a file surfaces.py.
sys.path.append(str(Path(__file__).resolve().parents[1] / "addon"))

settings.register_profile("repeatable", max_examples=150, derandomize=True, deadline=None)
settings.register_profile("search", max_examples=3_000, deadline=None, database=None, print_blob=True)
settings.load_profile("repeatable")  # the option --hypothesis-profile selects another profile


@pytest.fixture
def model(tmp_path):
    from commands import FOLDED  # the import skips the test if trimesh is missing

    path = tmp_path / "Folded.obj"
    path.write_text(FOLDED)
    return path


@pytest.fixture
def python_handles_ctrl_c():
    """Enable Ctrl-C, which processes in the background ignore."""
    handler = signal.signal(signal.SIGINT, signal.default_int_handler)
    yield
    signal.signal(signal.SIGINT, handler)


@pytest.fixture
def no_fonts(monkeypatch):
    """Hide the fonts of this machine, so that a test draws the same letters everywhere."""

    def forget():
        for cached in (fonts.font_with, fonts._font, fonts._files, glyphs.line_of):
            cached.cache_clear()

    monkeypatch.setattr(fonts, "_folders", [])
    monkeypatch.setattr(fonts, "_system_folders", lambda: [])
    forget()
    yield
    forget()
