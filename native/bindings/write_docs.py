# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the comments of the public headers as a C++ table, from which the Python module takes its docstrings.

Usage: python write_docs.py OUTPUT HEADER...

Keys are "Struct", "Struct.field" and "Enum.0", "Enum.1", ...
"""

import re
import sys
from collections.abc import Iterator
from pathlib import Path

OPENING = re.compile(r"(?:struct|class|enum class) (\w+)(?: final)?(?: : [^{]*)? \{")
FIELD = re.compile(r"  (?!static )[\w:<>, ]+ (\w+)(?: = [^;]*|\{\})?;(?: +// (.*))?")
ENUMERATOR = re.compile(r"  (\w+),(?: +// (.*))?")
LAST_ITEM = re.compile(r"^- .*(?:\n  .*)*\Z", re.MULTILINE)


def comments(header: str) -> Iterator[tuple[str, str]]:
    """Yield (name, comment) of each struct, enum, field and enumerator with a comment.

    The comment is the `///` comment above, or the `//` comment after a field or enumerator and its continuation.
    """
    above, owner, last, is_enum, count = [], "", "", False, 0
    found: dict[str, list[str]] = {}
    for line in header.splitlines():
        if match := re.fullmatch(r" *///(?: (.*))?", line):
            above.append(match[1] or "")
            continue
        if match := re.fullmatch(r" +// (.*)", line):
            if last:
                found[last].append(match[1])
            continue
        last = ""
        if match := OPENING.fullmatch(line):
            owner, is_enum, count = match[1], line.startswith("enum"), 0
            found[owner] = above
        elif owner and (match := (ENUMERATOR if is_enum else FIELD).fullmatch(line)):
            last = f"{owner}.{count if is_enum else match[1]}"
            found[last] = above + [match[2]] * bool(match[2])
            count += 1
        elif line == "};":
            owner = ""
        above = []
    for name, lines in found.items():
        if text := "\n".join(lines).strip():
            yield name, text


def sentence(text: str) -> str:
    """Return the text in Python's style: members with a dot, a capital letter at the start unless the first word is a
    symbol, and a final period unless the text ends in a list, because the other items have none.
    """
    text = text.replace("::", ".")
    if re.match(r"[a-z]{2}|a ", text):
        text = text[0].upper() + text[1:]
    return text if text.endswith(".") or LAST_ITEM.search(text) else text + "."


def main() -> None:
    output, *headers = map(Path, sys.argv[1:])
    rows = [entry for header in headers for entry in comments(header.read_text())]
    lines = [f'    {{"{name}", R"doc({sentence(text)})doc"}},' for name, text in rows]
    text = "\n".join(["// Made by write_docs.py.", "constexpr Doc kDocs[] = {", *lines, "};", ""])
    # An unchanged file is not written, because all sources that include it would be compiled again.
    if not (output.is_file() and output.read_text() == text):
        output.write_text(text)


if __name__ == "__main__":
    main()
