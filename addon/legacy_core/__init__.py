# SPDX-License-Identifier: GPL-3.0-or-later
"""In the legacy add-on alone, as _core: the core library, and in libraries/ the packages that it needs.

Extensions need nothing like it: for these Blender installs wheels.
"""

import sys
from importlib import import_module
from pathlib import Path

_LIBRARIES = Path(__file__).parent / "libraries"
sys.path.append(str(_LIBRARIES))  # the last place: what Python finds elsewhere comes from there
try:
    for _package in sorted(_LIBRARIES.glob("*/__init__.py")):
        import_module(_package.parent.name)
finally:
    sys.path.remove(str(_LIBRARIES))
