# SPDX-License-Identifier: GPL-3.0-or-later
"""Imported first, to raise ImportError if the compiled module does not fit this Python or system."""

import sys
import sysconfig
from importlib.util import find_spec

if find_spec(f"{__package__}._wirewarp") is None:
    raise ImportError(
        f"this copy of wirewarp is made for another Python or system than this Python {sys.version_info.major}."
        f"{sys.version_info.minor} on {sysconfig.get_platform()}. Install the wheel for it with its own pip"
    )
