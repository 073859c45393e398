# SPDX-License-Identifier: GPL-3.0-or-later
"""Sentences that users read have at most 25 words: on pages written by hand, and in the programs."""

import ast
import re
from collections.abc import Iterator
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
MOST_WORDS = 25
PAGES = ("README.md", "docs/**/*.md")
# Pages written by programs that measure; their readers are researchers.
GENERATED = {"results.md", "benchmarks.md", "cuts.md"}
CODE = re.compile(r"```.*?```", re.DOTALL)
PICTURE = re.compile(r"!\[[^]]*\]\([^)]*\)")
LINK = re.compile(r"\[([^]]*)\]\([^)]*\)")
NAME_IN_CODE = re.compile(r"`[^`\n]*`")
# ends of paragraphs, items and cells
BLOCK = re.compile(r"\n\s*\n|\n(?=\s*(?:[-*>|#]|\d+\.)\s)|(?<=\|)|^#.*$", re.MULTILINE)
END = re.compile(r"(?:[.!?]\)?\**|:\**$)\s+(?=[\W\d_]*[A-Z0-9`])|:\s*$")


def sentences(text: str) -> Iterator[str]:
    """Yield the sentences of a paragraph; code and links count as one word."""
    yield from (sentence for sentence in END.split(" ".join(text.split())) if sentence)


def page_sentences(page: Path) -> Iterator[str]:
    text = NAME_IN_CODE.sub("X", LINK.sub(r"\1", PICTURE.sub("", CODE.sub("", page.read_text()))))
    for block in BLOCK.split(text):
        yield from sentences(block.strip("|> "))


def window_texts(source: Path) -> Iterator[str]:
    """Yield the texts of a file that users may read: all but docstrings, and the docstrings that are tooltips."""
    tree = ast.parse(source.read_text())
    documented = [each for each in ast.walk(tree) if isinstance(each, ast.Module | ast.ClassDef | ast.FunctionDef)]
    silent = {id(each.body[0].value) for each in documented if each.body and isinstance(each.body[0], ast.Expr)}
    for each in documented:
        if isinstance(each, ast.ClassDef) and "_OT_" in each.name:
            yield ast.get_docstring(each) or ""
    for each in ast.walk(tree):
        if isinstance(each, ast.JoinedStr):
            silent |= {id(value) for value in each.values}
            yield "".join(value.value if isinstance(value, ast.Constant) else "X" for value in each.values)
    for each in ast.walk(tree):
        if isinstance(each, ast.Constant) and isinstance(each.value, str) and id(each) not in silent:
            yield each.value


def long_ones(all_sentences: Iterator[str]) -> list[str]:
    return [sentence for sentence in all_sentences if len(sentence.split()) > MOST_WORDS]


def test_sentences_are_counted_as_a_reader_counts_them():
    assert list(sentences("Press **Flatten**. The [pieces] appear. 3 pieces: left, right.")) == [
        "Press **Flatten**",
        "The [pieces] appear",
        "3 pieces: left, right.",
    ]
    assert long_ones(sentences("Word " + "word " * 25)) != []
    assert long_ones(sentences("Word " + "word " * 23 + "word. Word " + "word " * 24)) == []


def test_pages_have_short_sentences():
    pages = [page for pattern in PAGES for page in ROOT.glob(pattern) if page.name not in GENERATED]
    assert len(pages) > 15
    found = {page.relative_to(ROOT).as_posix(): long_ones(page_sentences(page)) for page in pages}
    assert {name: long for name, long in found.items() if long} == {}


def test_the_add_on_and_the_command_line_have_short_sentences():
    sources = sorted(source for folder in ("addon", "python") for source in (ROOT / folder).rglob("*.py"))
    texts = {
        source.relative_to(ROOT).as_posix(): [text for text in window_texts(source) if len(text.split()) > 3]
        for source in sources
    }
    assert sum(map(len, texts.values())) > 300
    found = {name: [s for text in each for s in long_ones(sentences(text))] for name, each in texts.items()}
    assert {name: long for name, long in found.items() if long} == {}
