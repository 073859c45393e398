# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs python -m wirewarp with the command flatten MODEL... --out DIR, batch IN... --out DIR, or propose MODEL..."""

import os
import sys


def main() -> int:
    try:
        from .command.arguments import parsed
        from .command.run import PrintError, run
    except ModuleNotFoundError as error:
        print(f"The command needs {error.name}, which is missing: pip install wirewarp[command]", file=sys.stderr)
        return 2
    arguments = parsed(sys.argv[1:])
    try:
        return run(arguments)
    except KeyboardInterrupt:
        print("stopped", file=sys.stderr)
        return 130
    except PrintError as error:
        print(error, file=sys.stderr)
        # Otherwise, Python would fail again when it closes the streams.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return 2


if __name__ == "__main__":
    sys.exit(main())
