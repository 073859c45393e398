# SPDX-License-Identifier: GPL-3.0-or-later
"""A module linked against an old glibc is refused if it needs a newer glibc, although it would load here."""

import subprocess
import zipfile
from pathlib import Path

import pytest

from tools.environment import StepError
from tools.old_glibc import check_symbols


def make_wheel(folder: Path, code: str) -> Path:
    """Make a wheel with a module of this C code. The module is linked without libraries, so symbols have no version."""
    source = folder / "module.c"
    source.write_text(code)
    module = source.with_suffix(".so")
    subprocess.run(["gcc", "-shared", "-fPIC", "-nostdlib", "-o", module, source], check=True)
    with zipfile.ZipFile(folder / "any.whl", "w") as wheel:
        wheel.write(module, "wirewarp/module.so")
    return folder / "any.whl"


def test_a_symbol_that_no_library_has_is_named(tmp_path):
    wheel = make_wheel(tmp_path, "int arc4random(void); int f(void) { return arc4random(); }")
    with pytest.raises(StepError, match=r"any\.whl needs symbols that glibc 2\.\d+ lacks: arc4random"):
        check_symbols(wheel)


def test_symbols_of_python_and_weak_symbols_may_be_undefined(tmp_path):
    declared = "int PyOpen(void); int _PyOpen(void); __attribute__((weak)) int hook(void);"
    code = f"{declared} int f(void) {{ return PyOpen() + _PyOpen() + (hook ? hook() : 0); }}"
    check_symbols(make_wheel(tmp_path, code))
