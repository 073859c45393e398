# SPDX-License-Identifier: GPL-3.0-or-later
"""Imports the packages in libraries/, which the core library needs.

The legacy add-on has this file as _core/__init__.py. For extensions, Blender installs these packages from wheels.
"""

import sys
from importlib import import_module
from pathlib import Path

_LIBRARIES = Path(__file__).parent / "libraries"
sys.path.append(str(_LIBRARIES))  # at the end, because other installed copies take precedence
try:
    for _package in sorted(_LIBRARIES.glob("*/__init__.py")):
        import_module(_package.parent.name)
finally:
    sys.path.remove(str(_LIBRARIES))
