# SPDX-License-Identifier: GPL-3.0-or-later
"""Texts for users follow the same style."""

import re
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
READ = ("README.md", "CHANGELOG.md", "docs/**/*.md", "addon/**/*.py", "python/**/*.py", "native/src/**/*.cpp")
# A number or placeholder before a percent sign, unless an operand follows it as in a remainder.
APART = re.compile(r"[0-9}] %(?! ?[\w(])")


LINK = re.compile(r"\]\((?!https?:)([^)#]+)")


def test_links_of_documents_lead_somewhere():
    documents = [file for pattern in ("*.md", "addon/*.md", "native/*.md") for file in ROOT.glob(pattern)]
    links = [(file, link) for file in documents for link in LINK.findall(file.read_text())]
    assert len(links) > 20
    assert [(file.name, link) for file, link in links if not (file.parent / link).exists()] == []


def test_the_readme_opens_with_what_it_is_and_the_two_commands():
    lines = (ROOT / "README.md").read_text().splitlines()
    first_screen = "\n".join(lines[:25])
    assert "./dev demo" in first_screen and "./dev test" in first_screen
    assert first_screen.index("![") < first_screen.index("./dev demo")  # a maker sees the picture first


def test_percent_signs_follow_their_numbers():
    files = [file for pattern in READ for file in ROOT.glob(pattern)]
    assert len(files) > 100
    lines = [(file.name, line) for file in files for line in file.read_text().splitlines() if "//" not in line]
    assert [each for each in lines if APART.search(each[1])] == []
