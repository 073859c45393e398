# SPDX-License-Identifier: GPL-3.0-or-later
"""The library's words for counts, names, tolerances, lengths and areas."""

from .core import LengthText as LengthText
from .core import counted as counted
from .core import ease_text as ease_text
from .core import paragraph as paragraph
from .core import quoted as quoted
from .core import tolerance_text as tolerance_text
from .core import wire_text as wire_text
