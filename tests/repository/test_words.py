# SPDX-License-Identifier: GPL-3.0-or-later
"""What users read is written in one way."""

import re
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
READ = ("README.md", "CHANGELOG.md", "docs/*.md", "addon/**/*.py", "python/**/*.py", "native/src/**/*.cpp")
# A number, or what is filled in for one, and a percent sign that no operand follows: that would be a remainder.
APART = re.compile(r"[0-9}] %(?! ?[\w(])")


def test_percent_stands_at_its_number():
    files = [file for pattern in READ for file in ROOT.glob(pattern)]
    assert len(files) > 100
    lines = [(file.name, line) for file in files for line in file.read_text().splitlines() if "//" not in line]
    assert [each for each in lines if APART.search(each[1])] == []
