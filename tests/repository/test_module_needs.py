# SPDX-License-Identifier: GPL-3.0-or-later
"""Modules for other systems, which cannot be loaded here, are checked for symbols that these systems lack."""

import subprocess
from dataclasses import replace
from pathlib import Path

import pytest

from tools.cross import SYSTEMS, System, check_needs
from tools.environment import BUILD, StepError
from tools.zig import cache_variables, zig

LINUX, MACOS = (next(s for s in SYSTEMS if s.platform == name) for name in ("linux-arm64", "macos-arm64"))


def make_module(folder: Path, system: System, code: str) -> Path:
    """Compile a module from this C code, and link it without libraries."""
    source = folder / "module.c"
    source.write_text(code)
    module = source.with_suffix(".so")
    link = [zig(), "cc", "-target", system.target, "-O1", "-shared", "-nostdlib", "-undefined", "dynamic_lookup"]
    subprocess.run([*link, "-o", module, source], check=True, env=cache_variables(BUILD / "cross" / "zig"))
    return module


@pytest.mark.parametrize("system", [LINUX, MACOS], ids=lambda system: system.platform)
def test_a_symbol_that_neither_python_nor_a_library_has_is_named(tmp_path, system):
    code = "int PyOpen(void); int _PyOpen(void); int f(void) { return PyOpen() + _PyOpen(); }"
    check_needs(system, make_module(tmp_path, system, code))
    module = make_module(tmp_path, system, "int elsewhere(void); int f(void) { return elsewhere(); }")
    with pytest.raises(StepError, match=r"module\.so needs _?elsewhere, which no library has"):
        check_needs(system, module)


def test_a_module_for_another_processor_or_an_older_system_is_refused(tmp_path):
    module = make_module(tmp_path, MACOS, "int f(void) { return 0; }")
    with pytest.raises(StepError, match="is made for ARM64"):
        check_needs(replace(MACOS, platform="macos-x64"), module)
    with pytest.raises(StepError, match=r"needs macOS 11\.0"):
        check_needs(replace(MACOS, oldest="10.15"), module)


def test_a_file_that_is_not_a_module_is_refused(tmp_path):
    (tmp_path / "text.so").write_text("no module")
    with pytest.raises(StepError, match="is not a module of a known system"):
        check_needs(LINUX, tmp_path / "text.so")
