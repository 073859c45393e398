# SPDX-License-Identifier: GPL-3.0-or-later
"""If a copy of the package is for another Python or system, its import says so in one sentence."""

import shutil
import subprocess
import sys
from pathlib import Path

import wirewarp


def test_a_copy_for_another_python_says_so(tmp_path):
    copy = tmp_path / "wirewarp"
    shutil.copytree(Path(wirewarp.__file__).parent, copy)
    (module,) = (file for file in copy.glob("_wirewarp.*") if file.suffix in (".so", ".pyd"))
    module.rename(copy / "_wirewarp.cp27-amiga.so")
    code = f"import sys; sys.path.insert(0, {str(tmp_path)!r}); import wirewarp"
    said = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, stdin=subprocess.DEVNULL).stderr
    here = f"Python {sys.version_info.major}.{sys.version_info.minor}"
    assert f"ImportError: this copy of wirewarp does not fit {here} on" in said
