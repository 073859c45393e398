# SPDX-License-Identifier: GPL-3.0-or-later
"""Raises ImportError if the compiled module does not fit this Python or system. The package imports this file first."""

import sys
import sysconfig
from importlib.util import find_spec

if find_spec(f"{__package__}._wirewarp") is None:
    raise ImportError(
        f"this copy of wirewarp does not fit Python {sys.version_info.major}."
        f"{sys.version_info.minor} on {sysconfig.get_platform()}. Run this Python with -m pip install wirewarp"
    )
