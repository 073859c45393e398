# SPDX-License-Identifier: GPL-3.0-or-later
"""Texts for users have short sentences. Documents, comments, messages and the window use one word for one thing."""

import ast
import io
import re
import tokenize
from collections.abc import Iterator
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]

MOST_WORDS = 25
PAGES = ("README.md", "docs/**/*.md")
# These pages for researchers are written by programs that measure.
GENERATED = {"results.md", "benchmarks.md", "cuts.md"}
CODE = re.compile(r"```.*?```", re.DOTALL)
PICTURE = re.compile(r"!\[[^]]*\]\([^)]*\)")
LINK = re.compile(r"\[([^]]*)\]\([^)]*\)")
NAME_IN_CODE = re.compile(r"`[^`\n]*`")
# Matches ends of paragraphs, items and cells.
BLOCK = re.compile(r"\n\s*\n|\n(?=\s*(?:[-*>|#]|\d+\.)\s)|(?<=\|)|^#.*$", re.MULTILINE)
END = re.compile(r"(?:[.!?]\)?\**|:\**$)\s+(?=[\W\d_]*[A-Z0-9`])|:\s*$")

PYTHON = ("addon", "bench", "blend_samples", "docs", "python", "results", "tests", "tools")
READ = (
    "*.md",
    *(f"{folder}/**/*.py" for folder in PYTHON),
    *(f"{folder}/**/*.{kind}" for folder in ("native", "tests") for kind in ("cpp", "h")),
    "docs/**/*.md",
    "*/README.md",
)
QUOTED = {"THIRD_PARTY.md", Path(__file__).name}  # licenses of others, and the words below
OLD_WORDS = {
    "promis(e|es|ed|ing)": "guarantee",
    "aims?": "target",
    "tells?|told": "report, name, show",
    "twins?": "mirrored pair, mirror image",
    "mend(s|ed|ing)?": "fix",
    "spares?": "save, protect",
    "turn(s|ed)? over": "flipped",
    "covers? itself": "overlaps itself",
    "middle (front|back)": "center front, center back",
    "biceps line": "upper-arm line",
    "true size": "actual size",
    "lines? to cut": "cutting line",
    "sew lines?": "stitching line",
    "barred": "forbidden",
    "settled": "fixed",
    "wish(es|ed)?": "options",
    "first cuts": "cut set",
    "(is|are) no (wire|seam|edge|piece|hole|line|face|dart)s?": "is not a wire",
    "that (is|are) none|be it|whoever|upon|amid|anyhow": "plain words",
    ", for (it|they|there)": "because",
    "serves?|seeks?|sought|hand(s|ed)? over|looks? to|gives? way|stands? (beside|still|for)": "a plain verb",
    "so (many|much) (times|of|longer|more)": "the comparison in full",
    "likewise|shall|be they|for want of|in peace|to speak of|as many again": "plain words",
}
PATTERN = re.compile(rf"(?:\b|(?=, ))(?:{'|'.join(OLD_WORDS)})\b", re.IGNORECASE)
# These matches may have old words, because they are names of the API: code in documents, strings of one word in one
# case, and names with ::.
CODE_IN_MARKDOWN = re.compile(r"```.*?```|`[^`\n]*`", re.DOTALL)
NAME_AS_STRING = re.compile(r"\"(?:[a-z_0-9]+|[A-Z_0-9]+)\"|'(?:[a-z_0-9]+|[A-Z_0-9]+)'|\b\w+::\w+")
CPP_TEXT = re.compile(r'//[^\n]*|"(?:\\.|[^"\\\n])*"')

PERCENT_IN = ("README.md", "CHANGELOG.md", "docs/**/*.md", "addon/**/*.py", "python/**/*.py", "native/src/**/*.cpp")
# Matches a number or placeholder, a space and a percent sign. If an operand follows, the sign is an operator.
APART = re.compile(r"[0-9}] %(?! ?[\w(])")
TARGET = re.compile(r"\]\((?!https?:)([^)#]+)")


def sentences(text: str) -> Iterator[str]:
    yield from (sentence for sentence in END.split(" ".join(text.split())) if sentence)


def page_sentences(page: Path) -> Iterator[str]:
    text = NAME_IN_CODE.sub("X", LINK.sub(r"\1", PICTURE.sub("", CODE.sub("", page.read_text()))))
    for block in BLOCK.split(text):
        yield from sentences(block.strip("|> "))


def window_texts(source: Path) -> Iterator[str]:
    """Yield the texts of a file that users may read: all texts except docstrings, and docstrings that are tooltips."""
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


def read_by_people(file: Path) -> str:
    """Return the prose of a document, or the comments and texts of a source."""
    text = file.read_text()
    if file.suffix == ".md":
        return CODE_IN_MARKDOWN.sub("", text)
    return NAME_AS_STRING.sub("", python_text(text) if file.suffix == ".py" else "\n".join(CPP_TEXT.findall(text)))


def python_text(text: str) -> str:
    tokens = tokenize.generate_tokens(io.StringIO(text).readline)
    kinds = {tokenize.COMMENT, tokenize.STRING, getattr(tokenize, "FSTRING_MIDDLE", tokenize.STRING)}
    return "\n".join(token.string for token in tokens if token.type in kinds)


def test_no_file_has_old_words() -> None:
    files = sorted({file for pattern in READ for file in ROOT.glob(pattern) if file.name not in QUOTED})
    found = {file: sorted({match[0].lower() for match in PATTERN.finditer(read_by_people(file))}) for file in files}
    assert {file.relative_to(ROOT).as_posix(): words for file, words in found.items() if words} == {}, OLD_WORDS


def test_names_of_the_api_are_not_old_words(tmp_path: Path) -> None:
    source = tmp_path / "source.cpp"
    source.write_text('// A twin, unlike DartProposal::twin.\nfield("twin");\n')
    assert [match[0] for match in PATTERN.finditer(read_by_people(source))] == ["twin"]


def test_links_of_documents_lead_somewhere():
    documents = [file for pattern in ("*.md", "addon/*.md", "native/*.md") for file in ROOT.glob(pattern)]
    links = [(file, link) for file in documents for link in TARGET.findall(file.read_text())]
    assert len(links) > 20
    assert [(file.name, link) for file, link in links if not (file.parent / link).exists()] == []


def test_percent_signs_follow_their_numbers():
    files = [file for pattern in PERCENT_IN for file in ROOT.glob(pattern)]
    assert len(files) > 100
    lines = [(file.name, line) for file in files for line in file.read_text().splitlines() if "//" not in line]
    assert [each for each in lines if APART.search(each[1])] == []
