# SPDX-License-Identifier: GPL-3.0-or-later
"""If the library is missing, foreign or broken, the add-on can be registered and removed, and says what to do."""

import platform
import re
import shutil
import sys
from pathlib import Path
from types import SimpleNamespace
from unittest.mock import MagicMock

import bpy
import pytest
from flattening import flatten_fails
from surfaces import bump, grid


def panel_text():
    layout, preferences = MagicMock(), SimpleNamespace(system=SimpleNamespace(ui_scale=1.0))
    context = SimpleNamespace(region=SimpleNamespace(width=300), preferences=preferences)
    bpy.types.VIEW3D_PT_wirewarp_problem.draw(SimpleNamespace(layout=layout), context)
    return " ".join(call.kwargs["text"] for call in layout.column.return_value.label.call_args_list)


@pytest.fixture
def library_copy(addon, tmp_path, monkeypatch):
    """Yield the folder of a copy of the library. When the add-on registers again, it uses this copy."""
    installed = Path(addon.core.library().__file__).parent
    name = addon.core.library().__name__
    copy = tmp_path / "wirewarp"
    shutil.copytree(installed, copy, ignore=shutil.ignore_patterns("__pycache__"))
    loaded = {key: sys.modules[key] for key in list(sys.modules) if key == name or key.startswith(f"{name}.")}
    for key in loaded:
        del sys.modules[key]
    with monkeypatch.context() as patch:
        patch.setattr(addon.core, "_INSIDE", "no such folder")
        patch.syspath_prepend(tmp_path)
        yield copy
    for key in [key for key in sys.modules if key == "wirewarp" or key.startswith("wirewarp.")]:
        del sys.modules[key]
    sys.modules.update(loaded)
    addon.register()


def module_in(folder):
    return next(file for file in folder.glob("_wirewarp.*") if file.suffix != ".pyi")


def check_sentence(addon, sentence):
    """Register the add-on again, and check that the panel and the error of Flatten contain the sentence.

    No other panel and no other operator may be registered. sentence: a regular expression.
    """
    addon.unregister()
    addon.register()
    assert re.search(sentence, panel_text())
    grid("Bump", bump)
    flatten_fails(sentence)
    assert not hasattr(bpy.types.Scene, "wirewarp")
    assert [name for name in dir(bpy.types) if "wirewarp" in name and hasattr(bpy.types, name)] == [
        "OBJECT_OT_wirewarp_flatten",
        "VIEW3D_PT_wirewarp_problem",
    ]
    addon.unregister()
    assert not hasattr(bpy.types, "OBJECT_OT_wirewarp_flatten")


def test_no_library(addon, library_copy, monkeypatch):
    shutil.rmtree(library_copy)
    # Without the copy, the extension's own library would be found on the path.
    monkeypatch.setattr(sys, "path", [folder for folder in sys.path if not Path(folder, "wirewarp").is_dir()])
    check_sentence(addon, "library is not installed beside the add-on. Remove WireWarp, restart Blender, and install")


@pytest.mark.parametrize(
    ("suffix", "made_for"),
    [
        (".cpython-39-x86_64-linux-gnu.so", "Python 3.9 on Linux on x86-64"),
        (".cp39-win_amd64.pyd", "Python 3.9 on Windows on x86-64"),
        (".cpython-27-amiga.so", "Python 2.7 on amiga"),
    ],
)
def test_a_library_for_another_python_or_system(addon, library_copy, suffix, made_for):
    module = module_in(library_copy)
    module.rename(module.with_name(f"_wirewarp{suffix}"))
    here = f"this Blender has Python 3.{sys.version_info.minor} on {platform.system()}"
    check_sentence(addon, rf"is for {made_for}, but {here}\. Remove WireWarp")


SPOILED = {  # content of the library's __init__.py, and the resulting sentence
    "another version": ('__version__ = "99.0.0"\n', r"but the library found is 99\.0\.0\. Remove WireWarp"),
    "another package": ("", "the library found is of an unknown version. Remove WireWarp"),
    "breaks down": (
        'raise RuntimeError("compiled for another numpy")\n',
        r"does not load \(RuntimeError: compiled for another numpy\): it may be damaged\. Remove",
    ),
    "another Mac": (
        "raise ImportError(\"dlopen(_wirewarp.so): mach-o, but is an incompatible architecture (need 'arm64')\")\n",
        "is for Macs with another kind of processor. Remove WireWarp",
    ),
    "no numpy": (
        'raise ModuleNotFoundError("No module named \'numpy\'", name="numpy")\n',
        "Python has no numpy, which WireWarp needs: install it .* python3-numpy",
    ),
}


@pytest.mark.parametrize("case", SPOILED)
def test_a_library_that_cannot_be_used(addon, library_copy, capfd, case):
    content, sentence = SPOILED[case]
    (library_copy / "__init__.py").write_text(content)
    check_sentence(addon, sentence)
    if content.startswith("raise"):
        assert content.strip() in capfd.readouterr().err  # The console shows the cause.


@pytest.mark.parametrize("content", [b"", b"\x7fELF", b"not a library " * 1000])
def test_a_damaged_library(addon, library_copy, content):
    module_in(library_copy).write_bytes(content)
    check_sentence(addon, r"library does not load \(.+\): it may be damaged\. Remove WireWarp")


@pytest.mark.skipif(sys.platform != "linux", reason="libraries of this system do not require a version of glibc")
def test_a_library_for_a_newer_system(addon, library_copy):
    module = module_in(library_copy)
    content, count = re.subn(rb"GLIBC_2\.\d\d\0", b"GLIBC_2.99\0", module.read_bytes())
    assert count
    module.write_bytes(content)
    check_sentence(addon, r"needs the C library glibc 2\.99 or newer, and this system has 2\.\d+\. Use a newer Linux")
