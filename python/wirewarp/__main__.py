# SPDX-License-Identifier: GPL-3.0-or-later
"""python -m wirewarp flatten MODEL... --out DIR"""

import sys

from .command.arguments import parsed
from .command.flatten import flatten_models

if __name__ == "__main__":
    sys.exit(flatten_models(parsed(sys.argv[1:])))
