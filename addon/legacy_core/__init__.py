# SPDX-License-Identifier: GPL-3.0-or-later
"""The core library in the legacy add-on, as _core, with the packages that it needs in libraries/.

Extensions do not need this, because Blender installs wheels for them.
"""

import sys
from importlib import import_module
from pathlib import Path

_LIBRARIES = Path(__file__).parent / "libraries"
sys.path.append(str(_LIBRARIES))  # at the end, so that other installed copies take precedence
try:
    for _package in sorted(_LIBRARIES.glob("*/__init__.py")):
        import_module(_package.parent.name)
finally:
    sys.path.remove(str(_LIBRARIES))
