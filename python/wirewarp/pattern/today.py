# SPDX-License-Identifier: GPL-3.0-or-later
"""The date on patterns."""

import datetime
import os


def today() -> datetime.date:
    """Or the day of SOURCE_DATE_EPOCH (reproducible-builds.org), where files are to be the same again."""
    epoch = os.environ.get("SOURCE_DATE_EPOCH")
    return datetime.datetime.fromtimestamp(int(epoch), datetime.UTC).date() if epoch else datetime.date.today()
