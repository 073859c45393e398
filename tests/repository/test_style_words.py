# SPDX-License-Identifier: GPL-3.0-or-later
"""Documents, comments, messages and the window use one word for one thing, and no old words.

Files that still have old words are listed in old_words.txt. The list only becomes shorter. To write it again, for
example after files have moved, run python3 tests/repository/test_style_words.py.
"""

import io
import re
import tokenize
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
READ = ("*.md", "docs/**/*.md", "*/README.md", "addon/**/*.py", "python/**/*.py", "native/**/*.h", "native/**/*.cpp")
OLD_WORDS = {  # with their replacements
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
CODE_IN_MARKDOWN = re.compile(r"```.*?```|`[^`\n]*`", re.DOTALL)  # names of the API stay as they are
CPP_TEXT = re.compile(r'//[^\n]*|"(?:\\.|[^"\\\n])*"')
LIST = Path(__file__).with_name("old_words.txt")


def read_by_people(file: Path) -> str:
    """Return the prose of a document, or the comments and texts of a source."""
    text = file.read_text()
    if file.suffix == ".md":
        return CODE_IN_MARKDOWN.sub("", text)
    if file.suffix == ".py":
        tokens = tokenize.generate_tokens(io.StringIO(text).readline)
        kinds = {tokenize.COMMENT, tokenize.STRING, getattr(tokenize, "FSTRING_MIDDLE", tokenize.STRING)}
        return "\n".join(token.string for token in tokens if token.type in kinds)
    return "\n".join(CPP_TEXT.findall(text))


def old_words() -> dict[str, list[str]]:
    """Return the old words of each file."""
    files = sorted({file for pattern in READ for file in ROOT.glob(pattern)})
    found = {file: sorted({match[0].lower() for match in PATTERN.finditer(read_by_people(file))}) for file in files}
    return {file.relative_to(ROOT).as_posix(): words for file, words in found.items() if words}


def test_clean_files_stay_clean() -> None:
    listed = set(LIST.read_text().splitlines())
    found = old_words()
    assert {file: words for file, words in found.items() if file not in listed} == {}, OLD_WORDS
    assert listed - found.keys() == set(), "take them off the list"


if __name__ == "__main__":
    LIST.write_text("".join(f"{file}\n" for file in sorted(old_words())))
