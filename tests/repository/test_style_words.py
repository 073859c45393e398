# SPDX-License-Identifier: GPL-3.0-or-later
"""Documents, comments, messages and the window use one word for one thing, and no old words."""

import io
import re
import tokenize
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PYTHON = ("addon", "bench", "blend_samples", "docs", "python", "results", "tests", "tools")
READ = (
    "*.md",
    *(f"{folder}/**/*.py" for folder in PYTHON),
    *(f"{folder}/**/*.{kind}" for folder in ("native", "tests") for kind in ("cpp", "h")),
    "docs/**/*.md",
    "*/README.md",
)
QUOTED = {"THIRD_PARTY.md", Path(__file__).name}  # licenses of others, and the words below
OLD_WORDS = {  # old words with their replacements
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
# Names of the API stay as they are: in code of documents and comments, and as strings of one lower-case word.
CODE_IN_MARKDOWN = re.compile(r"```.*?```|`[^`\n]*`", re.DOTALL)
NAME_AS_STRING = re.compile(r"\"(?:[a-z_0-9]+|[A-Z_0-9]+)\"|'(?:[a-z_0-9]+|[A-Z_0-9]+)'|\b\w+::\w+")
CPP_TEXT = re.compile(r'//[^\n]*|"(?:\\.|[^"\\\n])*"')


def read_by_people(file: Path) -> str:
    """Return the prose of a document, or the comments and texts of a source."""
    text = file.read_text()
    if file.suffix == ".md":
        return CODE_IN_MARKDOWN.sub("", text)
    return NAME_AS_STRING.sub("", python_text(text) if file.suffix == ".py" else "\n".join(CPP_TEXT.findall(text)))


def python_text(text: str) -> str:
    """Return the comments and strings of a Python source."""
    tokens = tokenize.generate_tokens(io.StringIO(text).readline)
    kinds = {tokenize.COMMENT, tokenize.STRING, getattr(tokenize, "FSTRING_MIDDLE", tokenize.STRING)}
    return "\n".join(token.string for token in tokens if token.type in kinds)


def old_words() -> dict[str, list[str]]:
    """Return the old words of each file."""
    files = sorted({file for pattern in READ for file in ROOT.glob(pattern) if file.name not in QUOTED})
    found = {file: sorted({match[0].lower() for match in PATTERN.finditer(read_by_people(file))}) for file in files}
    return {file.relative_to(ROOT).as_posix(): words for file, words in found.items() if words}


def test_no_file_has_old_words() -> None:
    assert old_words() == {}, OLD_WORDS


def test_names_of_the_api_are_not_old_words(tmp_path: Path) -> None:
    source = tmp_path / "source.cpp"
    source.write_text('// A twin, unlike DartProposal::twin.\nfield("twin");\n')
    assert PATTERN.findall(read_by_people(source)) != []
    assert "A twin, unlike" in read_by_people(source) and read_by_people(source).count("twin") == 1
